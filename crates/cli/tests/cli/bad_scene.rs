//! Scenes that can't be read.

use crate::folder::Folder;

#[test]
fn missing() {
    Folder::new().refuses(
        "render none.glb -o out.png",
        "loading none.glb
error: cannot read `none.glb`: no such file",
    );
}

#[test]
fn truncated_glb() {
    let folder = Folder::new();
    // A header that promises 1000 bytes.
    folder.file("short.glb", b"glTF\x02\0\0\0\xe8\x03\0\0\x04\0\0\0JSON{  }");
    folder.refuses(
        "render short.glb -o out.png",
        "loading short.glb
error: `short.glb`: truncated: 1000 bytes are announced, 24 are there",
    );
}

#[test]
fn uri_outside_the_folder() {
    let folder = Folder::new();
    folder.file(
        "a.gltf",
        r#"{"asset": {"version": "2.0"}, "buffers": [{"byteLength": 36, "uri": "../secret.bin"}]}"#,
    );
    folder.refuses(
        "render a.gltf -o out.png",
        "loading a.gltf
error: `a.gltf`: buffers[0].uri: `../secret.bin` leads outside the scene's folder",
    );
}

#[test]
fn no_scene_by_its_name() {
    Folder::new().refuses(
        "render tint.wgsl -o out.png",
        "loading tint.wgsl
error: `tint.wgsl` is not a scene file by its extension
 = one of: ron, gltf, glb",
    );
}

#[test]
fn unknown_camera() {
    Folder::new().refuses(
        "render box.ron --camera frnt -o out.png",
        "loading box.ron
error: unknown camera `frnt`
 = did you mean `front`? one of: front, side",
    );
}
