//! `--wgsl`: shaders from a folder.

use crate::folder::Folder;

#[test]
fn a_folders_modules_take_the_place_of_the_built_in_ones() {
    let folder = Folder::new();
    let wgsl = folder.path().join("mine/common");
    std::fs::create_dir_all(&wgsl).unwrap();
    std::fs::write(wgsl.join("constants.wgsl"), "const PI = 3.0\n").unwrap();
    let ran = folder.run("explain box.ron --wgsl mine");
    assert_eq!(ran.code, Some(2));
    assert!(ran.stderr.contains("mine/common/constants.wgsl:"), "{}", ran.stderr);
    let cone = include_str!("../../../../wgsl/common/constants.wgsl");
    std::fs::write(wgsl.join("constants.wgsl"), cone).unwrap();
    assert_eq!(folder.run("--wgsl mine explain box.ron").code, Some(0));
}

#[test]
fn folders_without_shaders() {
    let folder = Folder::new();
    std::fs::create_dir(folder.path().join("empty")).unwrap();
    folder.refuses("explain box.ron --wgsl empty", "error: no .wgsl file in `empty`");
    folder.refuses(
        "explain box.ron --wgsl gone",
        "error: cannot read `gone`: No such file or directory (os error 2)",
    );
}
