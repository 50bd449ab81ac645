//! Scenes from files, and the checks and defaults that all of them share.

use std::path::Path;
use std::sync::Arc;

use glam::{DVec3, Vec3};
use voxlume_fault::{Fault, Faults, Source, one_of};

use crate::{Camera, Scene, gltf, ron};

impl Scene {
    /// Reads a scene from a `.ron`, `.gltf` or `.glb` file.
    ///
    /// # Errors
    /// Every fault of the file: it is missing, truncated or of another kind; it names a file that is; a
    /// number is not finite or out of its range; an index is out of range; it would take more than
    /// [`MEMORY_LIMIT`](crate::MEMORY_LIMIT) or reach beyond [`WORLD_LIMIT`](crate::WORLD_LIMIT). [`crate::ron`] and
    /// [`crate::gltf`] say what is read.
    pub fn load(path: &Path) -> Result<Scene, Faults> {
        let extension = path.extension().unwrap_or_default().to_string_lossy().to_lowercase();
        let mut scene = match extension.as_str() {
            "ron" => ron::read(&Source::read(path)?, path)?,
            "gltf" | "glb" => {
                let mut scene = gltf::load(path)?;
                gltf::light_if_dark(&mut scene);
                scene
            }
            _ => {
                let fault = Fault::new(format!("`{}` is not a scene file by its extension", path.display()));
                return Err(fault.note(one_of(["ron", "gltf", "glb"])).into());
            }
        };
        finish(&mut scene).map_err(|fault| in_file(path, fault))?;
        Ok(scene)
    }

    /// Reads a scene from a RON text; files that it names are looked for beside `source`'s name.
    ///
    /// # Errors
    /// As [`Scene::load`].
    pub fn parse(source: &Arc<Source>) -> Result<Scene, Faults> {
        let mut scene = ron::read(source, Path::new(&source.name))?;
        finish(&mut scene).map_err(|fault| in_file(Path::new(&source.name), fault))?;
        Ok(scene)
    }
}

/// The file's stem.
pub(crate) fn stem(path: &Path) -> String {
    path.file_stem().unwrap_or_default().to_string_lossy().into_owned()
}

/// A fault of a whole file, which has no place in a text.
pub(crate) fn in_file(path: &Path, fault: Fault) -> Fault {
    Fault { message: format!("`{}`: {}", path.display(), fault.message), ..fault }
}

fn finish(scene: &mut Scene) -> Result<(), Fault> {
    scene.within_limits()?;
    if scene.cameras.is_empty() {
        scene.cameras.push(framing_camera(scene.reach()));
    }
    scene.set_time(0.0);
    Ok(())
}

/// A three-quarter view of the whole scene from the front, right and above, 45° high.
fn framing_camera(bounds: Option<(DVec3, DVec3)>) -> Camera {
    let (low, high) = bounds.unwrap_or((DVec3::splat(-1.0), DVec3::ONE));
    let centre = low.midpoint(high);
    let radius = (high - low).length() / 2.0;
    let vertical_fov = std::f32::consts::FRAC_PI_4;
    // The distance at which the bounding sphere touches the view's edges; a point has none.
    let distance = if radius > 0.0 { radius / f64::from(vertical_fov / 2.0).sin() } else { 1.0 };
    let towards = DVec3::new(1.0, 0.75, 1.5).normalize();
    let forward = -towards.as_vec3();
    Camera {
        name: "default".into(),
        eye: centre + towards * distance,
        forward,
        up: Vec3::Y.reject_from_normalized(forward).normalize(),
        vertical_fov,
    }
}
