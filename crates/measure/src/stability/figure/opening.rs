//! Light through an opening of known size.

use std::f64::consts::PI;

use glam::{DAffine3, DVec3};
use voxlume::{Camera, Picture, Scene, Value};

use super::{Figure, Figures};
use crate::stability::bench::{Bench, grey};

/// How much wider than it is a slit in a roof of sheets shows itself to the floor, over where its edge lies in a voxel.
pub fn between_sheets(bench: &Bench<'_>, scene: &Scene) -> Figures {
    sweep(bench, scene, 0.0)
}

/// The same of a roof of boxes, three voxels thick.
pub fn between_boxes(bench: &Bench<'_>, scene: &Scene) -> Figures {
    sweep(bench, scene, 3.0)
}

/// Of the slit, voxels.
const WIDTH: f64 = 1.7;
/// Of the scene: the roof's lower side, and half the room's sides.
const HEIGHT: f64 = 1.0;
const HALF: f64 = 1.0;

/// Both rims of the slit are known to half a square of a voxel's face, a tenth of a voxel.
const BOUND: f64 = 0.2;

fn sweep(bench: &Bench<'_>, scene: &Scene, thickness: f64) -> Figures {
    let voxel = f64::from(bench.grid(scene).voxel_size);
    // The middle of the grid is a border of voxels.
    let figure = |offset: f64| {
        let near = (offset - 1.0) * voxel;
        let far = near + WIDTH * voxel;
        let scene = with_slit(scene, near, far, thickness * voxel);
        let rays = [("diffuse", "rays", Value::Number(64.0))];
        let image = bench.image(&scene, "diffuse", &rays)?;
        let expected =
            over_image(&image, &scene.cameras[0], |point| share(point, near, far, thickness * voxel));
        let value = (grey(&image) / PI / expected - 1.0) * WIDTH;
        Ok(Figure::swept("width too much, voxels,", "edge, voxels", offset, value, Some(BOUND)))
    };
    (0..10).map(|step| figure(f64::from(5 + 10 * step) / 100.0)).collect()
}

/// Mean of a function of the points of the floor that a camera straight above its middle sees, x to the right and z down.
fn over_image(image: &Picture, camera: &Camera, value: impl Fn([f64; 2]) -> f64) -> f64 {
    let half_height = camera.eye.y * f64::from(camera.vertical_fov / 2.0).tan();
    let [width, height] = [image.width, image.height].map(f64::from);
    let place = |index: u32, count: f64| (2.0 * (f64::from(index) + 0.5) - count) / height * half_height;
    let sum: f64 = (0..image.height)
        .flat_map(|row| (0..image.width).map(move |column| (row, column)))
        .map(|(row, column)| value([place(column, width), place(row, height)]))
        .sum();
    sum / (width * height)
}

/// The scene with its two halves of the roof pulled apart. They are as long and wide as 1 and as thick as 1, or sheets.
fn with_slit(scene: &Scene, near: f64, far: f64, thickness: f64) -> Scene {
    let mut scene = scene.clone();
    for (name, low, high) in [("left", -HALF, near), ("right", far, HALF)] {
        for roof in scene.instances.iter_mut().filter(|instance| instance.name == name) {
            let scale = DVec3::new(high - low, thickness.max(1e-9), 2.0 * HALF);
            let corner = DVec3::new(low, HEIGHT, -HALF);
            roof.transform = DAffine3::from_scale_rotation_translation(scale, glam::DQuat::IDENTITY, corner);
        }
    }
    scene
}

/// What of the light of an even sky reaches a point of the floor: the form factor of what it sees of the slit, a rectangle as high as
/// each rim that bounds it.
fn share([x, z]: [f64; 2], near: f64, far: f64, thickness: f64) -> f64 {
    // Of a rectangle from the point's foot to (a, b) at height h.
    let corner = |a: f64, b: f64, h: f64| {
        let [x, y] = [a, b].map(|side: f64| (side * side + h * h).sqrt());
        (a / x * (b / x).atan() + b / y * (a / y).atan()) / (2.0 * PI)
    };
    // A rim beyond the foot bounds what is seen by its upper edge, one on the foot's side by its lower.
    let to = |edge: f64, beyond: bool| {
        let height = if beyond { HEIGHT + thickness } else { HEIGHT };
        // The walls at the slit's ends are as high as the roof's lower side.
        let end = |to: f64| corner(edge, to * height / HEIGHT, height);
        end(HALF - z) + end(HALF + z)
    };
    (to(far - x, far > x) - to(near - x, near < x)).max(0.0)
}
