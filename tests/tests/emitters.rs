//! Light of what emits and of wide suns, against closed forms.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use std::f64::consts::PI;

use voxlume::{Emission, Passes, Renderer, Request, Scene, Value};
use voxlume_tests::{form_factor, gi, gpu, mean, picture, plan_for, scene_from};

fn request(output: &str) -> Request {
    Request { resolution: Some(64), output: Some(output.into()), ..Request::image(32, 32) }
}

/// A dark floor of 4 × 4 with something over it, seen from above but for the lamp's own pixels: a camera beside it looks at the
/// floor's middle.
fn floor_under(things: &str, lights: &str) -> Scene {
    scene_from(&format!(
        r#"(
            materials: {{"dark": (base_color: 0), "lamp": (base_color: 0, emission: 10), "sheet": (base_color: 0, emission: 10, double_sided: true)}},
            objects: [(name: "floor", material: "dark", shape: Grid(size: (4, 4))), {things}],
            lights: [{lights}],
            cameras: [(name: "beside", eye: (0, 1.5, 1.9), target: (0, 0, 0), fov_deg: 1)],
        )"#
    ))
}

/// The mean of an image's first channel.
fn red(renderer: &Renderer<'_>, name: &str) -> f64 {
    mean(&picture(renderer, name))[0]
}

fn expect(scene: &Scene, output: &str, emission: Emission, expected: f64, tolerance: f64) {
    let plan = plan_for(&gi(), scene, &request(output));
    assert_eq!(plan.emission, emission);
    let mut renderer = Renderer::new(gpu(), plan, scene).unwrap();
    renderer.render(scene, &scene.cameras[0], Passes::Changed).unwrap();
    let found = red(&renderer, output);
    assert!((found / expected - 1.0).abs() < tolerance, "{found}, expected {expected}");
}

/// A sphere of radiance L and radius r gives πL(r/d)² at a distance d straight below it. One of 48 segments has 0.5 % less of a
/// silhouette. Its many triangles are drawn by chance, 64 rays for each tile of pixels: 2 % are left of that.
#[test]
fn a_bulb_gives_what_its_surface_sends() {
    for radius in [0.05, 0.2] {
        let bulb = format!(
            r#"(name: "bulb", material: "lamp", shape: Sphere(radius: {radius}, segments: 48), translate: (0, 1, 0))"#
        );
        let expected = PI * 10.0 * radius * radius;
        expect(&floor_under(&bulb, ""), "diffuse", Emission::Sampled, expected, 0.025);
    }
}

/// However it lies among the voxels: a bulb of half a voxel moves by an eighth of one at a time.
#[test]
fn a_bulb_that_moves_by_parts_of_a_voxel_stays_as_bright() {
    for step in 0..8 {
        let height = 1.0 + f64::from(step) * 4.0 / 64.0 / 8.0;
        let bulb = format!(
            r#"(name: "bulb", material: "lamp", shape: Sphere(radius: 0.03, segments: 24), translate: (0, {height}, 0))"#
        );
        let expected = PI * 10.0 * (0.03 / height).powi(2);
        expect(&floor_under(&bulb, ""), "diffuse", Emission::Sampled, expected, 0.04);
    }
}

