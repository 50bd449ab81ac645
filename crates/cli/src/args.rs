//! Arguments that several commands share.

use std::path::PathBuf;

use voxlume::{Faults, Gpu, Pipeline, Plan, Request, Scene, SceneFacts, Value};

use crate::{Registry, pipeline};

/// A scene, a pipeline, and what replaces the pipeline's own words.
#[derive(clap::Args)]
pub struct PlanArgs {
    /// Scene file: .ron, .gltf or .glb
    pub scene: PathBuf,

    /// Name of a built-in pipeline (gi, rauwendaal), or a .ron file
    #[arg(long, value_name = "NAME|FILE", default_value = "gi")]
    pub pipeline: String,

    /// Storage format, instead of the pipeline's: isotropic, six_face, sh2; options follow, such as
    /// sh2:mip=projected:negatives=window
    #[arg(long)]
    pub format: Option<String>,

    /// Texel encoding, instead of the pipeline's: rgba8, rgba8:range=8, rgba16float, rgba32float
    #[arg(long)]
    pub encoding: Option<String>,

    /// Tracer, instead of the pipeline's: cones, rays
    #[arg(long)]
    pub tracer: Option<String>,

    /// Voxels along the grid's longest side, instead of the pipeline's: 8 to 512
    #[arg(long, value_name = "N")]
    pub resolution: Option<u32>,

    /// Width and height of the image in pixels
    #[arg(long, value_name = "WxH", default_value = "512x512", value_parser = size)]
    pub size: [u32; 2],

    /// Gather tracing effects at the screen's size over this and bring them up to it: 1, 2, 4 or 8; as the pipeline says
    /// unless given
    #[arg(long, value_name = "N")]
    pub scale: Option<u32>,

    /// Second of the scene's animation to show
    #[arg(long, value_name = "SECONDS", default_value_t = 0.0, allow_negative_numbers = true, value_parser = seconds)]
    pub time: f64,

    /// Sets a parameter of a pass: a number, a word or numbers with commas; may be repeated
    #[arg(long, value_name = "PASS.PARAM=VALUE", value_parser = setting)]
    pub set: Vec<(String, String, Value)>,

    /// MiB that the plan may take on the device; it is refused if it needs more
    #[arg(long, value_name = "MIB")]
    pub memory_budget: Option<u32>,
}

impl PlanArgs {
    /// Reads the scene, as it is at the time asked for.
    pub fn scene(&self) -> Result<Scene, Faults> {
        let mut scene = Scene::load(&self.scene)?;
        scene.set_time(self.time);
        Ok(scene)
    }

    /// Reads the pipeline.
    pub fn pipeline(&self) -> Result<Pipeline, Faults> {
        pipeline::load(&self.pipeline)
    }

    /// What they ask of a plan.
    pub fn request(&self) -> Request {
        Request {
            format: self.format.clone(),
            encoding: self.encoding.clone(),
            tracer: self.tracer.clone(),
            resolution: self.resolution,
            scale: self.scale,
            output: None,
            set: self.set.clone(),
            screen: self.size,
            filters_float32: false,
            memory_budget: self.memory_budget.map(|mebibytes| u64::from(mebibytes) << 20),
        }
    }
}

/// As [`PlanArgs`], and which image is made.
#[derive(clap::Args)]
pub struct ImageArgs {
    #[command(flatten)]
    pub plan: PlanArgs,

    /// Image to make, instead of the pipeline's: final, diffuse, specular, ao, shadow, albedo, normal, geometry,
    /// emission, depth, voxel_view, or one that a pass of your own writes
    #[arg(long, value_name = "IMAGE")]
    pub output: Option<String>,
}

impl ImageArgs {
    /// Plans the pipeline for the scene, and for a device if there is one.
    pub fn plan(
        &self,
        registry: &Registry,
        pipeline: &Pipeline,
        scene: &Scene,
        gpu: Option<&Gpu>,
    ) -> Result<Plan, Faults> {
        let filters_float32 = gpu.is_some_and(Gpu::filters_float32);
        let request = Request { output: self.output.clone(), filters_float32, ..self.plan.request() };
        plan(registry, pipeline, scene, &request)
    }
}

