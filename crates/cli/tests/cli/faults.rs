//! What the machine may do to the program: a clear message, the right exit code, no half-written file, and what was
//! finished is kept.
#![cfg(target_os = "linux")]

use std::fs::{self, File};
use std::io::Read;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::Duration;

use serde_json::Value;

use crate::folder::Folder;

const CORNELL: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/cornell.ron");
const MOVING: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/moving.ron");

fn names(folder: &Path) -> Vec<String> {
    let mut names: Vec<String> = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    names
}

#[test]
fn a_lost_device_writes_nothing() {
    let folder = Folder::new();
    let before = folder.contents();
    let words = format!("render {CORNELL} --resolution 16 --size 16x16 -o out.png --json out.json");
    // Before anything is uploaded, while it is, and later.
    for steps in ["1", "2", "3", "12", "20"] {
        let lost = folder.command(&words).env("VOXLUME_LOSE_DEVICE_AFTER", steps).output().unwrap();
        let stderr = String::from_utf8(lost.stderr).unwrap();
        assert_eq!(lost.status.code(), Some(1), "{steps}: {stderr}");
        assert!(stderr.ends_with("error: the device was lost: Destroyed\n"), "{steps}: {stderr}");
        assert_eq!(folder.contents(), before, "{steps}");
    }
}

/// Only the cell at hand: those after it get a device that works.
#[test]
fn a_lost_device_loses_one_cell() {
    let folder = Folder::new();
    let ran = folder
        .command(&format!(
            "compare {CORNELL} --size 16x16 --resolutions 16 --spp 2 --repeat 1 --formats isotropic --effects soft_shadow,diffuse --out out"
        ))
        .env("VOXLUME_LOSE_DEVICE_AFTER", "12")
        .output()
        .unwrap();
    let stderr = String::from_utf8(ran.stderr).unwrap();
    assert_eq!(ran.status.code(), Some(1), "{stderr}");
    assert!(stderr.ends_with("1 of 2 cells failed; results.json says why\n"), "{stderr}");
    let results: Value =
        serde_json::from_str(&fs::read_to_string(folder.path().join("out/results.json")).unwrap()).unwrap();
    assert!(results["rows"][0]["fault"].as_str().unwrap().contains("the device was lost"), "{results}");
    assert!(results["rows"][1]["error"]["rmse"].is_f64(), "{results}");
}

/// So it is among hard cases: what failed is told, and the figures after it are there.
#[test]
fn a_lost_device_loses_one_hard_case() {
    let folder = Folder::new();
    let ran = folder
        .command("stability paper empty --formats isotropic --resolutions 16 --size 16x16 --json out.json")
        .env("VOXLUME_LOSE_DEVICE_AFTER", "12")
        .output()
        .unwrap();
    let stderr = String::from_utf8(ran.stderr).unwrap();
    assert_eq!(ran.status.code(), Some(1), "{stderr}");
    assert!(stderr.ends_with("error: 1 of 2 figures are out of their bounds\n"), "{stderr}");
    let json: Value =
        serde_json::from_str(&fs::read_to_string(folder.path().join("out.json")).unwrap()).unwrap();
    assert!(json["rows"][0]["figure"].as_str().unwrap().contains("the device was lost"), "{json}");
    assert!(json["rows"][1]["pass"] == true && json["rows"][1]["value"] == 0.0, "{json}");
}

#[test]
fn a_plan_over_its_budget_is_refused_before_the_device_is_asked() {
    let folder = Folder::new();
    let ran = folder.run(&format!("render {CORNELL} --resolution 128 --memory-budget 8 -o out.png"));
    assert_eq!(ran.code, Some(2));
    assert!(ran.stderr.contains("error: the plan needs at least "), "{}", ran.stderr);
    assert!(
        ran.stderr.contains(" bytes on the device, over the budget of 8388608\n = most of all `"),
        "{}",
        ran.stderr
    );
    assert!(!ran.stderr.contains("compiling"), "{}", ran.stderr);
    // Enough for what is known beforehand, not for the voxels that are counted then.
    let ran =
        folder.run(&format!("render {CORNELL} --resolution 128 --size 16x16 --memory-budget 22 -o out.png"));
    assert_eq!(ran.code, Some(2), "{}", ran.stderr);
    assert!(
        ran.stderr.contains("occupied voxels, over the budget of 23068672: choose a lower resolution"),
        "{}",
        ran.stderr
    );
    assert!(!folder.path().join("out.png").exists());
}

