//! The integer contract of the substrate on another driver, SwiftShader: the same bits of occupancy, and attributes
//! whose sums differ by rounding only. Square roots and quotients may round otherwise before they are summed, so that each triangle may
//! add a unit more or less; and one that touches a voxel within rounding of its face may be added or not.
//!
//! Its manifest `vk_swiftshader_icd.json` comes with Debian's `chromium`, or with any Chrome; `VOXLUME_SWIFTSHADER_ICD`
//! names one that is elsewhere. The Vulkan loader chooses its drivers when a process starts, so each runs in a child.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use std::path::PathBuf;
use std::process::Command;

use voxlume::{Request, Scene};
use voxlume_tests::{
    EPSILON, Substrate, add, built_in, gi, gpu, overlaps_box, render, root, scene_of, soup, span, triangles,
};

fn scenes() -> Vec<(&'static str, Scene)> {
    let mut soup_scene = built_in("lights.ron");
    add(&mut soup_scene, triangles(&soup(9, 60, 6.0, (0.05, 3.0))));
    let hard = |name: &str| Scene::load(&root().join("scenes/hard").join(name)).unwrap();
    vec![
        ("cornell", built_in("cornell.ron")),
        ("soup", soup_scene),
        ("slivers", hard("slivers.ron")),
        ("uneven", hard("mirrored.ron")),
        ("far away", hard("far_away.ron")),
        ("specks", scene_of(vec![triangles(&soup(5, 2000, 61.0, (0.05, 1.0))), span(61.0)], 61.0)),
    ]
}

fn voxelize(scene: &Scene) -> Substrate {
    let request = Request { resolution: Some(64), output: Some("diffuse".into()), ..Request::image(8, 8) };
    Substrate::read(&render(&gi(), scene, &request))
}

/// Set for a child, which is a process of its own because the loader of drivers reads its variables once: the folder that it
/// writes to.
const CHILD: &str = "VOXLUME_WRITE_BITS";

/// What a child does: writes the device's name, and each scene's words of occupancy and of attributes.
#[test]
fn write_bits() {
    let Some(folder) = std::env::var_os(CHILD).map(PathBuf::from) else { return };
    std::fs::write(folder.join("device"), &gpu().info.name).unwrap();
    for (name, scene) in scenes() {
        let Substrate { occupancy, attributes, .. } = voxelize(&scene);
        for (what, words) in [("occupancy", occupancy), ("attributes", attributes)] {
            let bytes: Vec<u8> = words.into_iter().flat_map(u32::to_le_bytes).collect();
            std::fs::write(folder.join(format!("{name}.{what}")), bytes).unwrap();
        }
    }
}

/// How often attributes may differ. Measured, in the six scenes: at most 1.4 words in a thousand; a formula that another driver
/// reads otherwise would differ in most.
const SHARE: f64 = 5e-3;

#[test]
fn two_drivers_voxelize_alike() {
    let named = std::env::var_os("VOXLUME_SWIFTSHADER_ICD").map(PathBuf::from);
    let usual = ["/usr/lib/chromium", "/opt/google/chrome", "/usr/lib/chromium-browser"];
    let places =
        named.into_iter().chain(usual.map(|folder| PathBuf::from(folder).join("vk_swiftshader_icd.json")));
    let Some(icd) = places.into_iter().find(|path| path.exists()) else {
        println!("skipped: no vk_swiftshader_icd.json (on Debian: apt-get install chromium)");
        return;
    };
    let folder = tempfile::tempdir().unwrap();
    let child = Command::new(std::env::current_exe().unwrap())
        .args(["--exact", "write_bits"])
        .env(CHILD, folder.path())
        .envs([("VK_ICD_FILENAMES", &icd), ("VK_DRIVER_FILES", &icd)])
        .env_remove("WGPU_ADAPTER_NAME")
        .output()
        .unwrap();
    assert!(child.status.success(), "{}", String::from_utf8_lossy(&child.stdout));
    let device = std::fs::read_to_string(folder.path().join("device")).unwrap();
    assert!(device.contains("SwiftShader"), "{device}");
    if gpu().info.name == device {
        println!("skipped: there is no device but SwiftShader");
        return;
    }
    let theirs = |file: String| -> Vec<u32> {
        let bytes = std::fs::read(folder.path().join(file)).unwrap();
        bytes.chunks_exact(4).map(|b| u32::from_le_bytes([b[0], b[1], b[2], b[3]])).collect()
    };
    for (name, scene) in scenes() {
        let ours = voxelize(&scene);
        assert!(ours.levels[0].count > 1000, "{name}: nothing to compare");
        assert!(ours.occupancy == theirs(format!("{name}.occupancy")), "{name}: occupancy");
        attributes_differ_by_rounding(name, &scene, &ours, &theirs(format!("{name}.attributes")));
    }
}

fn attributes_differ_by_rounding(name: &str, scene: &Scene, ours: &Substrate, theirs: &[u32]) {
    assert_eq!(ours.attributes.len(), theirs.len(), "{name}");
    let (cells, triangles) = (ours.listed(0), ours.triangles(scene));
    let stride = theirs.len() / cells.len();
    let (mut differ, mut most, mut touched) = (0, 0, 0);
    for (word, (a, b)) in ours.attributes.iter().zip(theirs).enumerate().filter(|(_, (a, b))| a != b) {
        let cell = cells[word / stride];
        let overlap = |half: f64| {
            let centre = cell.as_dvec3() + 0.5;
            triangles.iter().filter(|triangle| overlaps_box(triangle, centre, half)).count()
        };
        let (may, must) = (overlap(0.5 + EPSILON), overlap(0.5 - EPSILON));
        let apart = a.abs_diff(*b);
        differ += 1;
        if may > must {
            touched += 1;
        } else {
            most = most.max(apart);
            assert!(
                apart as usize <= must,
                "{name}: word {} of {cell} differs by {apart} with {must} triangles",
                word % stride
            );
        }
    }
    println!(
        "{name}: {differ} of {} words of attributes differ, {touched} where a triangle touches a face, else by {most} units at most",
        theirs.len()
    );
    assert!(f64::from(differ) <= SHARE * theirs.len() as f64, "{name}: {differ} of {} words", theirs.len());
}
