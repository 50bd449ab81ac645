//! Lights, as `struct Light` in wgsl/common/light.wgsl, and the matrices of their shadow maps.

use bytemuck::{Pod, Zeroable};
use glam::camera::rh::{proj::directx, view};
use glam::{Mat4, Vec2, Vec3, Vec4};
use voxlume_graph::{AREA_LIGHT_LIMIT, EMITTER_LIMIT, Emission, Plan, SceneFacts};
use voxlume_scene::{EmissivePolygon, Light as SceneLight, LightKind, Scene};

#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub(crate) struct Light {
    pub(super) position: Vec3,
    pub(super) kind: u32,
    pub(super) intensity: Vec3,
    pub(super) size: f32,
    pub(super) direction: Vec3,
    pub(super) shadow_layer: i32,
    pub(super) falloff: Vec2,
    pub(super) area: f32,
    pub(super) padding: f32,
    pub(super) corners: [Vec4; 4],
}

const DIRECTIONAL: u32 = 0;
const POINT: u32 = 1;
const SPOT: u32 = 2;
const AREA: u32 = 3;

/// The lights, at least one, as buffers can't be empty; and a matrix for each shadow map's layer.
pub(crate) struct Lights {
    pub count: u32,
    pub lights: Vec<Light>,
    pub matrices: Vec<Mat4>,
}

pub(crate) fn lights(scene: &Scene, plan: &Plan, facts: &SceneFacts) -> Lights {
    let radius = facts.bounds.map_or(1.0, |(low, high)| (high - low).length() as f32 / 2.0).max(1e-30);
    let mut list = Vec::new();
    let mut matrices = Vec::new();
    for light in &scene.lights {
        let layer = matrices.len() as i32;
        let Maps { views, extent, depth } = shadow_maps(light, plan, facts, radius);
        let wide = f32::from(u8::from(SceneFacts::is_wide(&light.kind)));
        let mut packed = punctual(light, plan, layer);
        packed.corners[0] = Vec4::new(extent, depth, wide, 0.0);
        list.push(packed);
        matrices.extend(views);
    }
    let origin = plan.grid.centre;
    if plan.emission == Emission::AreaLights {
        let polygons = scene.emissive_polygons(origin, AREA_LIGHT_LIMIT).unwrap_or_default();
        list.extend(polygons.iter().map(area));
    }
    let count = list.len() as u32;
    if plan.emission == Emission::Sampled {
        list.extend(sampled(&scene.emissive_pieces(origin, EMITTER_LIMIT).unwrap_or_default()));
    }
    list.resize(list.len().max(1), Light::zeroed());
    Lights { count, lights: list, matrices }
}

/// As many matrices as wgsl/common/shadow_map.wgsl has: one for each layer that a texture can have.
pub(crate) fn padded(matrices: &[Mat4]) -> Vec<Mat4> {
    let mut all = matrices.to_vec();
    all.resize(256.max(matrices.len()), Mat4::IDENTITY);
    all
}

fn punctual(light: &SceneLight, plan: &Plan, shadow_layer: i32) -> Light {
    let base = Light { intensity: light.intensity, shadow_layer, ..Light::zeroed() };
    let relative = |position: glam::DVec3| (position - plan.grid.centre).as_vec3();
    match light.kind {
        LightKind::Directional { direction, angular_diameter } => {
            // Just short of a right angle, whose tangent is infinite and in `f32` may be negative.
            let half = (angular_diameter / 2.0).min(std::f32::consts::FRAC_PI_2 - 1e-4);
            Light { kind: DIRECTIONAL, position: -direction, size: half.tan(), ..base }
        }
        LightKind::Point { position, radius } => {
            Light { kind: POINT, position: relative(position), size: radius, ..base }
        }
        LightKind::Spot { position, direction, radius, inner, outer } => {
            // KHR_lights_punctual's recommended falloff.
            let scale = 1.0 / (inner.cos() - outer.cos()).max(1e-3);
            let falloff = Vec2::new(scale, -outer.cos() * scale);
            Light { kind: SPOT, position: relative(position), size: radius, direction, falloff, ..base }
        }
    }
}