/// A folder on a disk of 64 KiB, if this process may mount one.
struct SmallDisk<'f>(&'f Path);

impl SmallDisk<'_> {
    fn new(at: &Path) -> Option<SmallDisk<'_>> {
        let mounted = Command::new("mount").args(["-t", "tmpfs", "-o", "size=64k", "tmpfs"]).arg(at).output();
        match mounted {
            Ok(output) if output.status.success() => Some(SmallDisk(at)),
            other => {
                println!("skipped: no small disk can be mounted here: {other:?}");
                None
            }
        }
    }
}

impl Drop for SmallDisk<'_> {
    fn drop(&mut self) {
        let _ = Command::new("umount").arg(self.0).status();
    }
}

#[test]
fn a_full_disk_leaves_the_old_file_and_no_half_of_the_new_one() {
    let folder = Folder::new();
    let at = folder.path().join("disk");
    fs::create_dir(&at).unwrap();
    let Some(_disk) = SmallDisk::new(&at) else { return };
    fs::write(at.join("out.exr"), "old").unwrap();
    for words in [
        format!("render {CORNELL} --resolution 16 --size 256x256 -o disk/out.exr"),
        format!("render {MOVING} --resolution 16 --size 256x256 --frames 0..9 -o disk/{{}}.exr"),
        format!("reference {CORNELL} --size 256x256 --spp 2 -o disk/out.exr"),
        format!(
            "voxelize {CORNELL} --resolution 64 --channel occupancy -o disk/out.ply --json disk/out.json"
        ),
    ] {
        let ran = folder.run(&words);
        assert_eq!(ran.code, Some(1), "{words}: {}", ran.stderr);
        assert!(
            ran.stderr.contains("cannot write `") && ran.stderr.contains("No space left on device"),
            "{words}: {}",
            ran.stderr
        );
        assert_eq!(names(&at), ["out.exr"], "{words}");
        assert_eq!(fs::read_to_string(at.join("out.exr")).unwrap(), "old");
    }
}

#[test]
fn standard_output_that_is_full() {
    let folder = Folder::new();
    let ran = folder.command("stability --list").stdout(File::create("/dev/full").unwrap()).output().unwrap();
    assert_eq!(ran.status.code(), Some(1));
    let stderr = String::from_utf8(ran.stderr).unwrap();
    assert_eq!(stderr, "error: cannot write to the standard output: No space left on device (os error 28)\n");
}

/// Starts, waits until stderr says `until`, and sends Ctrl-C. The exit code and stderr.
fn interrupted(command: Command, until: &str) -> (Option<i32>, String) {
    interrupted_when(command, until, || true)
}

/// As `interrupted`, once something else holds too.
fn interrupted_when(mut command: Command, until: &str, ready: impl Fn() -> bool) -> (Option<i32>, String) {
    let mut child: Child = command.stderr(Stdio::piped()).stdout(Stdio::piped()).spawn().unwrap();
    let mut stderr = child.stderr.take().unwrap();
    let mut told = Vec::new();
    let mut byte = [0];
    while !String::from_utf8_lossy(&told).contains(until) && stderr.read(&mut byte).unwrap() == 1 {
        told.push(byte[0]);
    }
    while !ready() {
        assert!(child.try_wait().unwrap().is_none(), "it ended by itself");
        std::thread::sleep(Duration::from_millis(5));
    }
    assert!(Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap().success());
    stderr.read_to_end(&mut told).unwrap();
    (child.wait().unwrap().code(), String::from_utf8(told).unwrap())
}

