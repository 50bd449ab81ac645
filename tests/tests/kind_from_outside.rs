//! A kind of pass from another crate: one Rust file, two WGSL modules, and a word in the pipeline.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use voxlume::{
    Bundle, Expansion, ImageTexel, Over, PassKind, Passes, Pipeline, Port, Registry, Renderer, Request,
    ResourceKind, SceneFacts, Sort, Source, Target, plan, screen_image,
};
use voxlume_tests::{built_in, gpu, picture, root};

// ANCHOR: kind
/// Makes an image so bright that its mean is 1: first a sum over all its texels, then each over that.
#[derive(Debug)]
struct Expose;

impl PassKind for Expose {
    fn name(&self) -> &str {
        "expose"
    }

    fn sentence(&self) -> &str {
        "makes an image so bright that the mean of its luminance is 1"
    }

    fn reads(&self) -> &[Port] {
        &[const { Port::new("dark", Sort::IMAGE, "the image") }]
    }

    fn writes(&self) -> &[Port] {
        &[const { Port::new("exposed", Sort::IMAGE, "the same image, brighter or darker") }]
    }

    fn expand(&self, pass: &mut Expansion<'_, '_>) {
        let sum = pass.resource("luminance", ResourceKind::Buffer(8));
        let image = pass.resource(&pass.written(), screen_image(ImageTexel::Rgba16Float, 1));
        pass.makes(Bundle::of(&pass.written(), Target::Resource(image)));
        pass.clear(sum);
        pass.run("expose/sum").writes("luminance", Target::Resource(sum)).over(Over::Texels(image));
        pass.run("expose/scale")
            .reads("luminance", Target::Resource(sum))
            .writes("exposed", Target::Resource(image))
            .over(Over::Texels(image));
    }
}
// ANCHOR_END: kind

// ANCHOR: wgsl
const SUM: &str = "
var dark: texture_2d_array<f32>;
// The sum of the luminances in units of 1/256, and the number of texels.
var<storage, read_write> luminance: array<atomic<u32>, 2>;

@compute @workgroup_size(8, 8)
fn main(@builtin(global_invocation_id) id: vec3u) {
    if (all(id.xy < textureDimensions(dark))) {
        let color = textureLoad(dark, id.xy, 0, 0).rgb;
        atomicAdd(&luminance[0], u32(dot(color, vec3f(0.2126, 0.7152, 0.0722)) * 256.0));
        atomicAdd(&luminance[1], 1u);
    }
}
";

const SCALE: &str = "
var dark: texture_2d_array<f32>;
var<storage, read> luminance: array<u32, 2>;
var exposed: texture_storage_2d_array<rgba16float, write>;

@compute @workgroup_size(8, 8)
fn main(@builtin(global_invocation_id) id: vec3u) {
    if (all(id.xy < textureDimensions(dark))) {
        let mean = f32(luminance[0]) / 256.0 / f32(luminance[1]);
        let color = textureLoad(dark, id.xy, 0, 0);
        textureStore(exposed, id.xy, 0, vec4f(color.rgb / max(mean, 1e-6), color.a));
    }
}
";
// ANCHOR_END: wgsl

// ANCHOR: entry
const ENTRY: &str = r#"passes: [
        (run: "expose", reads: ["final as dark"], writes: ["exposed"]),"#;
// ANCHOR_END: entry

fn exposing() -> Pipeline {
    let gi = std::fs::read_to_string(root().join("pipelines/gi.ron")).unwrap();
    Pipeline::parse(&Source::new("expose.ron", gi.replacen("passes: [", ENTRY, 1))).unwrap()
}

#[test]
fn a_kind_of_pass_from_another_crate_runs_with_every_format() {
    // ANCHOR: use
    let mut registry = Registry::builtin();
    registry.kinds.add(Expose);
    registry.library.insert("expose/sum", Source::new("sum.wgsl", SUM));
    registry.library.insert("expose/scale", Source::new("scale.wgsl", SCALE));
    // ANCHOR_END: use
    let scene = built_in("cornell.ron");
    let facts = SceneFacts::of(&scene).unwrap();
    for format in registry.formats.iter() {
        let request = Request {
            format: Some(format.name().into()),
            resolution: Some(32),
            output: Some("exposed".into()),
            ..Request::image(32, 24)
        };
        let plan = plan(&exposing(), &facts, &registry, &request).unwrap_or_else(|faults| panic!("{faults}"));
        let mut renderer = Renderer::new(gpu(), plan, &scene).unwrap();
        renderer.render(&scene, &scene.cameras[0], Passes::All).unwrap();
        let image = picture(&renderer, "exposed");
        let luminance = |p: &[f32; 4]| f64::from(0.2126 * p[0] + 0.7152 * p[1] + 0.0722 * p[2]);
        let mean = image.pixels.iter().map(luminance).sum::<f64>() / image.pixels.len() as f64;
        // Each luminance is cut to 1/256; half floats have 11 bits.
        assert!((mean - 1.0).abs() < 0.03, "{}: {mean}", format.name());
    }
}

#[test]
fn unknown_without_the_kind() {
    let facts = SceneFacts::of(&built_in("cornell.ron")).unwrap();
    let faults = plan(&exposing(), &facts, &Registry::builtin(), &Request::image(8, 8)).unwrap_err();
    assert!(faults.to_string().contains("unknown pass `expose`"), "{faults}");
}
