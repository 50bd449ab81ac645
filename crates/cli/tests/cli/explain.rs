//! `voxlume explain`.

use crate::folder::Folder;

#[test]
fn tells_the_plan() {
    let ran = Folder::new().run("explain box.ron --pipeline pipe.ron --size 64x32 --resolution 64");
    assert_eq!((ran.code, ran.stderr.as_str()), (Some(0), ""));
    let head = "isotropic rgba16float, traced by rays · grid 64 × 64 × 64, voxels of 0.0328 · 64 × 32 pixels · 2 triangles\n";
    assert_eq!(ran.stdout.lines().next(), Some(head.trim_end()));
    assert!(ran.stdout.contains("\n  tint               surface → tint\n"), "{}", ran.stdout);
}
