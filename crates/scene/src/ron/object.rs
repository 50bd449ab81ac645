//! `objects`.

use std::collections::HashMap;
use std::path::{Path, PathBuf};

use glam::{DAffine3, DMat3, DQuat, DVec3, EulerRot};
use voxlume_fault::ron::{Fields, FromRon, Node};
use voxlume_fault::{Fault, Faults};

use super::{path, shape, value};
use crate::{Instance, Mesh, Moved, Scene, gltf};

/// Reads the objects into a scene that has its materials.
pub(super) fn read(node: Node<'_>, folder: &Path, scene: &mut Scene) -> Result<(), Faults> {
    let mut faults = Faults::default();
    let names: Vec<String> = scene.materials.iter().map(|material| material.name.clone()).collect();
    let mut objects = Objects { folder, names, files: HashMap::new(), scene };
    for (i, item) in node.items()?.into_iter().enumerate() {
        faults.gather(objects.read(item, i));
    }
    faults.into_result(())
}

struct Objects<'a> {
    folder: &'a Path,
    /// Of the RON file's own materials, the scene's first.
    names: Vec<String>,
    /// What each glTF file brought, placed as in the file; `None` for a faulty one.
    files: HashMap<PathBuf, Option<Vec<Instance>>>,
    scene: &'a mut Scene,
}

impl Objects<'_> {
    fn read(&mut self, node: Node<'_>, index: usize) -> Result<(), Faults> {
        let mut faults = Faults::default();
        let mut fields = value::unnamed(node)?;
        let name = fields.or("name", format!("object {index}"), &mut faults);
        let moving = fields.or("moving", false, &mut faults);
        let transform = transform(&mut fields, &mut faults);
        let path = path::read(&mut fields, path::Scales::Yes, &mut faults);
        let moving = moving || path.is_some();
        let material = fields.node("material").and_then(|node| faults.gather(self.material(node)));
        let given = fields.node("material").is_some();
        let instances = match (fields.node("shape"), fields.node("gltf")) {
            (Some(shape), None) => {
                if !given {
                    faults.push(node.fault("missing field `material`", "a shape needs one"));
                }
                let inside_out = fields.or("inside_out", false, &mut faults);
                let mesh = faults.gather(shape::read(shape)).flatten();
                mesh.zip(material).map(|(mesh, material)| self.shape(&name, mesh, material, inside_out))
            }
            (None, Some(path)) => faults.gather(self.file(path)).flatten().map(|brought| {
                let named = |i: &Instance| Instance { name: format!("{name}/{}", i.name), ..i.clone() };
                let brought = brought.iter().map(named).collect();
                match material {
                    Some(material) => self.replace_material(brought, material),
                    None => brought,
                }
            }),
            (shape, _) => {
                let label = if shape.is_some() { "both are given" } else { "neither is given" };
                faults.push(node.fault("an object has either `shape` or `gltf`", label));
                fields.node("inside_out");
                None
            }
        };
        fields.finish(&mut faults);
        let placed = instances.into_iter().flatten().zip(std::iter::repeat(transform));
        for (instance, transform) in placed {
            let Some(transform) = transform.map(|transform| transform * instance.transform) else { continue };
            let moved = |path| Moved { index: self.scene.instances.len(), rest: transform, path };
            self.scene.animation.instances.extend(path.clone().map(moved));
            self.scene.instances.push(Instance { transform, moving, ..instance });
        }
        faults.into_result(())
    }

    fn material(&self, node: Node<'_>) -> Result<usize, Fault> {
        let name = node.choice("material", self.names.iter().map(String::as_str))?;
        Ok(self.names.iter().position(|known| known == name).unwrap_or_default())
    }

    fn shape(&mut self, name: &str, mut mesh: Mesh, material: usize, inside_out: bool) -> Vec<Instance> {
        if inside_out {
            crate::shape::turn_inside_out(&mut mesh);
        }
        self.scene.meshes.push(Mesh { name: name.to_owned(), material, ..mesh });
        let mesh = self.scene.meshes.len() - 1;
        vec![Instance { name: name.to_owned(), mesh, transform: DAffine3::IDENTITY, moving: false }]
    }

    /// The instances that a glTF file brings, read once. `None` if its faults are already told.
    fn file(&mut self, node: Node<'_>) -> Result<Option<Vec<Instance>>, Faults> {
        let path = self.folder.join(node.get::<String>()?);
        if let Some(known) = self.files.get(&path) {
            return Ok(known.clone());
        }
        let placed = |fault: Fault| fault.at(node.source(), node.head(), "read from here");
        let loaded = gltf::load(&path).map_err(|faults| faults.map(placed));
        let brought = match loaded {
            Ok(file) => Some(self.append(file)),
            Err(faults) => {
                self.files.insert(path, None);
                return Err(faults);
            }
        };
        self.files.insert(path, brought.clone());
        Ok(brought)
    }

    /// Moves a file's meshes, materials and textures into the scene.
    fn append(&mut self, file: Scene) -> Vec<Instance> {
        let scene = &mut *self.scene;
        let (textures, materials, meshes) = (scene.textures.len(), scene.materials.len(), scene.meshes.len());
        scene.textures.extend(file.textures);
        scene.materials.extend(file.materials.into_iter().map(|mut material| {
            let references = [
                &mut material.base_color_texture,
                &mut material.metallic_roughness_texture,
                &mut material.normal_texture,
                &mut material.emission_texture,
            ];
            references.into_iter().flatten().for_each(|reference| reference.texture += textures);
            material
        }));
        let moved = |mesh: Mesh| Mesh { material: mesh.material + materials, ..mesh };
        scene.meshes.extend(file.meshes.into_iter().map(moved));
        file.instances.into_iter().map(|i| Instance { mesh: i.mesh + meshes, ..i }).collect()
    }

    /// Gives instances copies of their meshes with another material.
    fn replace_material(&mut self, mut instances: Vec<Instance>, material: usize) -> Vec<Instance> {
        let mut copies = HashMap::new();
        for instance in &mut instances {
            instance.mesh = *copies.entry(instance.mesh).or_insert_with(|| {
                let mesh = self.scene.meshes[instance.mesh].clone();
                self.scene.meshes.push(Mesh { material, ..mesh });
                self.scene.meshes.len() - 1
            });
        }
        instances
    }
}