/// Plans a pipeline for a scene.
pub fn plan(
    registry: &Registry,
    pipeline: &Pipeline,
    scene: &Scene,
    request: &Request,
) -> Result<Plan, Faults> {
    voxlume::plan(pipeline, &SceneFacts::of(scene)?, registry, request)
}

/// Width and height of an image.
pub fn size(text: &str) -> Result<[u32; 2], String> {
    let sides =
        text.split_once('x').and_then(|(width, height)| Some([width.parse().ok()?, height.parse().ok()?]));
    sides.ok_or_else(|| "two whole numbers with an `x` between them, such as 640x360".into())
}

/// A time in seconds.
pub fn seconds(text: &str) -> Result<f64, String> {
    let time = text.parse().ok().filter(|time: &f64| time.is_finite());
    time.ok_or_else(|| "a finite number".into())
}

fn setting(text: &str) -> Result<(String, String, Value), String> {
    let form = || "a pass, a parameter and a value, such as bounce.bounces=1".to_owned();
    let (place, value) = text.split_once('=').ok_or_else(form)?;
    let (pass, param) = place.rsplit_once('.').ok_or_else(form)?;
    if pass.is_empty() || param.is_empty() || value.is_empty() {
        return Err(form());
    }
    Ok((pass.to_owned(), param.to_owned(), parameter(value)?))
}

fn parameter(text: &str) -> Result<Value, String> {
    let finite = |number: f64| {
        if number.is_finite() { Ok(number) } else { Err("a parameter must be finite".to_owned()) }
    };
    let bare = text.trim_start_matches('(').trim_end_matches(')');
    if bare.contains(',') {
        let numbers = bare.split(',').map(|item| match item.trim().parse() {
            Ok(number) => finite(number),
            Err(_) => Err(format!("`{}` is no number", item.trim())),
        });
        return Ok(Value::Vector(numbers.collect::<Result<_, _>>()?));
    }
    match text {
        "true" => Ok(Value::Number(1.0)),
        "false" => Ok(Value::Number(0.0)),
        _ => text
            .parse()
            .map_or_else(|_| Ok(Value::Word(text.to_owned())), |number| finite(number).map(Value::Number)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes() {
        assert_eq!(size("640x360"), Ok([640, 360]));
        for wrong in ["640", "640x", "x", "640x360x2", "-1x5", "64 x 64", "99999999999x1"] {
            assert!(size(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn settings() {
        let set = |value| ("light".to_owned(), "bias".to_owned(), value);
        assert_eq!(setting("light.bias=1.5"), Ok(set(Value::Number(1.5))));
        assert_eq!(setting("light.bias=-2e3"), Ok(set(Value::Number(-2000.0))));
        assert_eq!(setting("light.bias=true"), Ok(set(Value::Number(1.0))));
        assert_eq!(setting("light.bias=voxel_ray"), Ok(set(Value::Word("voxel_ray".into()))));
        assert_eq!(setting("light.bias=1, 2.5,-3"), Ok(set(Value::Vector(vec![1.0, 2.5, -3.0]))));
        assert_eq!(setting("light.bias=(1,2)"), Ok(set(Value::Vector(vec![1.0, 2.0]))));
        assert_eq!(setting("light.bias=inf"), Err("a parameter must be finite".into()));
        assert_eq!(setting("light.bias=1,nan"), Err("a parameter must be finite".into()));
        assert_eq!(setting("light.bias=1,b"), Err("`b` is no number".into()));
        for wrong in ["", "light", "light.bias", "bias=1", ".bias=1", "light.=1", "light.bias="] {
            assert!(setting(wrong).is_err(), "{wrong}");
        }
    }
}
