//! Scenes from files, and the checks and defaults that all of them share.

use std::path::Path;
use std::sync::Arc;

use glam::{DVec3, Vec3};
use voxlume_fault::{Fault, Faults, Source, one_of};

use crate::limit::{Budget, TRIANGLE_BYTES, VERTEX_BYTES};
use crate::{Camera, Scene, gltf, ron};

/// How far from the world's origin anything may reach: beyond it, squares of lengths leave `f32`.
pub const WORLD_LIMIT: f64 = 1e15;

impl Scene {
    /// Reads a scene from a `.ron`, `.gltf` or `.glb` file.
    ///
    /// # Errors
    /// Every fault of the file: it is missing, truncated or of another kind; it names a file that is; a
    /// number is not finite or out of its range; an index is out of range; it would take more than
    /// [`MEMORY_LIMIT`](crate::MEMORY_LIMIT) or reach beyond [`WORLD_LIMIT`]. [`crate::ron`] and
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
        finish(&mut scene).map_err(|fault| Fault::new(format!("`{}`: {}", path.display(), fault.message)))?;
        Ok(scene)
    }

    /// Reads a scene from a RON text; files that it names are looked for beside `source`'s name.
    ///
    /// # Errors
    /// As [`Scene::load`].
    pub fn parse(source: &Arc<Source>) -> Result<Scene, Faults> {
        let mut scene = ron::read(source, Path::new(&source.name))?;
        finish(&mut scene).map_err(|fault| Fault::new(format!("`{}`: {}", source.name, fault.message)))?;
        Ok(scene)
    }
}

/// The file's stem.
pub(crate) fn stem(path: &Path) -> String {
    path.file_stem().unwrap_or_default().to_string_lossy().into_owned()
}

fn finish(scene: &mut Scene) -> Result<(), Fault> {
    let mut budget = Budget::new();
    for texture in &scene.textures {
        budget.take(texture.rgba.len() as u64, 1)?;
    }
    for instance in &scene.instances {
        let mesh = &scene.meshes[instance.mesh];
        budget.take(mesh.positions.len() as u64, VERTEX_BYTES)?;
        budget.take(mesh.triangles.len() as u64, TRIANGLE_BYTES)?;
        // Entries that large could cancel each other's overflow into a NaN.
        let wild = instance.transform.to_cols_array().iter().any(|entry| entry.abs() > 1e100);
        if wild || instance.bounds(mesh).is_some_and(beyond) {
            return Err(Fault::new(format!("`{}` reaches beyond {WORLD_LIMIT:e} units", instance.name)));
        }
    }
    for moved in &scene.animation.instances {
        let instance = &scene.instances[moved.index];
        let wild =
            moved.path.keys.iter().any(|key| key.scale.max(key.translation).abs().max_element() > 1e100);
        if wild || moved.reach(instance, &scene.meshes[instance.mesh]).is_some_and(beyond) {
            let name = &instance.name;
            return Err(Fault::new(format!("the path of `{name}` reaches beyond {WORLD_LIMIT:e} units")));
        }
    }
    if scene.cameras.is_empty() {
        scene.cameras.push(framing_camera(scene.reach()));
    }
    scene.set_time(0.0);
    Ok(())
}

fn beyond((low, high): (DVec3, DVec3)) -> bool {
    let inside = |corner: DVec3| corner.abs().max_element() <= WORLD_LIMIT;
    !(inside(low) && inside(high))
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
