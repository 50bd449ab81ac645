//! One suite for every tracer: scenes whose answers are known in closed form, and the symmetries of the cube.

use std::f64::consts::PI;
use std::fmt;

use glam::{DAffine3, DMat3, DVec3};
use voxlume::{
    Gpu, Passes, Picture, Pipeline, Registry, Renderer, Request, Scene, SceneFacts, Source, Value, plan, twin,
};

use crate::{Error, Symmetry};

/// A floor under an open sky.
const FLOOR: &str = r#"(
    materials: { "white": (base_color: 0.8) },
    objects: [(name: "floor", material: "white", shape: Box(min: (-1, -1.1, -1), max: (1, -1, 1)))],
    sky: 1,
    cameras: [(name: "down", eye: (0, 0.5, 0), target: (0, -1, 0), up: (0, 0, 1), fov_deg: 8)],
)"#;

/// The same, and a square lid a unit wide half a unit over its middle.
const LID: &str = r#"(
    materials: { "white": (base_color: 0.8) },
    objects: [
        (name: "floor", material: "white", shape: Box(min: (-1, -1.1, -1), max: (1, -1, 1))),
        (name: "lid", material: "white", shape: Box(min: (-0.5, -0.5, -0.5), max: (0.5, -0.4, 0.5))),
    ],
    sky: 1,
    cameras: [(name: "under", eye: (0, -0.6, 0), target: (0, -1, 0), up: (0, 0, 1), fov_deg: 15)],
)"#;

/// A closed room with thick walls under a bright sky, seen from inside.
const SEALED: &str = r#"(
    materials: { "white": (base_color: 0.8) },
    objects: [
        (name: "outside", material: "white", shape: Box()),
        (name: "inside", material: "white", shape: Box(), scale: 0.85, inside_out: true),
    ],
    sky: 1,
    cameras: [(name: "inside", eye: (0.1, -0.1, 0.05), target: (0.5, -0.3, 0.4), fov_deg: 100)],
)"#;

/// A room whose black walls emit 1.
const FURNACE: &str = r#"(
    materials: { "glow": (base_color: 0, emission: 1) },
    objects: [(name: "furnace", shape: Box(min: (0, 0, 0), max: (1, 1, 1)), material: "glow", inside_out: true)],
    cameras: [(name: "middle", eye: (0.5, 0.5, 0.5), target: (0.5, 0.4, 1), fov_deg: 90)],
)"#;

/// Boxes of two colours on a floor, without a symmetry of their own. Their bounds have all of the cube, so that its symmetries leave
/// the grid as it is.
const STAIRS: &str = r#"(
    materials: { "white": (base_color: 0.8), "red": (base_color: (0.8, 0.1, 0.1)) },
    objects: [
        (name: "floor", material: "white", shape: Box(min: (-1, -1, -1), max: (1, -0.9, 1))),
        (name: "step", material: "red", shape: Box(min: (-0.9, -0.9, -0.8), max: (-0.2, 1, 0.2))),
        (name: "block", material: "white", shape: Box(min: (0.2, -0.9, 0.1), max: (0.7, -0.4, 0.8))),
    ],
    sky: 1,
    cameras: [(name: "above", eye: (0.9, 1.5, 2.2), target: (-0.1, -0.6, 0), fov_deg: 45)],
)"#;

/// An image, and parameters with which it is made: pass, name, value.
type Image = (&'static str, &'static [(&'static str, &'static str, &'static str)]);

/// All that is closed counts alike, however far.
const AO: Image = ("ao", &[("ambient_occlusion", "distance", "4"), ("ambient_occlusion", "falloff", "0")]);
const DIFFUSE: Image = ("diffuse", &[("light", "emission", "gather")]);

/// What a tracer was measured at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TracerFigure {
    /// What should hold.
    pub property: &'static str,
    /// How far it does not; 0 is perfect.
    pub figure: f64,
}

impl fmt::Display for TracerFigure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:<52} {:9.2e}", self.property, self.figure)
    }
}