/// Where voxels hold what is emitted, each side holds its own: a square that looks up gives the floor below it nothing, and one that
/// looks down what its form factor says, although it fills only parts of the voxels at its border. A tile of pixels has 192 rays.
#[test]
fn gathered_emission_belongs_to_its_side() {
    let square = |up: bool| {
        let corners = [(-0.47, -0.47), (-0.47, 0.47), (0.47, 0.47), (0.47, -0.47)];
        let corner = |&(x, z): &(f64, f64)| format!("({x}, 1, {z})");
        let list: Vec<String> = if up {
            corners.iter().map(corner).collect()
        } else {
            corners.iter().rev().map(corner).collect()
        };
        floor_under(
            &format!(r#"(name: "square", material: "lamp", shape: Quad(corners: [{}])),"#, list.join(", ")),
            "",
        )
    };
    let found = |scene: &Scene| {
        let gather = ("light".into(), "emission".into(), Value::Word("gather".into()));
        let plan = plan_for(&gi(), scene, &Request { set: vec![gather], ..request("diffuse") });
        assert_eq!(plan.emission, Emission::Gathered);
        let mut renderer = Renderer::new(gpu(), plan, scene).unwrap();
        renderer.render(scene, &scene.cameras[0], Passes::Changed).unwrap();
        red(&renderer, "diffuse")
    };
    assert_eq!(found(&square(true)), 0.0);
    let expected = 10.0 * PI * form_factor::of_rectangle([-0.47, 0.47], [-0.47, 0.47], 1.0);
    let found = found(&square(false));
    assert!((found / expected - 1.0).abs() < 0.05, "{found}, expected {expected}");
}

/// Sheets that look away give nothing, those of two sides do.
#[test]
fn the_back_of_an_emitter_is_dark() {
    let sheets = |material: &str| {
        let sheet = |i: usize| {
            let x = -0.5 + 0.05 * i as f64;
            let corners = format!("({x}, 1, -0.5), ({x}, 1, 0.5), ({0}, 1, 0.5), ({0}, 1, -0.5)", x + 0.05);
            format!(r#"(name: "{i}", material: "{material}", shape: Quad(corners: [{corners}])),"#)
        };
        floor_under(&(0..20).map(sheet).collect::<String>(), "")
    };
    let renderer = |scene: &Scene| {
        let mut renderer = Renderer::new(gpu(), plan_for(&gi(), scene, &request("diffuse")), scene).unwrap();
        renderer.render(scene, &scene.cameras[0], Passes::Changed).unwrap();
        red(&renderer, "diffuse")
    };
    assert_eq!(renderer(&sheets("lamp")), 0.0);
    let expected = 10.0 * PI * form_factor::of_rectangle([-0.5, 0.5], [-0.5, 0.5], 1.0);
    let found = renderer(&sheets("sheet"));
    assert!((found / expected - 1.0).abs() < 0.02, "{found}, expected {expected}");
}

/// Of a sun as wide as this, on a wall that it just touches, a part is below the horizon: Snyder's closed form. A white floor shows
/// irradiance over π.
#[test]
fn a_wide_sun_gives_what_of_it_is_above_the_horizon() {
    let half = 75.0_f64.to_radians();
    for elevation in [90.0_f64, 45.0, 10.0] {
        let cosine = elevation.to_radians().sin();
        let sine2 = half.sin().powi(2);
        let over = if cosine * cosine >= sine2 {
            cosine
        } else {
            let sine = (1.0 - cosine * cosine).sqrt();
            let x = (1.0 / sine2 - 1.0).sqrt();
            let y = -x * cosine / sine;
            let edge = sine * (1.0 - y * y).sqrt();
            (cosine * y.acos() - x * edge + (edge / x).atan() / sine2) / PI
        };
        let (x, y) = (-elevation.to_radians().cos(), -elevation.to_radians().sin());
        let sun = format!(
            r#"Directional(name: "sun", direction: ({x}, {y}, 0), irradiance: 2, angular_diameter_deg: 150)"#
        );
        let scene = scene_from(&format!(
            r#"(
                materials: {{"matte": (base_color: 0.5)}},
                objects: [(name: "floor", material: "matte", shape: Grid(size: (4, 4)))],
                lights: [{sun}],
                cameras: [(name: "beside", eye: (0, 1.5, 1.9), target: (0, 0, 0), fov_deg: 1)],
            )"#
        ));
        let mut renderer = Renderer::new(gpu(), plan_for(&gi(), &scene, &request("final")), &scene).unwrap();
        renderer.render(&scene, &scene.cameras[0], Passes::Changed).unwrap();
        // Dielectrics of roughness 1 reflect 0.96 of it diffusely, and of the rest about as much as in even light.
        let diffuse = 0.5 / PI * 2.0 * over;
        let found = red(&renderer, "final");
        assert!((0.95..1.05).contains(&(found / diffuse)), "{elevation}: {found}, about {diffuse}");
    }
}
