//! The frame's uniform, as `struct Frame` in wgsl/common/frame.wgsl.

use bytemuck::{Pod, Zeroable};
use glam::camera::rh::{proj::directx, view};
use glam::{Mat4, Vec3};
use voxlume_graph::{Plan, SceneFacts, fixed_point_scale};
use voxlume_scene::{Camera, Scene};

#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub(crate) struct Frame {
    pub(super) view_projection: Mat4,
    pub(super) eye: Vec3,
    pub(super) near: f32,
    pub(super) forward: Vec3,
    pub(super) light_count: u32,
    pub(super) right: Vec3,
    pub(super) emission_max: f32,
    pub(super) up: Vec3,
    pub(super) level_count: u32,
    pub(super) grid_min: Vec3,
    pub(super) voxel_size: f32,
    pub(super) grid_size: [u32; 3],
    pub(super) texture_size: u32,
    pub(super) sky: Vec3,
    pub(super) attribute_scale: f32,
    pub(super) screen: [u32; 2],
    pub(super) padding: [u32; 2],
    pub(super) level_words: [u32; 16],
}

impl Frame {
    pub fn new(plan: &Plan, facts: &SceneFacts, scene: &Scene, camera: &Camera, light_count: u32) -> Frame {
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
        let mut level_words = [0; 16];
        for (to, from) in level_words.iter_mut().zip(grid.word_offsets().0) {
            *to = from;
        }
        let emission =
            scene.materials.iter().map(|material| material.emission.max_element()).fold(0.0, f32::max);
        Frame {
            view_projection: projection * view,
            eye,
            near,
            forward: camera.forward,
            light_count,
            right: right * half_height * aspect,
            emission_max: emission.max(f32::MIN_POSITIVE),
            up: up * half_height,
            level_count: grid.levels(),
            grid_min: grid.min(),
            voxel_size: grid.voxel_size,
            grid_size: grid.size,
            texture_size: facts.texture_size,
            sky: scene.sky,
            attribute_scale: fixed_point_scale(plan.triangles),
            screen: plan.screen,
            padding: [0; 2],
            level_words,
        }
    }
}
