//! glTF 2.0, `.gltf` and `.glb`.
//!
//! # What is read
//! - The file's scene (its default, else its first, else every node without a parent), with node transforms
//!   accumulated in `f64`, mirrored and non-uniform ones included. The JSON's own numbers are `f32`, as glTF
//!   says.
//! - Triangles, strips and fans, indexed or not; sparse accessors; normalised and, as `KHR_mesh_quantization`
//!   allows, plain integers. Points and lines are skipped: they have no surface.
//! - Missing normals are flat, as the specification says; missing tangents are MikkTSpace's where there is a
//!   normal map (the crate `bevy_mikktspace`), any elsewhere.
//! - Metallic-roughness materials with base-colour, metallic-roughness, normal and emissive textures (PNG,
//!   JPEG), `KHR_materials_emissive_strength`, `doubleSided`, and `KHR_texture_transform` where all of a
//!   material's textures agree in it and in their `texCoord`: it is applied to the mesh's coordinates.
//! - `MASK`, dropped where no texel can fail it. `BLEND` is taken as a mask at 0.5: what is more transparent
//!   than not is a hole, for nothing here blends surfaces.
//! - `KHR_lights_punctual`: lux is taken as irradiance (W·m⁻²) and candela as radiant intensity (W·sr⁻¹),
//!   without the factor 683 lm/W; `range` is ignored, for it is a hint for culling and light doesn't end.
//! - Perspective cameras. Orthographic ones are skipped: every pass here traces from one point.
//!
//! # What is left out
//! Animations, skins and morph targets (meshes stand as stored), vertex colours, samplers (textures repeat
//! and are filtered linearly), occlusion textures (occlusion is what is computed here), and materials' other
//! extensions unless the file requires them, which is a fault.
//!
//! # Where files may be
//! A URI is `data:` with base64 or a relative path that stays in the glTF file's folder, links followed.
//!
//! # Lone models
//! A file without any light or emission gets a sky of radiance [`DEFAULT_SKY`], so that a picture of it isn't
//! black; one without a perspective camera gets one that frames it. RON scenes get the camera, not the sky.

mod accessor;
mod document;
mod image;
mod material;
mod node;
mod primitive;
mod source;

use std::borrow::Cow;
use std::collections::HashMap;
use std::fmt::Display;
use std::path::Path;

use gltf::json::Root;
use voxlume_fault::{Fault, Faults};

use crate::limit::{Budget, read_file};
use crate::load::in_file;
use crate::{Instance, Material, Scene};

/// Radiance of the sky over a glTF file that has no light of its own, W·m⁻²·sr⁻¹.
pub const DEFAULT_SKY: f32 = 1.0;

/// Reads a file. Cameras are only those in the file.
pub(crate) fn load(path: &Path) -> Result<Scene, Faults> {
    let bytes = read_file(path).map_err(Fault::new)?;
    let folder = path.parent().unwrap_or(Path::new(""));
    let mut scene = read(&bytes, folder).map_err(|faults| faults.map(|fault| in_file(path, fault)))?;
    scene.name = crate::load::stem(path);
    Ok(scene)
}

fn read(bytes: &[u8], folder: &Path) -> Result<Scene, Faults> {
    let (json, bin) = document::split(bytes)?;
    let root = document::parse(json)?;
    let buffers = source::buffers(&root, bin, folder)?;
    let placed = node::place(&root)?;

    let mut faults = Faults::default();
    let mut scene = Scene::default();
    for placed in &placed {
        scene.lights.extend(faults.gather(node::light(&root, placed)).flatten());
        scene.cameras.extend(faults.gather(node::camera(&root, placed)).flatten());
    }
    let mut budget = Budget::new();
    let wanted = faults.gather(surfaces(&root, &buffers, &placed, &mut scene, &mut budget));
    let textures =
        wanted.and_then(|wanted| faults.gather(wanted.decode(&root, &buffers, folder, &mut budget)));
    scene.textures = textures.unwrap_or_default();
    material::drop_idle_masks(&mut scene.materials, &scene.textures);
    faults.into_result(scene)
}

/// Reads the materials and meshes that the placed nodes use, each once, and makes the instances.
fn surfaces(
    root: &Root,
    buffers: &[Cow<'_, [u8]>],
    placed: &[node::Placed],
    scene: &mut Scene,
    budget: &mut Budget,
) -> Result<image::Wanted, Faults> {
    let accessors = accessor::Accessors { root, buffers };
    let mut faults = Faults::default();
    let mut wanted = image::Wanted::default();
    let mut materials = HashMap::new();
    let mut meshes: HashMap<usize, Vec<usize>> = HashMap::new();
    for placed in placed {
        let Some(m) = root.nodes[placed.node].mesh.map(|mesh| mesh.value()) else { continue };
        let json = &root.meshes[m];
        let name = || json.name.clone().unwrap_or_else(|| format!("mesh {m}"));
        let primitives = meshes.entry(m).or_insert_with(|| {
            let mut read = Vec::new();
            for (p, primitive) in json.primitives.iter().enumerate().filter(|(_, p)| primitive::is_surface(p))
            {
                let place = format!("meshes[{m}].primitives[{p}]");
                let index = primitive.material.map(|material| material.value());
                let used = materials
                    .entry(index)
                    .or_insert_with(|| {
                        let (material, uvs) = match index {
                            Some(index) => faults.gather(material::read(root, index, &mut wanted))?,
                            None => material::default(),
                        };
                        let normal_map = material.normal_texture.is_some();
                        scene.materials.push(material);
                        Some(primitive::Use { material: scene.materials.len() - 1, uvs, normal_map })
                    })
                    .as_ref();
                let mesh = used.and_then(|used| {
                    faults.gather(
                        primitive::reserve(accessors, primitive, budget).map_err(|e| at(&place, e.message)),
                    )?;
                    faults.gather(primitive::read(accessors, &place, name(), primitive, used))
                });
                if let Some(mesh) = mesh {
                    scene.meshes.push(mesh);
                    read.push(scene.meshes.len() - 1);
                }
            }
            read
        });
        let instance = |mesh: &usize| Instance {
            name: placed.name.clone(),
            mesh: *mesh,
            transform: placed.transform,
            moving: false,
        };
        scene.instances.extend(primitives.iter().map(instance));
    }
    faults.into_result(wanted)
}

/// Gives a scene without any light [`DEFAULT_SKY`].
pub(crate) fn light_if_dark(scene: &mut Scene) {
    let emits = |material: &Material| material.emission != glam::Vec3::ZERO;
    if scene.lights.is_empty() && scene.sky == glam::Vec3::ZERO && !scene.materials.iter().any(emits) {
        scene.sky = glam::Vec3::splat(DEFAULT_SKY);
    }
}

fn at(place: impl Display, what: impl Display) -> Fault {
    Fault::new(format!("{place}: {what}"))
}
