//! `voxlume render --frames`.

use serde_json::Value;

use crate::folder::{Folder, SCENE};

/// The square moves to the right, out of the picture.
fn moving() -> Folder {
    let folder = Folder::new();
    let path = "material: \"white\", path: [(time: 0), (time: 1, translate: (20, 0, 0))]";
    folder.edit("box.ron", SCENE, "material: \"white\"", path);
    folder
}

#[test]
fn numbered_files_and_times() {
    let folder = moving();
    std::fs::create_dir(folder.path().join("out")).unwrap();
    let ran = folder.run(
        "render box.ron --pipeline pipe.ron --size 16x16 --frames 1..4 --fps 4 -o out/f{:02}.png -o {}.exr --json t.json",
    );
    assert_eq!(ran.code, Some(0), "{}", ran.stderr);
    let mut names: Vec<String> = folder.contents().into_keys().collect();
    names.retain(|name| name.ends_with("exr"));
    assert_eq!(names, ["1.exr", "2.exr", "3.exr"]);
    let image = |name: &str| image::open(folder.path().join("out").join(name)).unwrap().into_rgb8();
    let files = std::fs::read_dir(folder.path().join("out")).unwrap().count();
    assert_eq!((files, image("f02.png").dimensions()), (3, (16, 16)));
    // At a quarter of a second it is 5 to the right, where the picture ends at 1.2.
    assert!(image("f01.png").pixels().all(|pixel| pixel.0 == [0; 3]));

    let json: Value =
        serde_json::from_str(&std::fs::read_to_string(folder.path().join("t.json")).unwrap()).unwrap();
    let each = [1, 2, 3].map(|frame| serde_json::json!({ "frame": frame, "ran": ["gbuffer", "tint"] }));
    let frames = serde_json::json!({ "first": 1, "end": 4, "fps": 4.0, "each": each });
    assert_eq!(json["frames"], frames);
    assert!(
        ran.stdout.contains("times of 3 frames (spread: interquartile range) after one of warm-up"),
        "{}",
        ran.stdout
    );
}

#[test]
fn what_frames_ran() {
    let folder = moving();
    // From the second on the square is at rest.
    let ran = folder.run("render box.ron --pipeline pipe.ron --size 8x8 --frames 3..7 --fps 4 -o {}.png");
    assert_eq!(ran.code, Some(0), "{}", ran.stderr);
    let (_, runs) = ran.stdout.split_once("passes that ran\n").unwrap();
    assert_eq!(runs, "frames 3 to 4: gbuffer, tint\nframes 5 to 6: none\n");
}

#[test]
fn one_moment() {
    let folder = moving();
    let lit = |time: &str| {
        let ran =
            folder.run(&format!("render box.ron --pipeline pipe.ron --size 16x16 --time {time} -o one.png"));
        assert_eq!(ran.code, Some(0), "{}", ran.stderr);
        image::open(folder.path().join("one.png")).unwrap().into_rgb8().get_pixel(8, 8).0[0] > 0
    };
    assert_eq!([lit("0"), lit("1"), lit("-3")], [true, false, true]);
}

#[test]
fn nothing_moves() {
    Folder::new().refuses(
        "render box.ron --frames 0..4 -o {}.png",
        "loading box.ron
error: nothing moves in `box.ron`
 = `--frames` needs an object, a light or a camera with a `path`",
    );
}

#[test]
fn no_place_for_the_number() {
    moving().refuses(
        "render box.ron --frames 0..4 -o out.png",
        "error: `out.png` has no place for the frame's number, or several
 = such as frame_{:04}.png",
    );
}

#[test]
fn no_such_folder() {
    moving().refuses(
        "render box.ron --frames 7..9 -o nowhere/{:03}.png",
        "error: cannot write `nowhere/007.png`: its folder does not exist or takes no files",
    );
}

#[test]
fn ranges() {
    moving().refuses(
        "render box.ron --frames 4..4 -o {}.png",
        "error: invalid value '4..4' for '--frames <A..B>': two whole numbers, the second above the first, such as 0..48

For more information, try '--help'.",
    );
    moving().refuses(
        "render box.ron --fps 30 -o out.png",
        "error: the following required arguments were not provided:
  --frames <A..B>

Usage: voxlume render -o <FILE> --frames <A..B> --fps <N> <SCENE>

For more information, try '--help'.",
    );
}
