//! Random changes to a pipeline: every fault is told, and what has none runs on a device without its complaint.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use proptest::prelude::*;
use proptest::test_runner::{Config, RngSeed};
use voxlume::{Passes, Pipeline, Registry, Renderer, Request, SceneFacts, Source, Value, plan};
use voxlume_tests::{built_in, gpu, picture, root};

/// Pipelines that are planned, and rendered where that is possible; a frame is half a second on a software device.
const CASES: u32 = 48;

/// The file's lines with one pass an item.
fn passes() -> (String, Vec<String>, String) {
    let text = std::fs::read_to_string(root().join("pipelines/gi.ron")).unwrap();
    let start = text.find("passes: [").unwrap() + "passes: [".len();
    let end = text.rfind(']').unwrap();
    let mut items = Vec::new();
    let (mut depth, mut from) = (0, start);
    for (at, c) in text[start..end].char_indices() {
        match c {
            '(' => depth += 1,
            ')' => depth -= 1,
            ',' if depth == 0 => {
                items.push(text[from..start + at].to_owned());
                from = start + at + 1;
            }
            _ => {}
        }
    }
    (text[..start].to_owned(), items, text[end..].to_owned())
}

proptest! {
    #![proptest_config(Config {
        cases: CASES, rng_seed: RngSeed::Fixed(11), failure_persistence: None, max_shrink_iters: 30, ..Config::default()
    })]

    #[test]
    fn a_pipeline_is_refused_or_runs(
        order in Just((0..passes().1.len()).collect::<Vec<_>>()).prop_shuffle(),
        removed in prop::collection::vec(any::<prop::sample::Index>(), 0..2),
        output in prop::sample::select(vec!["final", "diffuse", "shadow", "ao", "specular", "normal", "depth", "volume", "nothing"]),
        format in prop::sample::select(vec!["isotropic", "six_face", "sh2", "sh3"]),
        resolution in prop::sample::select(vec![16u32, 16, 16, 17, 0, 600]),
        number in prop::sample::select(vec![1.0, 0.0, 0.5, 2.0, -1.0, 1e9, 1e-9, f64::from(f32::MAX)]),
        set in prop::option::of(any::<(prop::sample::Index, prop::sample::Index)>()),
        scene in prop::sample::select(vec!["cornell.ron", "lights.ron", "furnace.ron", "sunlit_columns.ron"]),
        screen in prop::sample::select(vec![[16u32, 8], [1, 1], [7, 13], [0, 4], [9000, 1]]),
    ) {
        let (head, items, tail) = passes();
        let mut order = order;
        for index in removed {
            if !order.is_empty() {
                order.remove(index.index(order.len()));
            }
        }
        let text = head + &order.iter().map(|i| items[*i].clone() + ",").collect::<String>() + &tail;
        let pipeline = Pipeline::parse(&Source::new("gi.ron", text)).unwrap_or_else(|faults| panic!("{faults}"));
        let set = set.and_then(|(pass, param)| {
            let pass = pipeline.passes.get(pass.index(pipeline.passes.len().max(1)))?;
            let param = pass.params.get(param.index(pass.params.len().max(1)))?;
            Some((pass.name.clone(), param.name.clone(), Value::Number(number)))
        });
        let request = Request {
            format: Some(format.into()),
            resolution: Some(resolution),
            output: Some(output.into()),
            set: set.into_iter().collect(),
            ..Request::image(screen[0], screen[1])
        };
        let scene = built_in(scene);
        match plan(&pipeline, &SceneFacts::of(&scene).unwrap(), &Registry::builtin(), &request) {
            Err(faults) => prop_assert!(!faults.to_string().trim().is_empty()),
            Ok(plan) => {
                let mut renderer = Renderer::new(gpu(), plan, &scene).map_err(|e| TestCaseError::fail(e.to_string()))?;
                renderer.render(&scene, &scene.cameras[0], Passes::All).map_err(|e| TestCaseError::fail(e.to_string()))?;
                let image = picture(&renderer, output);
                prop_assert!(image.pixels.iter().flatten().all(|value| value.is_finite()), "`{output}` is not finite");
                prop_assert!(gpu().check().is_ok(), "{:?}", gpu().check());
            }
        }
    }
}
