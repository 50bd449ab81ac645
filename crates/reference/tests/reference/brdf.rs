//! The reflection model against quadratures of glTF's formulas, written out anew in f64.

use glam::{DVec3, Vec3, Vec4};
use voxlume_reference::{Gather, Quantity};
use voxlume_scene::{LightKind, Material};

use crate::stage::*;

/// BRDF × cosine for unit vectors over the normal +y: glTF 2.0 appendix B with height-correlated Smith.
fn reflected(base: f64, metallic: f64, roughness: f64, v: DVec3, l: DVec3) -> f64 {
    let (nv, nl) = (v.y, l.y);
    if nl <= 0.0 {
        return 0.0;
    }
    let h = (v + l).normalize();
    let a2 = roughness.powi(4);
    let d = a2 / (PI * (h.y * h.y * (a2 - 1.0) + 1.0).powi(2));
    let lambda = |c: f64| ((1.0 + a2 * (1.0 / (c * c) - 1.0)).sqrt() - 1.0) / 2.0;
    let g = 1.0 / (1.0 + lambda(nv) + lambda(nl));
    let f0 = 0.04 + (base - 0.04) * metallic;
    let f = f0 + (1.0 - f0) * (1.0 - v.dot(h)).powi(5);
    let diffuse = (1.0 - f) * base * (1.0 - metallic) / PI;
    (diffuse + f * d * g / (4.0 * nv * nl)) * nl
}

/// ∫ f dω over the cone of half-angle `half` around `axis`.
fn over_cone(axis: DVec3, half: f64, f: impl Fn(DVec3) -> f64) -> f64 {
    let (side, up) = axis.any_orthonormal_pair();
    let (rows, columns) = (500, 500);
    let dh = (1.0 - half.cos()) / f64::from(rows);
    let dp = 2.0 * PI / f64::from(columns);
    let cell = |i: i32, j: i32| {
        let cos = 1.0 - (f64::from(i) + 0.5) * dh;
        let (sin_p, cos_p) = ((f64::from(j) + 0.5) * dp).sin_cos();
        f((side * cos_p + up * sin_p) * (1.0 - cos * cos).sqrt() + axis * cos)
    };
    (0..rows).flat_map(|i| (0..columns).map(move |j| (i, j))).map(|(i, j)| cell(i, j)).sum::<f64>() * dh * dp
}

const MATERIALS: [(f64, f64, f64); 5] =
    [(0.8, 0.0, 1.0), (0.3, 0.0, 0.35), (0.9, 1.0, 0.35), (0.6, 0.5, 0.6), (1.0, 1.0, 1.0)];

fn material((base, metallic, roughness): (f64, f64, f64)) -> Material {
    let base_color = Vec4::new(base as f32, base as f32, base as f32, 1.0);
    Material { base_color, metallic: metallic as f32, roughness: roughness as f32, ..Material::default() }
}

const EYE: DVec3 = DVec3::new(0.8, 0.6, 0.0);

#[test]
fn reflection_of_a_constant_sky() {
    for parameters in MATERIALS {
        let mut scene = floor(material(parameters));
        scene.sky = Vec3::ONE;
        let (base, metallic, roughness) = parameters;
        let expected = over_cone(DVec3::Y, PI / 2.0, |l| reflected(base, metallic, roughness, EYE, l));
        let camera = look(EYE.as_vec3(), Vec3::ZERO);
        let (mean, error) = measure(&scene, &request(camera, Quantity::Final { bounces: 0 }, 1000));
        assert!(error < 0.005 * expected);
        assert!((mean - expected).abs() < 3.0 * error + 5e-4, "{parameters:?}: {mean} {error} {expected}");
    }
}

/// A wide sun near the mirror direction: lamp sampling and lobe sampling both matter.
#[test]
fn reflection_of_a_wide_sun() {
    let toward = DVec3::new(-0.75, 0.65, 0.1).normalize();
    let half = 10f64.to_radians();
    for parameters in MATERIALS {
        let mut scene = floor(material(parameters));
        let direction = -toward.as_vec3();
        let angular_diameter = 2.0 * half as f32;
        add_light(&mut scene, LightKind::Directional { direction, angular_diameter }, 2.0);
        let radiance = 2.0 / (PI * half.sin().powi(2));
        let (base, metallic, roughness) = parameters;
        let expected = radiance * over_cone(toward, half, |l| reflected(base, metallic, roughness, EYE, l));
        let camera = look(EYE.as_vec3(), Vec3::ZERO);
        let (mean, error) = measure(&scene, &request(camera, Quantity::Final { bounces: 0 }, 500));
        assert!(error < 0.005 * expected);
        assert!((mean - expected).abs() < 3.0 * error + 2e-4 * expected, "{parameters:?}: {mean} {expected}");
    }
}

