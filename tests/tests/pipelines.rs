//! The pipelines of published systems run beside the default, on one device.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use voxlume::{Pipeline, Request};
use voxlume_tests::{built_in, gi, picture, render, root};

/// Mean luminance of the image, finite everywhere.
fn mean(pipeline: &Pipeline, scene: &str) -> f64 {
    let request = Request { resolution: Some(32), output: Some("final".into()), ..Request::image(24, 24) };
    let renderer = render(pipeline, &built_in(scene), &request);
    assert_eq!(renderer.out_of_range().unwrap(), None, "{scene}");
    let picture = picture(&renderer, "final");
    assert!(picture.pixels.iter().flatten().all(|value| value.is_finite()), "{scene}");
    picture.pixels.iter().map(|p| f64::from(p[0] + p[1] + p[2]) / 3.0).sum::<f64>() / 576.0
}

#[test]
fn rauwendaals_is_a_system_of_its_own() {
    let thesis = Pipeline::load(&root().join("pipelines/rauwendaal.ron")).unwrap();
    for scene in ["cornell.ron", "sunlit_columns.ron"] {
        let (thesis, default) = (mean(&thesis, scene), mean(&gi(), scene));
        println!("{scene}: {thesis} {default}");
        // It darkens by ambient occlusion and gathers no sky; it is the same scene nevertheless.
        assert!(
            thesis > 0.4 * default && thesis < 1.2 * default && thesis != default,
            "{scene}: {thesis} {default}"
        );
    }
}
