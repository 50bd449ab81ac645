//! The methods of voxelization: one answer, whatever the method, the order and the grid.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use glam::{DVec3, Vec3};
use voxlume::{Extent, Request, Scene, Value};
use voxlume_tests::{
    Comparison, EPSILON, Separability, Substrate, compare, gi, render, sample, scene_of, soup, span,
    triangle, triangles,
};

const METHODS: [&str; 4] = ["triangle", "fragment", "hybrid", "balanced"];
const BOTH: [Separability; 2] = [Separability::Conservative, Separability::Thin];

/// A way to voxelize.
#[derive(Clone, Debug)]
struct Way {
    separability: Separability,
    method: &'static str,
    cutoff: f64,
    resolution: u32,
    extent: Extent,
}

impl Way {
    fn new(separability: Separability, method: &'static str, resolution: u32) -> Way {
        Way { separability, method, cutoff: 4.0, resolution, extent: Extent::Cubic }
    }

    fn voxelize(&self, scene: &Scene) -> Substrate {
        let mut pipeline = gi();
        pipeline.extent = self.extent;
        if self.separability == Separability::Thin {
            pipeline.separability.value = "thin".into();
        }
        let set = |name: &str, value| ("voxelize".to_owned(), name.to_owned(), value);
        let request = Request {
            resolution: Some(self.resolution),
            output: Some("diffuse".into()),
            set: vec![
                set("method", Value::Word(self.method.into())),
                set("cutoff", Value::Number(self.cutoff)),
            ],
            ..Request::image(16, 16)
        };
        Substrate::read(&render(&pipeline, scene, &request))
    }

    /// Voxelizes exactly what the test in `f64` says.
    fn is_exact(&self, scene: &Scene) -> Substrate {
        let substrate = self.voxelize(scene);
        let triangles = substrate.triangles(scene);
        let Comparison { missing, extra, undecided, overlapped } =
            compare(&substrate, &triangles, self.separability, EPSILON);
        println!("{self:?}: {overlapped} voxels overlapped, {undecided} undecided");
        assert!(overlapped > 100, "{self:?}: nothing to compare");
        assert!(missing.is_empty(), "{self:?}: {} missing, such as {}", missing.len(), missing[0]);
        assert!(extra.is_empty(), "{self:?}: {} set in vain, such as {}", extra.len(), extra[0]);
        substrate
    }
}

fn assert_same(what: &str, a: &Substrate, b: &Substrate) {
    let differ = a.occupancy.iter().zip(&b.occupancy).filter(|(a, b)| a != b).count();
    assert_eq!(differ, 0, "{what}: words of occupancy differ");
    assert!(a.attributes == b.attributes, "{what}: attributes differ");
    assert!(a == b, "{what}");
}

/// All methods, and hybrid with nothing small and with nothing large.
fn all_agree(what: &str, scene: &Scene, resolution: u32) {
    for separability in BOTH {
        let first = Way::new(separability, "balanced", resolution).is_exact(scene);
        for (method, cutoff) in
            [("triangle", 4.0), ("fragment", 4.0), ("hybrid", 0.0), ("hybrid", 4.0), ("hybrid", 1e9)]
        {
            let way = Way { cutoff, ..Way::new(separability, method, resolution) };
            assert_same(&format!("{what}, {way:?}"), &first, &way.voxelize(scene));
        }
    }
}

#[test]
fn all_methods_set_the_same_bits_on_soup() {
    // 61 of 64 voxels: voxels of size 1.
    let mut list = soup(31, 120, 61.0, (0.05, 20.0));
    list.extend(soup(32, 10, 61.0, (10.0, 40.0)));
    all_agree("soup", &scene_of(vec![triangles(&list), span(61.0)], 61.0), 64);
}

#[test]
fn all_methods_set_the_same_bits_on_the_bunny() {
    let Some(scene) = sample("bunny.glb") else { return };
    all_agree("bunny", &scene, 64);
}

/// Textures, alpha masks, normal maps.
#[test]
fn all_methods_set_the_same_bits_on_sponza() {
    let Some(scene) = sample("sponza.glb") else { return };
    let first = Way::new(Separability::Conservative, "balanced", 64).voxelize(&scene);
    for method in ["triangle", "fragment", "hybrid"] {
        let way = Way::new(Separability::Conservative, method, 64);
        assert_same(&format!("Sponza, {way:?}"), &first, &way.voxelize(&scene));
    }
}

