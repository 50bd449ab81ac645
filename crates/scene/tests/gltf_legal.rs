//! Files that glTF 2.0 allows in corners that few use, and what is said of files that are something else.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod common;

use common::{Builder, Folder};
use glam::Vec3;
use serde_json::json;
use voxlume_scene::Scene;

#[test]
fn an_animation_may_have_no_node() {
    let mut file = Builder::triangle();
    let [times, values] =
        [("SCALAR", [0.0, 1.0].as_slice()), ("VEC3", &[0.0; 6])].map(|(kind, data)| file.floats(kind, data));
    file.json["animations"] = json!([{
        "samplers": [{"input": times, "output": values}],
        "channels": [{"sampler": 0, "target": {"path": "pointer", "extensions": {"KHR_animation_pointer": {"pointer": "/materials/0/alphaCutoff"}}}}],
    }]);
    assert_eq!(file.load().unwrap().meshes.len(), 1);
}

/// Nor one by the number that the parser takes for none.
#[test]
fn a_texture_may_have_no_image() {
    for empty in [json!({}), json!({"source": u32::MAX})] {
        let mut file = Builder::triangle();
        file.json["textures"] = json!([empty]);
        let texture = json!({"index": 0});
        let pbr = json!({"baseColorTexture": texture, "roughnessFactor": 0.25});
        file.json["materials"] = json!([{
            "normalTexture": texture, "emissiveTexture": texture, "pbrMetallicRoughness": pbr,
        }]);
        file.json["meshes"][0]["primitives"][0]["material"] = json!(0);
        let scene = file.load().unwrap();
        let material = &scene.materials[scene.meshes[0].material];
        assert!(material.base_color_texture.is_none() && material.normal_texture.is_none());
        assert_eq!(material.roughness, 0.25);
    }
}

#[test]
fn an_image_in_an_extension_is_named() {
    let mut file = Builder::triangle();
    file.json["textures"] = json!([{"extensions": {"EXT_texture_webp": {"source": 0}}}]);
    let said = file.load().unwrap_err().to_string();
    assert!(said.contains("textures[0]") && said.contains("EXT_texture_webp"), "{said}");
}

#[test]
fn an_accessor_without_a_view_is_all_zeros() {
    let mut file = Builder::triangle();
    file.json["accessors"]
        .as_array_mut()
        .unwrap()
        .push(json!({"componentType": 5126, "count": 3, "type": "VEC2"}));
    let index = file.json["accessors"].as_array().unwrap().len() - 1;
    file.json["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_0"] = json!(index);
    assert_eq!(file.load().unwrap().meshes[0].positions.len(), 3);
}

#[test]
fn a_scene_may_have_no_nodes_and_positions_no_bounds() {
    let mut file = Builder::triangle();
    let scene = json!({"name": "empty"});
    file.json["scenes"].as_array_mut().unwrap().push(scene);
    for accessor in file.json["accessors"].as_array_mut().unwrap() {
        let accessor = accessor.as_object_mut().unwrap();
        accessor.remove("min");
        accessor.remove("max");
    }
    let scene = file.load().unwrap();
    assert!(scene.bounds().is_some_and(|(low, high)| (high - low).as_vec3() != Vec3::ZERO));
}

#[test]
fn other_files_are_called_by_their_names() {
    let pointer = "version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 1\n";
    let files = [
        ("a pointer of Git LFS", pointer),
        ("HTML", "<!DOCTYPE html><title>404</title>"),
        ("glTF version 1.0; only 2 is supported", r#"{"asset": {"version": "1.0"}, "meshes": {"a": {}}}"#),
    ];
    for (name, text) in files {
        let folder = Folder::new();
        let said = Scene::load(&folder.write("a.gltf", text.as_bytes())).unwrap_err().to_string();
        assert!(said.contains(name), "{said}");
    }
}
