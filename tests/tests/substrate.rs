//! The voxel substrate: what is occupied, the list of cells, the sums of attributes.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use voxlume::{Pipeline, Request, Scene, Source};
use voxlume_tests::{
    Comparison, EPSILON, Separability, Substrate, built_in, compare, gi, render, root, sample, scene_of, soup, span,
    triangles,
};

/// `pipelines/gi.ron` with surfaces of this thickness.
fn pipeline(separability: Separability) -> Pipeline {
    let text = std::fs::read_to_string(root().join("pipelines/gi.ron")).unwrap();
    let text = match separability {
        Separability::Conservative => text,
        Separability::Thin => text.replace("separability: \"conservative\"", "separability: \"thin\""),
    };
    let pipeline = Pipeline::parse(&Source::new("gi.ron", text)).unwrap();
    assert_eq!(pipeline.separability.value == "thin", separability == Separability::Thin);
    pipeline
}

fn request(resolution: u32) -> Request {
    Request { resolution: Some(resolution), output: Some("diffuse".into()), ..Request::image(16, 16) }
}

fn substrate(scene: &Scene, resolution: u32, separability: Separability) -> Substrate {
    Substrate::read(&render(&pipeline(separability), scene, &request(resolution)))
}

fn compared(scene: &Scene, resolution: u32, separability: Separability) -> Comparison {
    let substrate = substrate(scene, resolution, separability);
    compare(&substrate, &substrate.triangles(scene), separability, EPSILON)
}

fn agrees(what: &str, scene: &Scene, resolution: u32, separability: Separability) {
    let comparison = compared(scene, resolution, separability);
    let Comparison { missing, extra, undecided, overlapped } = &comparison;
    println!("{what}, {separability:?}, {resolution}³: {overlapped} voxels overlapped, {undecided} undecided");
    assert!(*overlapped > 100, "{what}: nothing to compare");
    // Else the comparison would say little.
    assert!(*undecided * 10 < *overlapped, "{what}: {undecided} of {overlapped} are undecided");
    assert!(missing.is_empty(), "{what}: {} missing, such as {}", missing.len(), missing[0]);
    assert!(extra.is_empty(), "{what}: {} set in vain, such as {}", extra.len(), extra[0]);
}

fn soup_scene(seed: u64) -> Scene {
    // 61 of 64 voxels: voxels of size 1.
    let mut list = soup(seed, 150, 61.0, (0.1, 20.0));
    list.extend(soup(seed + 1, 12, 61.0, (10.0, 40.0)));
    scene_of(vec![triangles(&list), span(61.0)], 61.0)
}

#[test]
fn soups_are_voxelized_as_the_exact_overlap_test_says() {
    for seed in [1, 2] {
        agrees("soup", &soup_scene(seed), 64, Separability::Conservative);
    }
}

#[test]
fn soups_are_voxelized_thinly_as_the_book_says() {
    for seed in [3, 4] {
        agrees("soup", &soup_scene(seed), 64, Separability::Thin);
    }
}

#[test]
fn dust_is_voxelized_as_the_exact_overlap_test_says() {
    let list = soup(5, 3000, 61.0, (0.05, 1.0));
    let scene = scene_of(vec![triangles(&list), span(61.0)], 61.0);
    agrees("dust", &scene, 64, Separability::Conservative);
    agrees("dust", &scene, 64, Separability::Thin);
}