fn transform(fields: &mut Fields<'_>, faults: &mut Faults) -> Option<DAffine3> {
    let parts = ["scale", "rotate_deg", "translate"].map(|name| fields.node(name));
    let scale = scale(fields, faults);
    let rotate = value::vector(fields, "rotate_deg", Some(DVec3::ZERO), faults);
    let translate = value::vector(fields, "translate", Some(DVec3::ZERO), faults);
    let Some(matrix) = fields.node("matrix") else {
        return Some(DAffine3::from_scale_rotation_translation(scale, rotation(rotate?), translate?));
    };
    if parts.iter().any(Option::is_some) {
        faults.push(matrix.fault("`matrix` goes without `scale`, `rotate_deg` and `translate`", ""));
    }
    let rows: [[f64; 4]; 3] = faults.gather(matrix.get())?;
    let column = |i: usize| DVec3::new(rows[0][i], rows[1][i], rows[2][i]);
    Some(DAffine3 { matrix3: DMat3::from_cols(column(0), column(1), column(2)), translation: column(3) })
}

/// `scale`, or 1.
pub(super) fn scale(fields: &mut Fields<'_>, faults: &mut Faults) -> DVec3 {
    fields.or("scale", Scale(DVec3::ONE), faults).0
}

/// `rotate_deg`: about the world's x, then y, then z axis.
pub(super) fn rotation(degrees: DVec3) -> DQuat {
    let angles = degrees.map(f64::to_radians);
    DQuat::from_euler(EulerRot::ZYX, angles.z, angles.y, angles.x)
}

/// One number for all axes, or three.
struct Scale(DVec3);

impl FromRon for Scale {
    fn from_ron(node: Node<'_>) -> Result<Self, Faults> {
        match node.delimiter() {
            Some(_) => Ok(Scale(node.get::<[f64; 3]>()?.into())),
            None => Ok(Scale(DVec3::splat(node.get()?))),
        }
    }
}
