//! The node tree: instances, lights and cameras in world space.

use glam::{DAffine3, DMat3, DMat4, DQuat, DVec3, Vec3};
use gltf::json::extensions::scene::khr_lights_punctual::{Light as JsonLight, Type};
use gltf::json::validation::Checked;
use gltf::json::{Index, Node, Root};
use voxlume_fault::{Fault, Faults};

use super::at;
use crate::{Camera, Light, LightKind, rule};

/// A node that the scene reaches.
pub(super) struct Placed {
    /// Index in the file.
    pub(super) node: usize,
    /// Its name, or `node N`.
    pub(super) name: String,
    /// To the world.
    pub(super) transform: DAffine3,
}

/// Walks the file's scene; without one, every node that is nobody's child.
pub(super) fn place(root: &Root) -> Result<Vec<Placed>, Faults> {
    let mut faults = Faults::default();
    let scene = root.scene.map_or(0, |scene| scene.value());
    let roots: Vec<usize> = match root.scenes.get(scene) {
        Some(scene) => scene.nodes.iter().map(Index::value).collect(),
        None => {
            let mut orphan = vec![true; root.nodes.len()];
            root.nodes.iter().flat_map(children).for_each(|child| orphan[child] = false);
            (0..orphan.len()).filter(|node| orphan[*node]).collect()
        }
    };
    let mut seen = vec![false; root.nodes.len()];
    let mut placed = Vec::new();
    let mut open: Vec<_> = roots.into_iter().rev().map(|node| (node, DAffine3::IDENTITY)).collect();
    while let Some((node, parent)) = open.pop() {
        // The specification wants a tree; a cycle would never end.
        if std::mem::replace(&mut seen[node], true) {
            faults.push(at(format!("nodes[{node}]"), "reached twice; nodes must form a tree"));
            continue;
        }
        let json = &root.nodes[node];
        let Some(local) = faults.gather(local(json).map_err(|e| at(format!("nodes[{node}]"), e))) else {
            continue;
        };
        let transform = parent * local;
        if !transform.is_finite() {
            faults.push(at(format!("nodes[{node}]"), "its transform is not finite"));
            continue;
        }
        let name = json.name.clone().unwrap_or_else(|| format!("node {node}"));
        placed.push(Placed { node, name, transform });
        open.extend(children(json).map(|child| (child, transform)).rev());
    }
    faults.into_result(placed)
}

fn children(node: &Node) -> impl DoubleEndedIterator<Item = usize> {
    node.children.iter().flatten().map(Index::value)
}

fn local(node: &Node) -> Result<DAffine3, String> {
    let affine = match node.matrix {
        Some(matrix) => {
            let matrix = DMat4::from_cols_array(&matrix.map(f64::from));
            if matrix.row(3) != glam::DVec4::W {
                return Err("the last row of its matrix is not 0 0 0 1".into());
            }
            DAffine3::from_mat4(matrix)
        }
        None => {
            let vector = |v: Option<[f32; 3]>, or| v.map_or(or, |v| Vec3::from(v).as_dvec3());
            let rotation = node.rotation.unwrap_or_default().0.map(f64::from);
            let rotation = DQuat::from_array(rotation);
            if !rotation.is_finite() || rotation.length_squared() == 0.0 {
                return Err("its rotation is not a quaternion".into());
            }
            DAffine3::from_scale_rotation_translation(
                vector(node.scale, DVec3::ONE),
                rotation.normalize(),
                vector(node.translation, DVec3::ZERO),
            )
        }
    };
    if affine.is_finite() { Ok(affine) } else { Err("its transform is not finite".into()) }
}

/// World directions of the node's −z and +y, unit and orthogonal; scale does not matter, mirroring does.
fn aim(transform: &DAffine3) -> Option<(Vec3, Vec3)> {
    let DMat3 { y_axis, z_axis, .. } = transform.matrix3;
    let forward = (-z_axis).try_normalize()?;
    let up = y_axis.try_normalize()?.reject_from_normalized(forward).try_normalize()?;
    Some((forward.as_vec3(), up.as_vec3()))
}

/// The node's light, KHR_lights_punctual: lux is taken as irradiance, candela as radiant intensity.
pub(super) fn light(root: &Root, placed: &Placed) -> Result<Option<Light>, Fault> {
    let node = root.nodes[placed.node].extensions.as_ref();
    let Some(index) = node.and_then(|e| e.khr_lights_punctual.as_ref()).map(|l| l.light.value()) else {
        return Ok(None);
    };
    let lights: &[JsonLight] = root.as_ref();
    let json = &lights[index];
    let here = |what: String| at(format!("lights[{index}]"), what);
    let intensity = Vec3::from(json.color) * json.intensity;
    rule::check(rule::LIGHT, "color × intensity", intensity).map_err(here)?;
    let position = placed.transform.translation;
    let flat = || at(format!("nodes[{}]", placed.node), "its light has no direction: the scale is 0");
    let direction = || aim(&placed.transform).map(|(forward, _)| forward).ok_or_else(flat);
    let kind = match (&json.type_, &json.spot) {
        (Checked::Valid(Type::Directional), _) => {
            LightKind::Directional { direction: direction()?, angular_diameter: 0.0 }
        }
        (Checked::Valid(Type::Spot), Some(spot)) => {
            let (inner, outer) = rule::spot(spot.inner_cone_angle, spot.outer_cone_angle)
                .map_err(|e| here(format!("spot: {e}")))?;
            LightKind::Spot { position, direction: direction()?, radius: 0.0, inner, outer }
        }
        _ => LightKind::Point { position, radius: 0.0 },
    };
    let name = json.name.clone().unwrap_or_else(|| format!("light {index}"));
    Ok(Some(Light { name, kind, intensity }))
}

/// The node's camera. An orthographic one is left out: every pass here traces from one point.
pub(super) fn camera(root: &Root, placed: &Placed) -> Result<Option<Camera>, Fault> {
    let Some(index) = root.nodes[placed.node].camera.map(|camera| camera.value()) else { return Ok(None) };
    let json = &root.cameras[index];
    let Some(perspective) = &json.perspective else { return Ok(None) };
    rule::check(rule::VERTICAL_FOV, "yfov", perspective.yfov)
        .map_err(|broken| at(format!("cameras[{index}]"), broken))?;
    let flat = || at(format!("nodes[{}]", placed.node), "its camera has no direction: the scale is 0");
    let (forward, up) = aim(&placed.transform).ok_or_else(flat)?;
    let name = json.name.clone().unwrap_or_else(|| placed.name.clone());
    let eye = placed.transform.translation;
    Ok(Some(Camera { name, eye, forward, up, vertical_fov: perspective.yfov }))
}