/// The same for an emissive disc, which takes the other half of the code: overhead, seen from EYE.
#[test]
fn reflection_of_an_emissive_disc() {
    for parameters in MATERIALS {
        let mut scene = floor(material(parameters));
        add_disc(&mut scene, emissive(4.0), Vec3::Y, 0.9, false);
        let half = 0.9f64.atan();
        let (base, metallic, roughness) = parameters;
        let expected = 4.0 * over_cone(DVec3::Y, half, |l| reflected(base, metallic, roughness, EYE, l));
        let camera = look(EYE.as_vec3() * 1.2, Vec3::ZERO);
        let (mean, error) = measure(&scene, &request(camera, Quantity::Final { bounces: 0 }, 1000));
        assert!(error < 0.005 * expected);
        assert!((mean - expected).abs() < 3.0 * error + 5e-4 * expected, "{parameters:?}: {mean} {expected}");
    }
}

/// A mirror shows what lies behind it, whatever of the light's samples miss.
#[test]
fn a_mirror_shows_an_emitter_and_a_lobe_averages_it() {
    let mirror = Material { metallic: 1.0, roughness: 0.0, ..Material::default() };
    let mut scene = floor(mirror);
    add_disc(&mut scene, emissive(4.0), Vec3::new(-0.8, 0.6, 0.0), 0.05, false);
    let camera = look(EYE.as_vec3(), Vec3::ZERO);
    expect(&scene, &request(camera.clone(), Quantity::Final { bounces: 0 }, 50), 4.0);
    let gather = Gather { bounces: 0, sky: false, emission: true };
    expect(&scene, &request(camera, Quantity::Specular(gather), 50), 4.0);
}

/// The specular lobe around a normal-on view is even in azimuth: half of an emitting hemisphere is half.
#[test]
fn half_a_surrounding_fills_half_a_lobe() {
    for roughness in [0.3f32, 0.6, 1.0] {
        let mut scene = floor(Material { roughness, ..grey(0.5) });
        let high = Vec3::new(WIDE, WIDE, WIDE);
        let walls = room(Vec3::new(0.0, -WIDE, -WIDE), high);
        add_quads(&mut scene, emissive(4.0), &walls[1..4]);
        add_quads(&mut scene, emissive(4.0), &walls[5..]);
        let camera = look(Vec3::new(0.0, 2.0, 0.0), Vec3::ZERO);
        let gather = Gather { bounces: 0, sky: false, emission: true };
        let (mean, error) = measure(&scene, &request(camera, Quantity::Specular(gather), 1000));
        assert!((mean - 2.0).abs() < 3.0 * error + 2e-3, "{roughness}: {mean} {error}");
        assert!(error < 0.01);
    }
}

/// Emitter sampling and lobe sampling of the restricted lobe must agree on its normalisation: a small
/// emitter's mean radiance over the lobe is its density there times its solid angle.
#[test]
fn a_small_emitter_in_a_rough_lobe() {
    let roughness = 0.8f64;
    let mut scene = floor(Material { roughness: roughness as f32, ..grey(0.5) });
    add_disc(&mut scene, emissive(100.0), Vec3::new(-0.4, 1.5, 0.3), 0.02, false);
    let a2 = roughness.powi(4);
    let density = |l: DVec3| {
        let h = (EYE + l).normalize();
        let d = a2 / (PI * (h.y * h.y * (a2 - 1.0) + 1.0).powi(2));
        let g1 = 2.0 * EYE.y / (EYE.y + (a2 + (1.0 - a2) * EYE.y * EYE.y).sqrt());
        g1 * d / (4.0 * EYE.y)
    };
    let above = over_cone(DVec3::Y, PI / 2.0, density);
    let to = DVec3::new(-0.4, 1.5, 0.3);
    let solid_angle = PI * 0.02 * 0.02 * to.normalize().y / to.length_squared();
    let expected = 100.0 * density(to.normalize()) / above * solid_angle;
    let gather = Gather { bounces: 0, sky: false, emission: true };
    let camera = look(EYE.as_vec3(), Vec3::ZERO);
    let (mean, error) = measure(&scene, &request(camera, Quantity::Specular(gather), 1000));
    assert!(error < 0.005 * expected, "{error}");
    assert!((mean - expected).abs() < 3.0 * error + 1e-3 * expected, "{mean} {error} {expected}");
}
