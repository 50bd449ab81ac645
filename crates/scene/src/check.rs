//! Whether a scene is what [`Scene`] promises, wherever it comes from.

use glam::{DVec3, Vec3, Vec4Swizzles};
use voxlume_fault::{Fault, Faults};

use crate::limit::{Budget, TRIANGLE_BYTES, VERTEX_BYTES};
use crate::rule::{self, UNIT};
use crate::{Animation, Camera, Instance, Key, Light, LightKind, Material, Mesh, Scene};

/// How far from the world's origin anything may reach: beyond it, squares of lengths leave `f32`.
pub const WORLD_LIMIT: f64 = 1e15;

impl Scene {
    /// Checks a scene that was made or changed in memory; loaded ones are checked already. Of each part it tells the first
    /// fault.
    ///
    /// # Errors
    /// A number is not finite or out of its range; an index is out of range; lists differ in length; the scene would take
    /// more than [`MEMORY_LIMIT`](crate::MEMORY_LIMIT) or reach beyond [`WORLD_LIMIT`].
    pub fn check(&self) -> Result<(), Faults> {
        let mut faults = Faults::default();
        for (index, material) in self.materials.iter().enumerate() {
            part(&mut faults, "material", index, &material.name, material.check(self.textures.len()));
        }
        for (index, texture) in self.textures.iter().enumerate() {
            let texels = u64::from(texture.width) * u64::from(texture.height);
            let is_whole =
                texels > 0 && texture.rgba.len() as u64 / 4 == texels && texture.rgba.len() % 4 == 0;
            let checked = holds(is_whole, "it has other than width × height texels");
            part(&mut faults, "texture", index, &texture.name, checked);
        }
        for (index, mesh) in self.meshes.iter().enumerate() {
            part(&mut faults, "mesh", index, &mesh.name, mesh.check(self.materials.len()));
        }
        self.check_poses(&mut faults);
        let Animation { instances, lights, cameras } = &self.animation;
        let paths = (instances.iter().map(|m| ("instance", m.index, self.instances.len(), &m.path)))
            .chain(lights.iter().map(|m| ("light", m.index, self.lights.len(), &m.path)))
            .chain(cameras.iter().map(|m| ("camera", m.index, self.cameras.len(), &m.path)));
        for (kind, index, count, path) in paths {
            if index >= count {
                faults.push(Fault::new(format!("a path moves {kind} {index}, of which there are {count}")));
            } else if !path.keys.iter().all(Key::is_finite) {
                faults.push(Fault::new(format!("the path of {kind} {index} is not finite")));
            }
        }
        faults.into_result(())?;
        Ok(self.within_limits()?)
    }

    /// Checks what may differ from one frame to the next: transforms and what follows them, lights, cameras and the sky. Of
    /// a scene that has passed [`Scene::check`] and changed in no more than these, this says as much in less time.
    ///
    /// # Errors
    /// As [`Scene::check`].
    pub fn check_frame(&self) -> Result<(), Faults> {
        let mut faults = Faults::default();
        self.check_poses(&mut faults);
        for (index, mesh) in self.meshes.iter().enumerate() {
            let material = below(mesh.material, self.materials.len(), "material");
            part(&mut faults, "mesh", index, &mesh.name, material);
        }
        faults.into_result(())?;
        let mut faults = Faults::default();
        for instance in &self.instances {
            let mesh = &self.meshes[instance.mesh];
            let shines = self.materials[mesh.material].emission != Vec3::ZERO;
            if instance.moving || shines {
                part(&mut faults, "mesh", instance.mesh, &mesh.name, mesh.check(self.materials.len()));
            }
        }
        faults.into_result(())?;
        for instance in self.instances.iter().filter(|instance| instance.moving) {
            instance.within_world(&self.meshes[instance.mesh])?;
        }
        Ok(self.places_within_world()?)
    }

