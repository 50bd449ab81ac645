//! Rays from the camera.

use glam::{DVec3, Vec3};
use voxlume_scene::Camera;

use crate::triangle::Ray;

/// A pinhole camera, relative to the geometry's origin, for pictures of one size.
pub(crate) struct View {
    eye: Vec3,
    forward: Vec3,
    /// Half the picture's width and height at distance 1.
    right: Vec3,
    up: Vec3,
    size: [f32; 2],
}

impl View {
    pub(crate) fn new(camera: &Camera, width: u32, height: u32, origin: DVec3) -> Self {
        let half_height = (camera.vertical_fov / 2.0).tan();
        let aspect = width as f32 / height as f32;
        View {
            eye: (camera.eye - origin).as_vec3(),
            forward: camera.forward,
            right: camera.forward.cross(camera.up) * (half_height * aspect),
            up: camera.up * half_height,
            size: [width as f32, height as f32],
        }
    }

    /// The ray through a point of the picture in pixels, x to the right and y down from the top left.
    pub(crate) fn ray(&self, x: f32, y: f32) -> Ray {
        let [width, height] = self.size;
        let across = self.right * (2.0 * x / width - 1.0);
        let upwards = self.up * (1.0 - 2.0 * y / height);
        let direction = (self.forward + across + upwards).normalize();
        Ray { origin: self.eye, direction, far: f32::INFINITY }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_corners_of_the_picture() {
        let camera = Camera {
            name: "c".into(),
            eye: DVec3::new(1e6, 2.0, 3.0),
            forward: Vec3::NEG_Z,
            up: Vec3::Y,
            vertical_fov: std::f32::consts::FRAC_PI_2,
        };
        let view = View::new(&camera, 200, 100, DVec3::new(1e6, 0.0, 0.0));
        let top_left = view.ray(0.0, 0.0);
        assert_eq!(top_left.origin, Vec3::new(0.0, 2.0, 3.0));
        assert!(top_left.direction.distance(Vec3::new(-2.0, 1.0, -1.0).normalize()) < 1e-6);
        assert!(view.ray(100.0, 50.0).direction.distance(Vec3::NEG_Z) < 1e-6);
        assert!(view.ray(200.0, 100.0).direction.distance(Vec3::new(2.0, -1.0, -1.0).normalize()) < 1e-6);
    }
}
