//! What is added to a scene.

use std::path::Path;

use glam::{DAffine3, DVec3, Vec3};
use voxlume::scene::{Instance, Light, LightKind, Material};
use voxlume::{Scene, SceneFacts};
use voxlume_benches::tube::torus;

/// Loads a scene.
pub fn load(path: &Path) -> Result<Scene, String> {
    eprintln!("loading {}", path.display());
    Scene::load(path).map_err(|faults| faults.to_string())
}

/// The box around a scene.
#[derive(Clone, Copy, Debug)]
pub struct Room {
    low: DVec3,
    size: DVec3,
}

impl Room {
    /// A scene's; a unit cube of an empty one.
    pub fn of(scene: &Scene) -> Result<Room, String> {
        let facts = SceneFacts::of(scene).map_err(|faults| faults.to_string())?;
        let (low, high) = facts.bounds.unwrap_or((DVec3::ZERO, DVec3::ONE));
        Ok(Room { low, size: high - low })
    }

    /// So much that it is seen, and that the next frame's voxels are others.
    pub fn step(&self) -> f64 {
        self.size.max_element() / 256.0
    }

    /// Adds lamps under the ceiling that shine down, each a small sphere.
    pub fn add_lamps(&self, scene: &mut Scene, count: u32) {
        let side = self.size.min_element();
        let intensity = Vec3::splat((side * side) as f32 / count as f32);
        for i in 0..count {
            // Evenly spread however many there are: Roberts' R₂ sequence.
            let across = |ratio: f64| 0.2 + 0.6 * (0.5 + f64::from(i) * ratio).fract();
            let position = self.low
                + self.size * DVec3::new(across(0.754_877_666_246_693), 0.9, across(0.569_840_290_998_053));
            let kind = LightKind::Spot {
                position,
                direction: Vec3::NEG_Y,
                radius: (side / 100.0) as f32,
                inner: 0.7,
                outer: 1.1,
            };
            scene.lights.push(Light { name: format!("lamp {i}"), kind, intensity });
        }
    }

    /// Adds a white torus below the middle of the ceiling, of 2 × `segments` × `sides` triangles.
    pub fn add_object(&self, scene: &mut Scene, [segments, sides]: [u32; 2], moving: bool) {
        let place = self.low + self.size * DVec3::new(0.5, 0.7, 0.5);
        let scale = DVec3::splat(self.size.min_element() / 8.0);
        let transform = DAffine3::from_translation(place) * DAffine3::from_scale(scale);
        let mut mesh = torus(segments, sides);
        mesh.material = scene.materials.len();
        scene.materials.push(Material { name: "object".into(), ..Material::default() });
        scene.instances.push(Instance { name: "object".into(), mesh: scene.meshes.len(), transform, moving });
        scene.meshes.push(mesh);
    }
}

/// Moves the lamp that was added last.
pub fn move_lamp(scene: &mut Scene, step: f64) {
    if let Some(LightKind::Spot { position, .. }) = scene.lights.last_mut().map(|light| &mut light.kind) {
        position.x += step;
    }
}

/// Moves the object that was added last.
pub fn move_object(scene: &mut Scene, step: f64) {
    if let Some(instance) = scene.instances.last_mut() {
        instance.transform.translation.x += step;
    }
}