    /// Of lights and cameras.
    fn places_within_world(&self) -> Result<(), Fault> {
        let lights = self.lights.iter().filter_map(|light| Some((&light.name, light.position()?)));
        let cameras = self.cameras.iter().map(|camera| (&camera.name, camera.eye));
        match lights.chain(cameras).find(|(_, place)| beyond((*place, *place))) {
            Some((name, _)) => Err(Fault::new(format!("`{name}` lies beyond {WORLD_LIMIT:e} units"))),
            None => Ok(()),
        }
    }

    /// Instances, lights, cameras and the sky, one by one.
    fn check_poses(&self, faults: &mut Faults) {
        for (index, instance) in self.instances.iter().enumerate() {
            let checked = below(instance.mesh, self.meshes.len(), "mesh")
                .and_then(|()| holds(instance.transform.is_finite(), "its transform is not finite"));
            part(faults, "instance", index, &instance.name, checked);
        }
        for (index, light) in self.lights.iter().enumerate() {
            part(faults, "light", index, &light.name, light.check());
        }
        for (index, camera) in self.cameras.iter().enumerate() {
            part(faults, "camera", index, &camera.name, camera.checked());
        }
        faults.gather(rule::check(rule::LIGHT, "`sky`", self.sky).map_err(Fault::new));
    }

    /// Memory and reach.
    pub(crate) fn within_limits(&self) -> Result<(), Fault> {
        let mut budget = Budget::new();
        for texture in &self.textures {
            budget.take(texture.rgba.len() as u64, 1)?;
        }
        for instance in &self.instances {
            let mesh = &self.meshes[instance.mesh];
            budget.take(mesh.positions.len() as u64, VERTEX_BYTES)?;
            budget.take(mesh.triangles.len() as u64, TRIANGLE_BYTES)?;
            instance.within_world(mesh)?;
        }
        self.places_within_world()?;
        for moved in &self.animation.instances {
            let instance = &self.instances[moved.index];
            let wild =
                moved.path.keys.iter().any(|key| key.scale.max(key.translation).abs().max_element() > 1e100);
            if wild || moved.reach(instance, &self.meshes[instance.mesh]).is_some_and(beyond) {
                let name = &instance.name;
                return Err(Fault::new(format!("the path of `{name}` reaches beyond {WORLD_LIMIT:e} units")));
            }
        }
        Ok(())
    }
}

impl Instance {
    fn within_world(&self, mesh: &Mesh) -> Result<(), Fault> {
        // Entries that large could cancel each other's overflow into a NaN.
        let wild = self.transform.to_cols_array().iter().any(|entry| entry.abs() > 1e100);
        if wild || self.bounds(mesh).is_some_and(beyond) {
            return Err(Fault::new(format!("`{}` reaches beyond {WORLD_LIMIT:e} units", self.name)));
        }
        Ok(())
    }
}

fn part(faults: &mut Faults, kind: &str, index: usize, name: &str, checked: Result<(), String>) {
    if let Err(message) = checked {
        faults.push(Fault::new(format!("{kind} {index}, `{name}`: {message}")));
    }
}

/// NaN is.
fn beyond((low, high): (DVec3, DVec3)) -> bool {
    let inside = |corner: DVec3| corner.abs().cmple(DVec3::splat(WORLD_LIMIT)).all();
    !(inside(low) && inside(high))
}

fn holds(is: bool, else_message: &str) -> Result<(), String> {
    if is { Ok(()) } else { Err(else_message.into()) }
}

fn below(index: usize, count: usize, what: &str) -> Result<(), String> {
    if index < count { Ok(()) } else { Err(format!("it names {what} {index} of {count}")) }
}

impl Key {
    fn is_finite(&self) -> bool {
        let Key { time, scale, rotation, translation } = self;
        time.is_finite() && scale.is_finite() && rotation.is_finite() && translation.is_finite()
    }
}

