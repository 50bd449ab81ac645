//! Files that can't be written, found out before anything is loaded.

use crate::folder::Folder;

#[test]
fn unknown_extension() {
    Folder::new().refuses(
        "render box.ron -o out.jpg",
        "error: `out.jpg` is no picture by its extension
 = one of: png, exr",
    );
}

#[test]
fn no_such_folder() {
    Folder::new().refuses(
        "render box.ron -o out.png -o nowhere/out.exr",
        "error: cannot write `nowhere/out.exr`: its folder does not exist or takes no files",
    );
}

#[test]
fn a_folder_of_that_name() {
    let folder = Folder::new();
    std::fs::create_dir(folder.path().join("out.png")).unwrap();
    folder.refuses(
        "render box.ron -o out.png",
        "error: cannot write `out.png`: there is something else of that name",
    );
}

#[test]
fn one_file_twice() {
    let folder = Folder::new();
    for (words, twice) in [
        ("render box.ron -o out.png -o out.exr -o ./out.png", "./out.png"),
        ("render box.ron -o {}.png -o {}.png --frames 1..3", "1.png"),
        ("voxelize box.ron -o out.ply --json out.ply", "out.ply"),
        ("reference box.ron -o out.png -o out.png", "out.png"),
        ("stability --json out --html out", "out"),
    ] {
        folder.refuses(words, &format!("error: `{twice}` is to be written twice"));
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_folder_that_takes_no_files() {
    Folder::new().refuses(
        "render box.ron -o out.png --json /proc/times.json",
        "error: cannot write `/proc/times.json`: its folder does not exist or takes no files",
    );
}