#[test]
fn ctrl_c_while_frames_are_rendered() {
    let folder = Folder::new();
    let before = folder.contents();
    let words = format!("render {CORNELL} --resolution 16 --size 16x16 --repeat 100000 -o out.png");
    let (code, stderr) = interrupted(folder.command(&words), "rendering");
    assert_eq!(code, Some(1), "{stderr}");
    assert!(stderr.ends_with("error: interrupted; nothing was written\n"), "{stderr}");
    assert_eq!(folder.contents(), before);
}

#[test]
fn ctrl_c_while_a_scene_is_voxelized() {
    let folder = Folder::new();
    let before = folder.contents();
    let words = format!("voxelize {CORNELL} --resolution 16 --repeat 100000 -o out.ply --json out.json");
    let (code, stderr) = interrupted(folder.command(&words), "voxelizing");
    assert_eq!(code, Some(1), "{stderr}");
    assert!(stderr.ends_with("error: interrupted; nothing was written\n"), "{stderr}");
    assert_eq!(folder.contents(), before);
}

/// Frames that are done are kept, whole.
#[test]
fn ctrl_c_in_an_animation() {
    let folder = Folder::new();
    let out = folder.path().join("out");
    fs::create_dir(&out).unwrap();
    let words = format!(
        "render {MOVING} --resolution 16 --size 16x16 --frames 0..100000 -o out/{{}}.png --json out/times.json"
    );
    let (code, stderr) = interrupted_when(folder.command(&words), "rendering", || out.join("2.png").exists());
    assert_eq!(code, Some(1), "{stderr}");
    let count = names(&out).len();
    assert!(
        stderr.ends_with(&format!("error: interrupted; {count} of 100000 frames were written\n")),
        "{count} files\n{stderr}"
    );
    for number in 0..count {
        image::open(out.join(format!("{number}.png"))).unwrap();
    }
}

#[test]
fn ctrl_c_while_a_reference_is_traced() {
    let folder = Folder::new();
    let before = folder.contents();
    let words = format!("reference {CORNELL} --size 512x512 --spp 1000000 -o out.exr");
    let (code, stderr) = interrupted(folder.command(&words), "tracing");
    assert_eq!(code, Some(1), "{stderr}");
    assert!(stderr.ends_with("error: interrupted; nothing was written\n"), "{stderr}");
    assert_eq!(folder.contents(), before);
}

/// What is finished is kept, and the same command goes on from there.
#[test]
fn ctrl_c_in_a_sweep() {
    let folder = Folder::new();
    let words = format!(
        "compare {CORNELL} --size 16x16 --resolutions 16 --spp 2 --repeat 2000 --formats all --effects diffuse --out out"
    );
    let (code, stderr) = interrupted(folder.command(&words), "cell 2/3");
    assert_eq!(code, Some(1), "{stderr}");
    assert!(stderr.contains("error: interrupted: "), "{stderr}");
    assert!(
        stderr.contains("of 3 cells are finished and kept in `out`; the same command goes on from there"),
        "{stderr}"
    );
    assert!(!names(&folder.path().join("out/cells")).is_empty());
    assert!(!folder.path().join("out/results.json").exists());
}

#[test]
fn ctrl_c_among_hard_cases_keeps_what_is_finished() {
    let folder = Folder::new();
    let (code, stderr) =
        interrupted(folder.command("stability --resolutions 16 --size 16x16 --json out.json"), "cell 1/");
    assert_eq!(code, Some(1), "{stderr}");
    assert!(stderr.contains("error: interrupted: "), "{stderr}");
    let json: Value =
        serde_json::from_str(&fs::read_to_string(folder.path().join("out.json")).unwrap()).unwrap();
    assert!(!json["rows"].as_array().unwrap().is_empty());
}
