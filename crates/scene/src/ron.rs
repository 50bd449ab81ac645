//! Scenes written in RON.
//!
#![doc = concat!("```ron\n", include_str!("ron/example.ron"), "```")]
//!
//! Every field is optional unless it is called needed. Lengths are in world units, angles in degrees where
//! the name ends in `_deg`. A colour is `(r, g, b)` or one number for all three, linear. Numbers must be
//! finite.
//!
//! # `materials`, by name
//! | field | default | meaning |
//! |---|---|---|
//! | `base_color` | 0.8 | reflectance, each part in `[0, 1]`; `(r, g, b, a)` has alpha too |
//! | `metallic` | 0 | 0 dielectric, 1 metal |
//! | `roughness` | 1 | perceptual, in `[0, 1]` |
//! | `emission` | 0 | emitted radiance, W·m⁻²·sr⁻¹ |
//! | `alpha_cutoff` | | lower alpha is a hole |
//! | `double_sided` | false | else the camera looks through the back |
//!
//! # `objects`
//! Each has either a `shape` with its `material` (needed), or `gltf`, a path relative to the RON file (`..`
//! is allowed), from which meshes, materials and node transforms are taken, but neither lights nor cameras;
//! `material` then replaces all of its materials.
//!
//! | field | default | meaning |
//! |---|---|---|
//! | `name` | `object N` | for messages |
//! | `scale` | 1 | a number or `(x, y, z)`, applied first; negative mirrors |
//! | `rotate_deg` | (0, 0, 0) | then turned about the world's x, then y, then z axis |
//! | `translate` | (0, 0, 0) | then moved |
//! | `matrix` | | instead of these three: three rows `[(a, b, c, x), (d, e, f, y), (g, h, i, z)]` |
//! | `moving` | false | may move from frame to frame; so does what has a `path` |
//! | `path` | | keys in time, see below |
//! | `inside_out` | false | shapes only: the front is the inside |
//!
//! Shapes are kept in `f32`: put one far from the origin by `translate`, which is `f64`.
//!
//! | shape | fields |
//! |---|---|
//! | `Box` | `min` (−0.5, −0.5, −0.5), `max` (0.5, 0.5, 0.5) |
//! | `Quad` | `corners`, needed: four in a plane, counter-clockwise from the front |
//! | `Grid` | `size` (1, 1) along x and z, `cells` (1, 1); faces +y |
//! | `Disc` | `radius` 0.5, `segments` 64; faces +y |
//! | `Cylinder` | `radius` 0.5, `height` 1, `segments` 64; closed, stands on y = 0 |
//! | `Sphere` | `radius` 0.5, `segments` 64 |
//! | `Triangle` | `corners`, needed: three, counter-clockwise from the front |
//! | `Triangles` | `positions` and `indices` (triples), needed; flat normals |
//!
//! # `lights`
//! | light | fields |
//! |---|---|
//! | `Directional` | `direction` it travels, needed; `irradiance`, needed, W·m⁻²; `angular_diameter_deg` 0, below 180 |
//! | `Point` | `position`, needed; `intensity`, needed, W·sr⁻¹; `radius` 0 |
//! | `Spot` | as `Point`, and `direction`, needed; `inner_deg` 0 and `outer_deg` 45, half-angles: full light within, none beyond |
//!
//! All may have a `name` and a `path`.
//!
//! # `sky`
//! Radiance from everywhere outside, W·m⁻²·sr⁻¹; 0 if it is not given.
//!
//! # `cameras`
//! `eye`, `target` and `fov_deg` (vertical, full angle) are needed; `up` is (0, 1, 0); `name` is `camera N`.
//! It may have a `path`. Without a camera the scene gets one that frames it.
//!
//! # `path`
//! A list of keys. Each is a pose that is applied to the object, light or camera as it stands without a path: scaled,
//! turned and moved in the world, about the world's origin. So a pendulum hangs below the origin, and its keys turn it
//! and move it to its nail. Between two keys position and scale change linearly, and the rotation turns evenly (slerp);
//! before the first key and after the last one all rests.
//!
//! | field | default | meaning |
//! |---|---|---|
//! | `time` | needed | seconds; above that of the key before |
//! | `scale` | 1 | objects only: a number or `(x, y, z)`, nowhere 0 and of one sign |
//! | `rotate_deg` | (0, 0, 0) | about the world's x, then y, then z axis; less than 180° from the key before |
//! | `translate` | (0, 0, 0) | world units |

mod camera;
mod light;
mod material;
mod object;
mod path;
mod shape;
mod value;

use std::path::Path;
use std::sync::Arc;

use voxlume_fault::ron::{Document, Fields, Node};
use voxlume_fault::{Faults, Source};

use crate::{Moved, Scene};

/// Reads the text of a file, which is or might be at `path`.
pub(crate) fn read(source: &Arc<Source>, path: &Path) -> Result<Scene, Faults> {
    let folder = path.parent().unwrap_or(Path::new(""));
    let document = Document::parse(source)?;
    let mut faults = Faults::default();
    let mut scene = Scene { name: crate::load::stem(path), ..Scene::default() };
    let mut fields = Fields::of(document.root())?;

    if let Some(materials) = fields.node("materials") {
        scene.materials = material::read(materials, &mut faults);
    }
    if let Some(objects) = fields.node("objects") {
        faults.gather(object::read(objects, folder, &mut scene));
    }
    for (index, (light, path)) in
        list(&mut fields, "lights", light::read, &mut faults).into_iter().enumerate()
    {
        let rest = light.kind;
        scene.animation.lights.extend(path.map(|path| Moved { index, rest, path }));
        scene.lights.push(light);
    }
    for (index, (camera, path)) in
        list(&mut fields, "cameras", camera::read, &mut faults).into_iter().enumerate()
    {
        let rest = camera.clone();
        scene.animation.cameras.extend(path.map(|path| Moved { index, rest, path }));
        scene.cameras.push(camera);
    }
    scene.sky = value::colour(&mut fields, "sky", Some(0.0), &mut faults).unwrap_or_default();
    fields.finish(&mut faults);
    faults.in_order().into_result(scene)
}

fn list<T>(
    fields: &mut Fields<'_>,
    name: &str,
    read: impl Fn(Node<'_>, usize) -> Result<Option<T>, Faults>,
    faults: &mut Faults,
) -> Vec<T> {
    let items = fields.node(name).and_then(|node| faults.gather(node.items())).unwrap_or_default();
    items.into_iter().enumerate().filter_map(|(i, item)| faults.gather(read(item, i)).flatten()).collect()
}