/// What breaks voxelizers: without area, twice, back to back, scene-wide, needles.
fn hard() -> Vec<[Vec3; 3]> {
    let mut list = vec![
        [Vec3::splat(9.0); 3],
        [Vec3::new(2.0, 3.0, 4.0), Vec3::new(12.0, 13.0, 14.0), Vec3::new(7.0, 8.0, 9.0)],
        [Vec3::ZERO, Vec3::new(29.0, 29.0, 0.0), Vec3::new(0.0, 29.0, 29.0)],
        [Vec3::new(5.0, 5.0, 5.0), Vec3::new(25.0, 5.0, 5.0), Vec3::new(15.0, 5.0, 20.0)],
    ];
    for power in 0..9 {
        let (a, b) = (Vec3::new(1.0, 2.0, 3.0), Vec3::new(27.0, 20.0, 11.0));
        list.push([a, b, a.lerp(b, 0.4) + Vec3::Y * 10f32.powi(-power)]);
    }
    let turned: Vec<_> = list.iter().map(|[a, b, c]| [*a, *c, *b]).collect();
    list.iter().chain(&list).chain(&turned).copied().collect()
}

#[test]
fn all_methods_set_the_same_bits_on_hard_triangles() {
    let scene = scene_of(vec![triangles(&hard()), span(29.0)], 29.0);
    for separability in BOTH {
        let [first, rest @ ..] = METHODS.map(|method| Way::new(separability, method, 32).voxelize(&scene));
        assert!(first.levels[0].count > 100);
        for (other, method) in rest.iter().zip(&METHODS[1..]) {
            assert_same(method, &first, other);
        }
    }
}

/// Nothing to voxelize is no error, for any method.
#[test]
fn meshes_without_triangles() {
    let none = voxlume::scene::Mesh { name: "none".into(), ..Default::default() };
    let point = triangle([9.0; 3], [9.0; 3], [9.0; 3]);
    for method in METHODS {
        for scene in [scene_of(vec![none.clone()], 1.0), scene_of(vec![point.clone()], 1.0)] {
            let substrate = Way::new(Separability::Conservative, method, 16).voxelize(&scene);
            assert_eq!(substrate.levels[0].count, 0, "{method}");
        }
    }
}

#[test]
fn grids_of_any_size_and_shape() {
    let list: Vec<_> = soup(33, 80, 29.0, (0.1, 8.0))
        .into_iter()
        .map(|corners| corners.map(|p| p * Vec3::new(1.0, 0.4, 0.7)))
        .collect();
    let scene = scene_of(vec![triangles(&list)], 29.0);
    for (resolution, extent) in [(33, Extent::Cubic), (45, Extent::Bounds), (64, Extent::Bounds)] {
        for method in ["fragment", "balanced"] {
            let way = Way { extent, ..Way::new(Separability::Conservative, method, resolution) };
            let substrate = way.is_exact(&scene);
            let [x, y, _] = substrate.grid.size;
            assert_eq!(extent == Extent::Bounds, x != y, "{way:?}");
        }
    }
}

/// What lies outside is left out, and the plan says so.
#[test]
fn a_grid_smaller_than_the_scene() {
    let mut list = soup(34, 120, 29.0, (0.1, 12.0));
    // Far beyond the grid on all sides.
    list.push([Vec3::splat(-1e6), Vec3::new(1e6, -1e6, 2e6), Vec3::splat(1e6)]);
    let scene = scene_of(vec![triangles(&list)], 29.0);
    let extent = Extent::Box(DVec3::new(4.0, 8.0, 10.0), DVec3::new(24.0, 18.0, 25.0));
    for separability in BOTH {
        let way = |method| Way { extent, ..Way::new(separability, method, 40) };
        let first = way("balanced").is_exact(&scene);
        assert_eq!(first.grid.size, [40, 20, 32]);
        for method in ["triangle", "fragment", "hybrid"] {
            assert_same(method, &first, &way(method).voxelize(&scene));
        }
    }
    let mut pipeline = gi();
    pipeline.extent = extent;
    let plan = voxlume_tests::plan_for(&pipeline, &scene, &Request::image(16, 16));
    assert!(plan.left_out.iter().any(|item| item.what == "what lies outside the grid"));
}

/// A floor's edge that runs through the middle of voxels: half of what they show is floor.
#[test]
fn coverage_by_area() {
    // 29 of 32 voxels: voxels of size 1, 0 at 1.5.
    let corner = |x: f32, z: f32| Vec3::new(x, 10.0, z);
    let [a, b, c, d] = [corner(0.5, 0.5), corner(4.0, 0.5), corner(0.5, 4.5), corner(4.0, 4.5)];
    let scene = scene_of(vec![triangles(&[[a, b, d], [a, d, c]]), span(29.0)], 29.0);
    let area = Value::Word("area".into());
    let request = Request {
        resolution: Some(32),
        output: Some("diffuse".into()),
        set: vec![("voxelize".into(), "coverage".into(), area)],
        ..Request::image(16, 16)
    };
    let substrate = Substrate::read(&render(&gi(), &scene, &request));
    // Units per voxel face with so few triangles.
    let whole = 1 << 20;
    for z in 2..6 {
        for (x, share) in [(2, whole), (3, whole), (4, whole), (5, whole / 2)] {
            let cell = glam::UVec3::new(x, 11, z);
            assert_eq!(substrate.sums(cell).unwrap().last(), Some(&share), "{cell}");
        }
    }
}
