//! The integer contract of the substrate: the same bits of occupancy on another driver, SwiftShader. Attributes are the same in every
//! run and order on one driver, not between drivers, whose square roots and quotients round otherwise before they are summed.
//!
//! Its manifest `vk_swiftshader_icd.json` comes with Debian's `chromium`, or with any Chrome; `VOXLUME_SWIFTSHADER_ICD`
//! names one that is elsewhere. The Vulkan loader chooses its drivers when a process starts, so each runs in a child.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use std::path::PathBuf;
use std::process::Command;

use voxlume::{Request, Scene};
use voxlume_tests::{Substrate, add, built_in, gi, gpu, render, root, scene_of, soup, span, triangles};

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

/// FNV-1a, 64 bits.
fn hash(words: &[u32]) -> u64 {
    let bytes = words.iter().flat_map(|word| word.to_le_bytes());
    bytes.fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3))
}

/// Set for a child, which is a process of its own because the loader of drivers reads its variables once.
const CHILD: &str = "VOXLUME_PRINT_BITS";

/// What a child does: prints the device, and a line for each scene.
#[test]
fn print_bits() {
    if std::env::var_os(CHILD).is_none() {
        return;
    }
    println!("BITS device {}", gpu().info.name);
    for (name, scene) in scenes() {
        let request =
            Request { resolution: Some(64), output: Some("diffuse".into()), ..Request::image(8, 8) };
        let substrate = Substrate::read(&render(&gi(), &scene, &request));
        let (occupancy, attributes) = (hash(&substrate.occupancy), hash(&substrate.attributes));
        println!(
            "BITS {name}: {} voxels, {occupancy:016x}; attributes {attributes:016x}",
            substrate.levels[0].count
        );
    }
}

fn bits(icd: Option<&PathBuf>) -> Vec<String> {
    let mut command = Command::new(std::env::current_exe().unwrap());
    command.args(["--exact", "print_bits", "--nocapture"]).env(CHILD, "1");
    if let Some(icd) = icd {
        command.env("VK_ICD_FILENAMES", icd).env("VK_DRIVER_FILES", icd).env_remove("WGPU_ADAPTER_NAME");
    }
    let output = command.output().unwrap();
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(output.status.success(), "{text}{}", String::from_utf8_lossy(&output.stderr));
    text.lines().filter_map(|line| line.split_once("BITS ").map(|(_, rest)| rest.to_owned())).collect()
}

#[test]
fn two_drivers_voxelize_to_the_same_bits() {
    let named = std::env::var_os("VOXLUME_SWIFTSHADER_ICD").map(PathBuf::from);
    let usual = ["/usr/lib/chromium", "/opt/google/chrome", "/usr/lib/chromium-browser"];
    let places =
        named.into_iter().chain(usual.map(|folder| PathBuf::from(folder).join("vk_swiftshader_icd.json")));
    let Some(icd) = places.into_iter().find(|path| path.exists()) else {
        println!("skipped: no vk_swiftshader_icd.json (on Debian: apt-get install chromium)");
        return;
    };
    let (ours, theirs) = (bits(None), bits(Some(&icd)));
    println!("{ours:#?}\n{theirs:#?}");
    assert!(theirs[0].contains("SwiftShader"), "{}", theirs[0]);
    if ours[0] == theirs[0] {
        println!("skipped: there is no device but SwiftShader");
        return;
    }
    assert_eq!(ours.len(), scenes().len() + 1);
    let occupancy = |lines: &[String]| -> Vec<String> {
        lines[1..].iter().filter_map(|line| Some(line.split_once(';')?.0.to_owned())).collect()
    };
    assert_eq!(occupancy(&ours).len(), scenes().len());
    assert_eq!(occupancy(&ours), occupancy(&theirs));
}
