//! What moves, and where it is when.

use glam::{DAffine3, DQuat, DVec3};

use crate::{Camera, Instance, LightKind, Mesh, Scene};

/// A pose at a time: scaled, then turned, then moved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Key {
    /// Seconds.
    pub time: f64,
    /// Applied first; no part is 0.
    pub scale: DVec3,
    /// Applied second; unit.
    pub rotation: DQuat,
    /// Applied last, world units.
    pub translation: DVec3,
}

/// Poses one after the other. Between two keys position and scale change linearly, and the rotation turns evenly the
/// shorter way (slerp); before the first key and after the last one it rests.
#[derive(Clone, Debug, PartialEq)]
pub struct Path {
    /// At least one; times rise.
    pub keys: Vec<Key>,
}

/// Something of a scene that follows a path.
#[derive(Clone, Debug, PartialEq)]
pub struct Moved<T> {
    /// Index in the scene's list.
    pub index: usize,
    /// As it is where the path's pose changes nothing.
    pub rest: T,
    /// Applied to it.
    pub path: Path,
}

/// All that follows a path.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Animation {
    /// Transforms of instances.
    pub instances: Vec<Moved<DAffine3>>,
    /// Lights.
    pub lights: Vec<Moved<LightKind>>,
    /// Cameras.
    pub cameras: Vec<Moved<Camera>>,
}

impl Key {
    fn transform(&self) -> DAffine3 {
        DAffine3::from_scale_rotation_translation(self.scale, self.rotation, self.translation)
    }

    fn towards(&self, next: &Key, share: f64) -> Key {
        Key {
            time: self.time + share * (next.time - self.time),
            scale: self.scale.lerp(next.scale, share),
            rotation: self.rotation.slerp(next.rotation, share),
            translation: self.translation.lerp(next.translation, share),
        }
    }
}

impl Path {
    /// The pose at a time in seconds.
    pub fn at(&self, time: f64) -> Key {
        let after = self.keys.partition_point(|key| key.time <= time);
        match (after.checked_sub(1).map(|before| &self.keys[before]), self.keys.get(after)) {
            (Some(key), Some(next)) => key.towards(next, (time - key.time) / (next.time - key.time)),
            (Some(key), None) | (None, Some(key)) => *key,
            (None, None) => {
                Key { time, scale: DVec3::ONE, rotation: DQuat::IDENTITY, translation: DVec3::ZERO }
            }
        }
    }
}

impl Scene {
    /// Puts everything that follows a path where it is at a time in seconds. A scene is loaded as it is at 0.
    pub fn set_time(&mut self, time: f64) {
        for Moved { index, rest, path } in &self.animation.instances {
            self.instances[*index].transform = path.at(time).transform() * *rest;
        }
        for Moved { index, rest, path } in &self.animation.lights {
            self.lights[*index].kind = moved_light(*rest, &path.at(time));
        }
        for Moved { index, rest, path } in &self.animation.cameras {
            let key = path.at(time);
            let turned = |v: glam::Vec3| (key.rotation * v.as_dvec3()).normalize().as_vec3();
            let (eye, forward, up) =
                (key.transform().transform_point3(rest.eye), turned(rest.forward), turned(rest.up));
            self.cameras[*index] = Camera { eye, forward, up, ..rest.clone() };
        }
    }

    /// The least box around all triangles, in the world, wherever their paths take them; `None` if there are none.
    /// Where a path turns, it may be up to a thousandth of the turning radius larger.
    pub fn reach(&self) -> Option<(DVec3, DVec3)> {
        let boxes = self.instances.iter().enumerate().filter_map(|(index, instance)| {
            let mesh = &self.meshes[instance.mesh];
            match self.animation.instances.iter().find(|moved| moved.index == index) {
                Some(moved) => moved.reach(instance, mesh),
                None => instance.bounds(mesh),
            }
        });
        boxes.reduce(|(low, high), (l, h)| (low.min(l), high.max(h)))
    }
}

fn moved_light(rest: LightKind, key: &Key) -> LightKind {
    let placed = |position: DVec3| key.rotation * position + key.translation;
    let turned = |direction: glam::Vec3| (key.rotation * direction.as_dvec3()).normalize().as_vec3();
    match rest {
        LightKind::Directional { direction, angular_diameter } => {
            LightKind::Directional { direction: turned(direction), angular_diameter }
        }
        LightKind::Point { position, radius } => LightKind::Point { position: placed(position), radius },
        LightKind::Spot { position, direction, radius, inner, outer } => {
            LightKind::Spot { position: placed(position), direction: turned(direction), radius, inner, outer }
        }
    }
}

impl Moved<DAffine3> {
    /// Angle between two poses at which the box is taken, radians.
    const STEP: f64 = 5.0 * std::f64::consts::PI / 180.0;

    pub(crate) fn reach(&self, instance: &Instance, mesh: &Mesh) -> Option<(DVec3, DVec3)> {
        let bounds = |key: &Key| {
            let transform = key.transform() * self.rest;
            Instance { transform, ..instance.clone() }.bounds(mesh)
        };
        let (low, high) = Instance { transform: self.rest, ..instance.clone() }.bounds(mesh)?;
        let farthest = low.abs().max(high.abs());
        let keys = &self.path.keys;
        let mut boxes: Vec<_> = keys.iter().filter_map(bounds).collect();
        for (key, next) in keys.iter().zip(&keys[1..]) {
            let angle = key.rotation.angle_between(next.rotation);
            let steps = (angle / Self::STEP).ceil();
            // Without a turn every point's way is straight, and its ends say it all.
            if steps == 0.0 {
                continue;
            }
            // Between two poses f(0) and f(1), f = T + R·S·p leaves the straight line by at most max|f″|/8, where
            // |f″| ≤ δ²·|S·p| + 2·δ·|S′·p| for a turn by δ.
            let turn = angle / steps;
            let radius = (key.scale.abs().max(next.scale.abs()) * farthest).length();
            let change = ((next.scale - key.scale).abs() / steps * farthest).length();
            let margin = turn * turn * radius / 8.0 + turn * change / 4.0;
            for step in 0..=steps as u32 {
                let pose = key.towards(next, f64::from(step) / steps);
                boxes.extend(bounds(&pose).map(|(low, high)| (low - margin, high + margin)));
            }
        }
        boxes.into_iter().reduce(|(low, high), (l, h)| (low.min(l), high.max(h)))
    }
}