/// Measures a tracer of the registry in the pipeline `gi`, in its storage format or another one, at 64³:
///
/// - *what is visible is open*: openness of a floor under the sky, less 1;
/// - *what is hidden is closed*: openness under a square lid, less the closed form;
/// - *a sealed room is dark*: irradiance in it over that of the sky outside;
/// - *a furnace is as bright as its walls*: irradiance over the closed form less 1, where black walls emit 1;
/// - *the cube's 48 symmetries change nothing*: the worst change of an image's mean openness, and of its mean irradiance.
///
/// # Errors
/// The tracer is unknown, its shaders are at fault, or the device fails.
pub fn run_tracer(
    gpu: &Gpu,
    registry: &Registry,
    tracer: &str,
    format: &str,
) -> Result<Vec<TracerFigure>, Error> {
    let bench = Bench { gpu, registry, tracer, format, pipeline: Pipeline::builtin("gi")? };
    let scene = |text: &str| Scene::parse(&Source::new("suite.ron", text));
    let mut figures = Vec::new();
    let mut add = |property, figure| figures.push(TracerFigure { property, figure });
    add("what is visible is open", mean(&bench.image(&scene(FLOOR)?, AO)?) - 1.0);
    add(
        "what is hidden is closed",
        middle(&bench.image(&scene(LID)?, AO)?) - (1.0 - square_over_middle(0.5, 0.5)),
    );
    add("a sealed room is dark", mean(&bench.image(&scene(SEALED)?, DIFFUSE)?) / PI);
    let bright = 1.0 + twin::total_reflectance(DVec3::ZERO, 0.0, 1.0).x;
    add(
        "a furnace is as bright as its walls",
        mean(&bench.image(&scene(FURNACE)?, DIFFUSE)?) / PI / bright - 1.0,
    );
    // Its instances move, so that one program shows them all.
    let mut stairs = scene(STAIRS)?;
    stairs.instances.iter_mut().for_each(|instance| instance.moving = true);
    let mut renderers = [bench.renderer(&stairs, AO)?, bench.renderer(&stairs, DIFFUSE)?];
    let mut worst = 0.0f64;
    for (renderer, (image, ..)) in renderers.iter_mut().zip([AO, DIFFUSE]) {
        let mut here = None;
        for symmetry in Symmetry::all() {
            let there = mean(&shown(renderer, &turned(&stairs, symmetry), image)?);
            worst = worst.max((there / *here.get_or_insert(there) - 1.0).abs());
        }
    }
    add("the cube's 48 symmetries change nothing", worst);
    Ok(figures)
}

struct Bench<'a> {
    gpu: &'a Gpu,
    registry: &'a Registry,
    tracer: &'a str,
    format: &'a str,
    pipeline: Pipeline,
}

impl Bench<'_> {
    fn image(&self, scene: &Scene, image: Image) -> Result<Picture, Error> {
        shown(&mut self.renderer(scene, image)?, scene, image.0)
    }

    fn renderer(&self, scene: &Scene, (image, set): Image) -> Result<Renderer<'_>, Error> {
        let set = set.iter().map(|(pass, name, value)| {
            let value = value.parse().map_or_else(|_| Value::Word((*value).to_owned()), Value::Number);
            ((*pass).to_owned(), (*name).to_owned(), value)
        });
        let request = Request {
            tracer: Some(self.tracer.to_owned()),
            format: Some(self.format.to_owned()),
            resolution: Some(64),
            output: Some(image.to_owned()),
            filters_float32: self.gpu.filters_float32(),
            set: set.collect(),
            ..Request::image(32, 32)
        };
        let plan = plan(&self.pipeline, &SceneFacts::of(scene)?, self.registry, &request)?;
        Ok(Renderer::new(self.gpu, plan, scene)?)
    }
}

fn shown(renderer: &mut Renderer<'_>, scene: &Scene, image: &str) -> Result<Picture, Error> {
    renderer.render(scene, &scene.cameras[0], Passes::All)?;
    Ok(renderer.picture(image)?)
}

/// Mean over the pixels that show a surface.
fn mean(picture: &Picture) -> f64 {
    let shown = || picture.pixels.iter().filter(|pixel| pixel[3] > 0.0 || pixel[0] > 0.0);
    let grey = |pixel: &[f32; 4]| f64::from(pixel[0] + pixel[1] + pixel[2]) / 3.0;
    shown().map(grey).sum::<f64>() / shown().count().max(1) as f64
}

/// Mean over the 8 × 8 pixels in the middle.
fn middle(picture: &Picture) -> f64 {
    let (width, height) = (picture.width as usize, picture.height as usize);
    let near = |n: usize, of: usize| n + 4 >= of / 2 && n < of / 2 + 4;
    let place = (0..picture.pixels.len()).filter(|i| near(i % width, width) && near(i / width, height));
    let values: Vec<f64> = place.map(|i| f64::from(picture.pixels[i][0])).collect();
    values.iter().sum::<f64>() / values.len().max(1) as f64
}

/// The share of a floor's hemisphere, by the cosine, that a square over it takes: half its side, and its height (four times the
/// form factor of a rectangle over a corner, Howell B-4).
fn square_over_middle(half_side: f64, height: f64) -> f64 {
    let x = half_side / height;
    let root = (1.0 + x * x).sqrt();
    4.0 * (x / root * (x / root).atan()) / PI
}

/// A scene under one of the cube's symmetries, its camera with it.
fn turned(scene: &Scene, symmetry: Symmetry) -> Scene {
    let mut scene = scene.clone();
    let turn = |v: DVec3| symmetry.direction(v);
    let transform = DAffine3::from_mat3(DMat3::from_cols(turn(DVec3::X), turn(DVec3::Y), turn(DVec3::Z)));
    for instance in &mut scene.instances {
        instance.transform = transform * instance.transform;
    }
    for camera in &mut scene.cameras {
        camera.eye = turn(camera.eye);
        camera.forward = turn(camera.forward.as_dvec3()).as_vec3();
        camera.up = turn(camera.up.as_dvec3()).as_vec3();
    }
    scene
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_square_takes_all_from_near_and_its_solid_angle_from_afar() {
        assert!((square_over_middle(1.0, 1e-4) - 1.0).abs() < 1e-3);
        assert!((square_over_middle(0.01, 1.0) * PI / 4e-4 - 1.0).abs() < 1e-3);
    }
}