/// Polygons that follow the lights, with their shares of all power.
fn sampled(polygons: &[EmissivePolygon]) -> Vec<Light> {
    let mut list: Vec<Light> = polygons.iter().map(area).collect();
    let power = |light: &Light| {
        let sides = 1.0 + f64::from(light.size);
        f64::from(light.intensity.element_sum()) * f64::from(light.area) * sides
    };
    let all = list.iter().map(power).sum::<f64>().max(f64::MIN_POSITIVE);
    let mut before = 0.0;
    for light in &mut list {
        before += power(light) / all;
        light.falloff = Vec2::new(before as f32, (power(light) / all) as f32);
    }
    list
}

fn area(polygon: &EmissivePolygon) -> Light {
    let corner = |i: usize| polygon.corners[i.min(polygon.corners.len() - 1)];
    let corners = [corner(0), corner(1), corner(2), corner(3)];
    let cross = (corners[2] - corners[0]).cross(corners[3] - corners[1]);
    Light {
        kind: AREA,
        position: corners.iter().sum::<Vec3>() / 4.0,
        intensity: polygon.radiance,
        size: f32::from(u8::from(polygon.double_sided)),
        direction: cross.normalize_or_zero(),
        shadow_layer: -1,
        area: cross.length() / 2.0,
        corners: corners.map(|c| c.extend(0.0)),
        ..Light::zeroed()
    }
}

/// The shadow maps of a light.
struct Maps {
    /// A matrix for each.
    views: Vec<Mat4>,
    /// Width of a map in world units; of a point or spot light's at a unit's distance.
    extent: f32,
    /// World units from depth 0 to 1, of a directional light.
    depth: f32,
}

fn shadow_maps(light: &SceneLight, plan: &Plan, facts: &SceneFacts, radius: f32) -> Maps {
    let relative = |position: glam::DVec3| (position - plan.grid.centre).as_vec3();
    let near = radius * 1e-3;
    match light.kind {
        LightKind::Directional { direction, .. } => {
            let view = view::look_to_mat4(Vec3::ZERO, direction, direction.any_orthonormal_vector());
            // Around the scene, with room for what rounding takes.
            let (low, high) = facts.bounds.unwrap_or((plan.grid.centre, plan.grid.centre));
            let corners = (0..8).map(|i| {
                let pick = |axis: usize| if i >> axis & 1 == 0 { low[axis] } else { high[axis] };
                view.transform_point3(relative(glam::DVec3::new(pick(0), pick(1), pick(2))))
            });
            let (low, high) = corners.fold((Vec3::INFINITY, Vec3::NEG_INFINITY), |(low, high), corner| {
                (low.min(corner), high.max(corner))
            });
            let (low, high) = (low - 0.02 * radius, high + 0.02 * radius);
            let projection = directx::orthographic(low.x, high.x, low.y, high.y, -high.z, -low.z);
            let extent = (high - low).truncate().max_element();
            Maps { views: vec![projection * view], extent, depth: high.z - low.z }
        }
        LightKind::Spot { position, direction, outer, .. } => {
            let eye = relative(position);
            let view = view::look_to_mat4(eye, direction, direction.any_orthonormal_vector());
            let far = eye.length() + 2.0 * radius;
            let angle = (2.0 * outer).min(3.0);
            let views = vec![directx::perspective(angle, 1.0, near, far) * view];
            Maps { views, extent: 2.0 * (angle / 2.0).tan(), depth: 0.0 }
        }
        LightKind::Point { position, .. } => {
            let eye = relative(position);
            let far = eye.length() + 2.0 * radius;
            let projection = directx::perspective(std::f32::consts::FRAC_PI_2, 1.0, near, far);
            let axes = [Vec3::X, Vec3::NEG_X, Vec3::Y, Vec3::NEG_Y, Vec3::Z, Vec3::NEG_Z];
            let view = |axis: Vec3| view::look_to_mat4(eye, axis, axis.any_orthonormal_vector());
            Maps { views: axes.map(|axis| projection * view(axis)).to_vec(), extent: 2.0, depth: 0.0 }
        }
    }
}
