//! Shadows of emissive quadrilaterals, and what pixels show.

use glam::Vec3;
use voxlume_reference::{Panel, Quantity, Seen, Tracer};
use voxlume_scene::Scene;

use crate::stage::*;

/// A lamp at height 1 over [0,x] × [0,z] that shines down.
fn lamp(x: f32, z: f32) -> [Vec3; 4] {
    [Vec3::new(0.0, 1.0, 0.0), Vec3::new(x, 1.0, 0.0), Vec3::new(x, 1.0, z), Vec3::new(0.0, 1.0, z)]
}

fn panel(corners: [Vec3; 4], double_sided: bool) -> Quantity {
    Quantity::PanelShadow(Panel { corners: corners.map(Vec3::as_dvec3), double_sided })
}

/// Form factor from a point of the floor to a parallel rectangle at height 1 with a corner above it (Siegel and
/// Howell, configuration B-4).
fn form_factor(x: f64, z: f64) -> f64 {
    let (p, q) = ((1.0 + x * x).sqrt(), (1.0 + z * z).sqrt());
    (x / p * (z / p).atan() + z / q * (x / q).atan()) / (2.0 * PI)
}

fn scene(occluder: &[[Vec3; 4]]) -> Scene {
    let mut scene = floor(grey(0.5));
    add_quads(&mut scene, emissive(3.0), &[lamp(2.0, 1.0)]);
    add_quads(&mut scene, grey(0.5), occluder);
    scene
}

/// A board halfway up hides the lamp beyond x = 1: weighted by what they give, more than half is left.
#[test]
fn visibility_is_weighted_by_irradiance() {
    let board = [
        Vec3::new(0.5, 0.5, -0.1),
        Vec3::new(3.0, 0.5, -0.1),
        Vec3::new(3.0, 0.5, 3.0),
        Vec3::new(0.5, 0.5, 3.0),
    ];
    let camera = look(Vec3::new(-1.0, 0.4, -0.3), Vec3::ZERO);
    let quantity = panel(lamp(2.0, 1.0), false);
    let expected = form_factor(1.0, 1.0) / form_factor(2.0, 1.0);
    assert!(expected > 0.6);
    // The pixels' 10⁻⁴ of the view move the answer by no more than that.
    let (mean, error) = measure(&scene(&[board]), &request(camera.clone(), quantity, 1000));
    assert!(
        error < 0.001 && (mean - expected).abs() < 3.0 * error + 2e-4,
        "{mean} ± {error}, expected {expected}"
    );
    assert_eq!(measure(&scene(&[]), &request(camera, quantity, 16)), (1.0, 0.0));
}

#[test]
fn a_back_gives_nothing_unless_it_emits() {
    let camera = look(Vec3::new(-1.0, 0.4, -0.3), Vec3::ZERO);
    let mut corners = lamp(2.0, 1.0);
    corners.reverse();
    let of =
        |double_sided| measure(&scene(&[]), &request(camera.clone(), panel(corners, double_sided), 16)).0;
    assert_eq!((of(false), of(true)), (0.0, 1.0));
}

#[test]
fn pixels_show_nothing_a_surface_or_an_emitter() {
    let tracer = Tracer::new(&scene(&[])).unwrap();
    let look_at = |eye: Vec3, target: Vec3| tracer.look(&look(eye, target), 2, 1).unwrap();
    let eye = Vec3::new(0.5, 0.5, 0.5);
    assert_eq!(look_at(eye, Vec3::ZERO), [Seen::Surface; 2]);
    assert_eq!(look_at(eye, Vec3::new(1.0, 1.0, 0.5)), [Seen::Emitter; 2]);
    assert_eq!(look_at(eye, Vec3::new(-5.0, 3.0, 0.5)), [Seen::Nothing; 2]);
    assert_eq!(tracer.look(&look(eye, Vec3::ZERO), 0, 1).unwrap_err().to_string().lines().count(), 1);
}
