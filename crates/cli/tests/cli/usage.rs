//! Wrong usage.

use crate::folder::Folder;

#[test]
fn sizes() {
    Folder::new().refuses("render box.ron --size 512 -o out.png", "error: invalid value '512' for '--size <WxH>': two whole numbers with an `x` between them, such as 640x360

For more information, try '--help'.");
    Folder::new().refuses(
        "render box.ron --size 0x64 -o out.png",
        "loading box.ron
planning
error: an image of 0 × 64 pixels
 = each side: 1 to 8192",
    );
}

#[test]
fn settings() {
    Folder::new().refuses("render box.ron --set bounces=1 -o out.png", "error: invalid value 'bounces=1' for '--set <PASS.PARAM=VALUE>': a pass, a parameter and a value, such as bounce.bounces=1

For more information, try '--help'.");
}

#[test]
fn no_output() {
    Folder::new().refuses(
        "render box.ron",
        "error: the following required arguments were not provided:
  -o <FILE>

Usage: voxlume render -o <FILE> <SCENE>

For more information, try '--help'.",
    );
}

#[test]
fn help_is_no_failure() {
    let ran = Folder::new().run("render --help");
    assert_eq!((ran.code, ran.stderr.as_str()), (Some(0), ""));
    assert!(ran.stdout.contains("Examples:\n  voxlume render scenes/cornell.ron -o cornell.png\n"));
}
