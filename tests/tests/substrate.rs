//! The voxel substrate: what is occupied, the list of cells, the sums of attributes.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use glam::DVec3;
use voxlume::twin::total_reflectance;
use voxlume::{Pipeline, Request, Scene, Source};
use voxlume_tests::{
    Comparison, EPSILON, Random, Separability, Substrate, add, built_in, compare, render, root, sample,
    scene_of, soup, span, triangles,
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
    println!(
        "{what}, {separability:?}, {resolution}³: {overlapped} voxels overlapped, {undecided} undecided"
    );
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

#[test]
fn the_cornell_box_is_voxelized_exactly() {
    let scene = built_in("cornell.ron");
    for separability in [Separability::Conservative, Separability::Thin] {
        agrees("Cornell", &scene, 64, separability);
    }
}

#[test]
fn the_bunny_is_voxelized_exactly() {
    let Some(scene) = sample("bunny.glb") else { return };
    for separability in [Separability::Conservative, Separability::Thin] {
        agrees("bunny", &scene, 64, separability);
    }
}

/// A comparison that can't fail would prove nothing: break the expected side and see it.
#[test]
fn the_comparison_notices_what_is_wrong() {
    let scene = soup_scene(1);
    let read = substrate(&scene, 64, Separability::Conservative);
    let triangles = read.triangles(&scene);
    let half = triangles.iter().map(|t| t.map(|p| p + glam::DVec3::new(0.5, 0.0, 0.0))).collect::<Vec<_>>();
    let shifted = compare(&read, &half, Separability::Conservative, EPSILON);
    assert!(shifted.missing.len() > 100 && shifted.extra.len() > 100);
    let lacking = compare(&read, &triangles[1..], Separability::Conservative, EPSILON);
    assert!(!lacking.extra.is_empty());
    let thin = compare(&read, &triangles, Separability::Thin, EPSILON);
    assert!(thin.missing.is_empty() && thin.extra.len() > 100);
    // Ten times the tolerance, in one place only, is seen too.
    let nudged: Vec<_> = triangles.iter().map(|t| t.map(|p| p + glam::DVec3::splat(0.01))).collect();
    let nudged = compare(&read, &nudged, Separability::Conservative, EPSILON);
    assert!(!nudged.missing.is_empty() && !nudged.extra.is_empty());
}

/// Ranks, the list and its levels say what the bitmask says.
fn is_consistent(substrate: &Substrate) {
    let words = substrate.occupancy.len();
    assert_eq!(substrate.ranks.len(), words + 1);
    let mut before = 0;
    for (word, rank) in substrate.ranks.iter().enumerate() {
        assert_eq!(*rank, before, "word {word}");
        before += substrate.occupancy.get(word).map_or(0, |bits| bits.count_ones());
    }
    let mut first = 0;
    for level in 0..substrate.grid.levels() {
        let run = substrate.levels[level as usize];
        assert_eq!(run.first, first, "level {level}");
        assert!(run.groups[0] * run.groups[1] * run.groups[2] * 64 >= run.count, "level {level}");
        first += run.count;
        let size = substrate.size(level);
        let mut expected = Vec::new();
        for z in 0..size.z {
            for y in 0..size.y {
                for x in 0..size.x {
                    let cell = glam::UVec3::new(x, y, z);
                    let set = substrate.is_set(cell, level);
                    if set {
                        expected.push(cell.to_array());
                    }
                    if level > 0 {
                        let mut children =
                            (0..8).map(|i| cell * 2 + glam::UVec3::new(i & 1, i >> 1 & 1, i >> 2));
                        assert_eq!(
                            set,
                            children.any(|c| substrate.is_set(c, level - 1)),
                            "{cell} of level {level}"
                        );
                    }
                }
            }
        }
        let listed = substrate.listed(level);
        for (index, cell) in listed.iter().enumerate() {
            let (word, bit) = substrate.place(*cell, level);
            let below = (substrate.occupancy[word] & ((1 << bit) - 1)).count_ones();
            assert_eq!(substrate.ranks[word] + below, run.first + index as u32, "{cell} of level {level}");
        }
        let mut listed: Vec<_> = listed.iter().map(|cell| cell.to_array()).collect();
        listed.sort_unstable();
        expected.sort_unstable();
        assert_eq!(listed, expected, "level {level}");
    }
    assert_eq!(substrate.levels[substrate.grid.levels() as usize - 1].count, u32::from(first > 0));
    // Every occupied voxel has been given something.
    assert!(substrate.voxels().all(|sums| sums[0] > 0));
}

#[test]
fn ranks_list_and_levels_agree_with_the_bitmask() {
    for resolution in [16, 32, 64] {
        is_consistent(&substrate(&soup_scene(7), resolution, Separability::Conservative));
    }
    is_consistent(&substrate(&built_in("lights.ron"), 64, Separability::Thin));
}

#[test]
fn the_same_bits_every_time_and_in_any_order() {
    let mut scene = built_in("lights.ron");
    let list = soup(9, 60, 6.0, (0.05, 3.0));
    add(&mut scene, triangles(&list));
    let first = substrate(&scene, 64, Separability::Conservative);
    assert!(first.levels[0].count > 1000);
    assert!(first == substrate(&scene, 64, Separability::Conservative), "another run");
    let mut random = Random::new(10);
    random.shuffle(&mut scene.instances);
    for mesh in &mut scene.meshes {
        random.shuffle(&mut mesh.triangles);
    }
    let shuffled = substrate(&scene, 64, Separability::Conservative);
    assert!(first.occupancy == shuffled.occupancy, "occupancy after shuffling");
    assert!(first.attributes == shuffled.attributes, "attributes after shuffling");
    assert!(first == shuffled, "after shuffling");
    // And the comparison can tell: a triangle less.
    scene.meshes.last_mut().unwrap().triangles.pop();
    assert!(first != substrate(&scene, 64, Separability::Conservative));
}

/// The same triangle `count` times around the middle of voxel (7, 7, 7) of 16, `extent` voxels large, and two to span
/// the grid. Sums of that voxel.
fn pile(count: usize, extent: f32) -> Vec<u32> {
    let corners = [[-0.4, -0.4, -0.4], [0.4, -0.4, 0.4], [-0.4, 0.4, 0.4]];
    // 13 of 16 voxels: voxels of size 1, the middle of the one at 7 at 6 world units.
    let mut pile = triangles(&[corners.map(|c| glam::Vec3::from(c) * extent + 6.0)]);
    pile.triangles = vec![[0, 1, 2]; count];
    let scene = scene_of(vec![pile, span(13.0)], 13.0);
    let substrate = substrate(&scene, 16, Separability::Conservative);
    substrate.sums(glam::UVec3::splat(7)).unwrap().to_vec()
}

#[test]
fn a_million_triangles_in_one_voxel_are_summed_exactly() {
    let count = 1_000_000;
    let scale = f64::from((u32::MAX / (count as u32 + 2)).min(1 << 20));
    for (extent, weight) in [
        // Area below the least weight.
        (0.01, 1.0 / 1024.0),
        // Half the longest diagonals' triangle: 0.64·√3/2 voxel faces.
        (1.0, 0.64 * 3f64.sqrt() / 2.0),
        // Larger than a voxel's face: the most that there is.
        (3.0, 1.0),
    ] {
        let sums = pile(count, extent);
        let each = |value: f64| (value * weight * scale).round() as u64 * count as u64;
        assert!(each(1.0) <= u64::from(u32::MAX));
        assert_eq!(u64::from(sums[0]), each(1.0), "weight, {extent}");
        assert_eq!(u64::from(sums[1]), 0, "double-sided weight, {extent}");
        // Of a polynomial in `f32`: a unit each.
        let albedo = total_reflectance(DVec3::ONE, 0.0, 1.0).x;
        let off = |sum: &u32| u64::from(*sum).abs_diff(each(albedo));
        assert!(sums[2..5].iter().all(|sum| off(sum) <= count as u64), "albedo, {extent}: {sums:?}");
        // The normal is (−1, −1, 1)/√3; its encoding may cost a unit.
        let normal: Vec<f64> = (0..3).map(|i| f64::from(sums[5 + i]) - f64::from(sums[8 + i])).collect();
        for (sum, sign) in normal.iter().zip([-1.0, -1.0, 1.0]) {
            assert_eq!(sum.abs() as u64 % count as u64, 0, "a sum has wrapped, {extent}");
            assert!(
                (sum / count as f64 - sign * weight * scale / 3f64.sqrt()).abs() <= 1.0,
                "{normal:?}, {extent}"
            );
        }
    }
}