impl Material {
    fn check(&self, textures: usize) -> Result<(), String> {
        rule::check(rule::REFLECTANCE, "`base_color`", self.base_color)?;
        rule::check(rule::SHARE, "`metallic`", self.metallic)?;
        rule::check(rule::SHARE, "`roughness`", self.roughness)?;
        rule::check(rule::FINITE, "`normal_scale`", self.normal_scale)?;
        rule::check(rule::LIGHT, "`emission`", self.emission)?;
        rule::check(rule::SIZE, "`alpha_cutoff`", self.alpha_cutoff.unwrap_or_default())?;
        let used = [
            self.base_color_texture,
            self.metallic_roughness_texture,
            self.normal_texture,
            self.emission_texture,
        ];
        used.into_iter().flatten().try_for_each(|used| below(used.texture, textures, "texture"))
    }
}

impl Mesh {
    fn check(&self, materials: usize) -> Result<(), String> {
        below(self.material, materials, "material")?;
        let vertices = self.positions.len();
        let lengths = [self.normals.len(), self.tangents.len(), self.uvs.len()];
        holds(lengths == [vertices; 3], "its attributes differ in length")?;
        let first = |attribute: &str, wrong: Option<usize>| match wrong {
            Some(vertex) => Err(format!("the {attribute} of vertex {vertex} is not finite")),
            None => Ok(()),
        };
        first("position", self.positions.iter().position(|v| !v.is_finite()))?;
        first("normal", self.normals.iter().position(|v| !v.is_finite()))?;
        first("tangent", self.tangents.iter().position(|v| !v.xyz().is_finite() || !v.w.is_finite()))?;
        first("texture coordinate", self.uvs.iter().position(|v| !v.is_finite()))?;
        let outside = self.triangles.iter().position(|t| t.iter().any(|vertex| *vertex as usize >= vertices));
        match outside {
            Some(triangle) => Err(format!("triangle {triangle} names a vertex beyond the {vertices}")),
            None => Ok(()),
        }
    }
}

impl Light {
    fn position(&self) -> Option<DVec3> {
        match self.kind {
            LightKind::Directional { .. } => None,
            LightKind::Point { position, .. } | LightKind::Spot { position, .. } => Some(position),
        }
    }

    fn check(&self) -> Result<(), String> {
        rule::check(rule::LIGHT, "`intensity`", self.intensity)?;
        match self.kind {
            LightKind::Directional { direction, angular_diameter } => {
                rule::check(rule::DIRECTION, "`direction`", direction)?;
                rule::check(rule::ANGULAR_DIAMETER, "`angular_diameter`", angular_diameter)
            }
            LightKind::Point { radius, .. } => rule::check(rule::SIZE, "`radius`", radius),
            LightKind::Spot { direction, radius, inner, outer, .. } => {
                rule::check(rule::DIRECTION, "`direction`", direction)?;
                rule::check(rule::SIZE, "`radius`", radius)?;
                rule::check_spot(inner, outer)
            }
        }
    }
}

impl Camera {
    /// Checks a camera that was made or changed in memory.
    ///
    /// # Errors
    /// A number is not finite or out of its range, or the directions are not of length 1 and at right angles.
    pub fn check(&self) -> Result<(), Fault> {
        let placed =
            || holds(!beyond((self.eye, self.eye)), &format!("it lies beyond {WORLD_LIMIT:e} units"));
        let checked = self.checked().and_then(|()| placed());
        checked.map_err(|message| Fault::new(format!("camera `{}`: {message}", self.name)))
    }

    fn checked(&self) -> Result<(), String> {
        rule::check(rule::DIRECTION, "`forward`", self.forward)?;
        rule::check(rule::DIRECTION, "`up`", self.up)?;
        holds(self.forward.dot(self.up).abs() < UNIT, "`forward` and `up` must be at right angles")?;
        rule::check(rule::VERTICAL_FOV, "`vertical_fov`", self.vertical_fov)
    }
}
