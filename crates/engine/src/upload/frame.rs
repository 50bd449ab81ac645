//! The uniforms of a frame, as the structs of the same names in wgsl/common.

use bytemuck::{Pod, Zeroable};
use glam::camera::rh::{proj::directx, view};
use glam::{Mat4, Vec3};
use voxlume_graph::Plan;
use voxlume_scene::Camera as SceneCamera;

/// `struct Camera` in wgsl/common/camera.wgsl.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub(crate) struct Camera {
    pub(super) view_projection: Mat4,
    pub(super) eye: Vec3,
    pub(super) near: f32,
    pub(super) forward: Vec3,
    pub(super) voxel_size: f32,
    pub(super) right: Vec3,
    pub(super) padding_right: f32,
    pub(super) up: Vec3,
    pub(super) padding_up: f32,
    pub(super) screen: [u32; 2],
    pub(super) padding: [u32; 2],
}

/// `struct Environment` in wgsl/common/environment.wgsl.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub(crate) struct Environment {
    pub(crate) sky: Vec3,
    pub(crate) light_count: u32,
}

/// `struct Clock` in wgsl/common/clock.wgsl.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub(crate) struct Clock {
    pub(crate) seconds: f32,
    pub(crate) frame: u32,
    pub(super) padding: [u32; 2],
}

impl Clock {
    pub fn new(seconds: f32, frame: u32) -> Clock {
        Clock { seconds, frame, padding: [0; 2] }
    }
}

impl Camera {
    pub fn new(plan: &Plan, camera: &SceneCamera) -> Camera {
        let grid = &plan.grid;
        let [width, height] = plan.screen;
        let aspect = width as f32 / height as f32;
        let eye = (camera.eye - grid.centre).as_vec3();
        // Nearer than any surface that a voxel can tell from the camera's own.
        let near = grid.voxel_size * 0.05;
        let right = camera.forward.cross(camera.up).normalize();
        let up = right.cross(camera.forward);
        let view = view::look_to_mat4(eye, camera.forward, up);
        let projection = directx::perspective_infinite_reverse(camera.vertical_fov, aspect, near);
        let half_height = (camera.vertical_fov / 2.0).tan();
        Camera {
            view_projection: projection * view,
            eye,
            near,
            forward: camera.forward,
            voxel_size: grid.voxel_size,
            right: right * half_height * aspect,
            padding_right: 0.0,
            up: up * half_height,
            padding_up: 0.0,
            screen: plan.screen,
            padding: [0; 2],
        }
    }
}
