//! A grid on a device that holds given voxels in a format.

use bytemuck::{Pod, Zeroable};
use glam::{DVec3, DVec4, UVec3};
use voxlume::twin::{Texels, Volumes};
use voxlume::{
    Camera, Choices, Encoding, Gpu, Library, Numbers, Passes, ProbeSize, Renderer, Scene, StorageFormat,
    probe,
};

use crate::substrate::{Substrate, surface};
use crate::{Content, Error};

/// Most samples of a run.
const SAMPLES: u32 = 8192;

/// Where and from where a volume is seen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Probe {
    /// In `[0, 1]³`.
    pub uvw: DVec3,
    /// 0 is finest.
    pub level: f64,
    /// Unit direction of travel: away from the observer.
    pub direction: DVec3,
}

impl Probe {
    /// The middle of a cell of a level.
    pub fn at(cell: UVec3, level: u32, side: u32, direction: DVec3) -> Probe {
        let size = f64::from(side >> level);
        Probe { uvw: (cell.as_dvec3() + 0.5) / size, level: f64::from(level), direction }
    }
}

#[repr(C)]
#[derive(Clone, Copy, Pod, Zeroable)]
struct ProbeBytes {
    uvw: [f32; 3],
    level: f32,
    direction: [f32; 3],
    padding: f32,
}

/// A grid of `side³` voxels on a device.
#[derive(Debug)]
pub struct Bench<'g> {
    renderer: Renderer<'g>,
    camera: Camera,
    /// What the volumes are like, empty.
    empty: Volumes,
    /// How numbers are stored.
    pub encoding: Encoding,
}

impl<'g> Bench<'g> {
    /// Compiles the format's shaders.
    ///
    /// # Errors
    /// The shaders are at fault, or the device fails.
    pub fn new(
        gpu: &'g Gpu,
        format: &dyn StorageFormat,
        choices: &Choices,
        library: &Library,
        encoding: Encoding,
        side: u32,
    ) -> Result<Bench<'g>, Error> {
        let voxels = u64::from(side).pow(3);
        // All levels of a full grid: less than 8/7 of level 0, and one.
        let (cells, filters_float32) = (voxels * 8 / 7 + 1, gpu.filters_float32());
        let size = ProbeSize { side, voxels, cells, samples: SAMPLES, filters_float32 };
        let renderer =
            Renderer::new(gpu, probe(format, choices, encoding, library, size)?, &Scene::default())?;
        let camera = Camera {
            name: String::new(),
            eye: DVec3::ZERO,
            forward: -glam::Vec3::Z,
            up: glam::Vec3::Y,
            vertical_fov: 1.0,
        };
        Ok(Bench { renderer, camera, empty: Volumes::new(&format.volumes(choices), side), encoding })
    }

    /// Voxels along each side.
    pub fn side(&self) -> u32 {
        self.empty.side
    }

    /// Levels of the grid.
    pub fn levels(&self) -> u32 {
        self.empty.levels()
    }

    /// Stores, filters and samples voxels: premultiplied radiance and opacity of each probe.
    ///
    /// # Errors
    /// The device fails.
    pub fn run(&mut self, content: &Content, probes: &[Probe]) -> Result<Vec<DVec4>, Error> {
        let substrate = Substrate::new(content);
        let renderer = &mut self.renderer;
        renderer.clear_volumes()?;
        for (name, words) in [
            ("occupancy", &substrate.occupancy),
            ("ranks", &substrate.ranks),
            ("cells", &substrate.cells),
            ("levels", &substrate.levels),
            ("attributes", &substrate.attributes),
        ] {
            renderer.write_buffer(name, bytemuck::cast_slice(words))?;
        }
        renderer.write_buffer("radiance", bytemuck::cast_slice(&substrate.radiance))?;
        let mut values = Vec::new();
        for chunk in probes.chunks(SAMPLES as usize).chain(probes.is_empty().then_some(probes)) {
            let bytes: Vec<ProbeBytes> = chunk
                .iter()
                .map(|probe| ProbeBytes {
                    uvw: probe.uvw.as_vec3().to_array(),
                    level: probe.level as f32,
                    direction: probe.direction.as_vec3().to_array(),
                    padding: 0.0,
                })
                .collect();
            renderer.write_buffer("probes", bytemuck::cast_slice(&bytes))?;
            renderer.render(&Scene::default(), &self.camera, Passes::All)?;
            let read = renderer.buffer("probed")?.unwrap_or_default();
            let value = |bytes: &[u8]| {
                let word = |i: usize| f32::from_le_bytes(std::array::from_fn(|byte| bytes[4 * i + byte]));
                DVec4::from_array(std::array::from_fn(|i| f64::from(word(i))))
            };
            values.extend(read.chunks_exact(16).take(chunk.len()).map(value));
        }
        Ok(values)
    }

    /// The volumes as the last run, of this content, left them.
    ///
    /// # Errors
    /// The device fails.
    pub fn volumes(&self, content: &Content) -> Result<Volumes, Error> {
        let mut all = self.empty.clone();
        for (volume, mips) in &mut all.volumes {
            let read = self.renderer.volume(volume.name)?;
            *mips = read
                .into_iter()
                .map(|level| Texels {
                    size: UVec3::from_array(level.size),
                    values: level.values.into_iter().map(|v| DVec4::from_array(v.map(f64::from))).collect(),
                })
                .collect();
        }
        let side = self.side();
        for voxel in &content.voxels {
            let index = (voxel.cell.z * side + voxel.cell.y) * side + voxel.cell.x;
            all.surfaces[index as usize] = Some(surface(voxel));
        }
        Ok(all)
    }

    /// What the volumes hold.
    pub fn numbers(&self) -> impl Iterator<Item = Numbers> {
        self.empty.volumes.iter().map(|(volume, _)| volume.numbers)
    }

    /// Volumes of zeroes.
    pub fn empty(&self) -> Volumes {
        self.empty.clone()
    }
}
