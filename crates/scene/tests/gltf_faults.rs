//! Bad glTF files: the whole message of each.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod common;

use common::{Builder, Folder, png};
use insta::assert_snapshot;
use serde_json::{Value, json};

/// The fault of a triangle changed by `change`.
fn fault(change: impl FnOnce(&mut Value)) -> String {
    let mut file = Builder::triangle();
    change(&mut file.json);
    file.fault()
}

#[test]
fn files() {
    let folder = Folder::new();
    assert_snapshot!(folder.fault("none.glb"), @"error: cannot read `DIR/none.glb`: no such file");
    assert_snapshot!(folder.fault("none.obj"), @r"
    error: `DIR/none.obj` is not a scene file by its extension
     = one of: ron, gltf, glb
    ");
    folder.write("text.glb", "hello");
    assert_snapshot!(folder.fault("text.glb"), @"error: `DIR/text.glb`: not a glTF file: expected value at line 1 column 1");
    folder.write("empty.gltf", "");
    assert_snapshot!(folder.fault("empty.gltf"), @"error: `DIR/empty.gltf`: not a glTF file: EOF while parsing a value at line 1 column 0");
    folder.write("old.gltf", r#"{"asset": {"version": "1.0"}}"#);
    assert_snapshot!(folder.fault("old.gltf"), @"error: `DIR/old.gltf`: glTF version 1.0; only 2 is supported");
    folder.write("wrong.gltf", r#"{"asset": {"version": "2.0"}, "nodes": [{"mesh": "a"}]}"#);
    assert_snapshot!(folder.fault("wrong.gltf"), @r#"error: `DIR/wrong.gltf`: not a glTF file: invalid type: string "a", expected index into child of root at line 1 column 52"#);
}

/// No cut of a good file, and no change of one of its bytes, makes the loader panic; cuts are always refused.
#[test]
fn truncated_and_damaged() {
    let whole = Builder::triangle().glb();
    let folder = Folder::new();
    for length in 0..whole.len() {
        folder.write("cut.glb", &whole[..length]);
        folder.fault("cut.glb");
    }
    folder.write("cut.glb", &whole[..whole.len() - 10]);
    assert_snapshot!(folder.fault("cut.glb"), @"error: `DIR/cut.glb`: truncated: 412 bytes are announced, 402 are there");
    folder.write("cut.glb", &whole[..7]);
    assert_snapshot!(folder.fault("cut.glb"), @"error: `DIR/cut.glb`: truncated: 12 bytes are announced, 7 are there");
    for at in 0..whole.len() {
        for value in [0xff, b'9', whole[at] ^ 1] {
            let mut damaged = whole.clone();
            damaged[at] = value;
            folder.write("damaged.glb", &damaged);
            let _ = folder.load("damaged.glb");
        }
    }
    let mut announced = whole.clone();
    announced[8] += 4;
    folder.write("announced.glb", &announced);
    assert_snapshot!(folder.fault("announced.glb"), @"error: `DIR/announced.glb`: truncated: 416 bytes are announced, 412 are there");
    let mut version = whole.clone();
    version[4] = 3;
    folder.write("version.glb", &version);
    assert_snapshot!(folder.fault("version.glb"), @"error: `DIR/version.glb`: GLB version 3; only 2 is supported");
    let mut chunk = whole;
    chunk[16..20].copy_from_slice(b"BIN\0");
    folder.write("chunk.glb", &chunk);
    assert_snapshot!(folder.fault("chunk.glb"), @"error: `DIR/chunk.glb`: the first chunk is not JSON");
}

#[test]
fn buffers() {
    let folder = Folder::new();
    let load = |buffer: Value| {
        let mut file = Builder::triangle();
        file.json["buffers"] = json!([buffer]);
        folder.write("a.gltf", file.json.to_string());
        folder.fault("a.gltf")
    };
    folder.write("short.bin", [0; 30]);
    folder.write("sub/a.bin", [0; 36]);
    assert_snapshot!(load(json!({"byteLength": 36, "uri": "none.bin"})), @"error: `DIR/a.gltf`: buffers[0].uri: cannot read `DIR/none.bin`: no such file");
    assert_snapshot!(load(json!({"byteLength": 36, "uri": "short.bin"})), @"error: `DIR/a.gltf`: buffers[0]: truncated: 36 bytes are announced, 30 are there");
    assert_snapshot!(load(json!({"byteLength": 36, "uri": "sub/../../a.bin"})), @"error: `DIR/a.gltf`: buffers[0].uri: `sub/../../a.bin` leads outside the scene's folder");
    assert_snapshot!(load(json!({"byteLength": 36, "uri": "%2e%2e/a.bin"})), @"error: `DIR/a.gltf`: buffers[0].uri: `%2e%2e/a.bin` leads outside the scene's folder");
    assert_snapshot!(load(json!({"byteLength": 36, "uri": "/etc/passwd"})), @"error: `DIR/a.gltf`: buffers[0].uri: `/etc/passwd` leads outside the scene's folder");
    assert_snapshot!(load(json!({"byteLength": 36, "uri": "file:///etc/passwd"})), @"error: `DIR/a.gltf`: buffers[0].uri: the scheme of `file:///etc/passwd` is `file:`; only files and `data:` are read");
    assert_snapshot!(load(json!({"byteLength": 36})), @"error: `DIR/a.gltf`: buffers[0]: neither a uri nor a binary chunk");
}

#[test]
fn images() {
    let image = |file: &[u8]| {
        let mut scene = Builder::triangle();
        let view = scene.view(file);
        scene.json["images"] = json!([{"bufferView": view}]);
        scene.json["textures"] = json!([{"source": 0}]);
        scene.json["materials"] = json!([{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}]);
        scene.json["meshes"][0]["primitives"][0]["material"] = json!(0);
        scene.fault()
    };
    assert_snapshot!(image(b"this is not an image"), @"error: `DIR/a.glb`: images[0]: not an image: only PNG and JPEG are read");
    assert_snapshot!(image(b"GIF89a\x01\x00\x01\x00"), @"error: `DIR/a.glb`: images[0]: not an image: only PNG and JPEG are read");
    let whole = png(&[[1, 2, 3, 4]; 100]);
    assert_snapshot!(image(&whole[..whole.len() / 2]), @"error: `DIR/a.glb`: images[0]: cannot be decoded: unexpected end of file");
    let mut huge = whole;
    huge[16..24].copy_from_slice(&[0, 0, 0x7f, 0xff, 0, 0, 0xff, 0xff]);
    // Its checksum, of which the header is part.
    let checksum = crc(&huge[12..29]);
    huge[29..33].copy_from_slice(&checksum.to_be_bytes());
    assert_snapshot!(image(&huge), @"error: `DIR/a.glb`: the scene would take more than 4 GiB");
    let mut file = Builder::triangle();
    file.json["images"] = json!([{"uri": "../secret.png"}]);
    file.json["textures"] = json!([{"source": 0}]);
    file.json["materials"] = json!([{"normalTexture": {"index": 0}}]);
    file.json["meshes"][0]["primitives"][0]["material"] = json!(0);
    assert_snapshot!(file.fault(), @"error: `DIR/a.glb`: images[0].uri: `../secret.png` leads outside the scene's folder");
}

/// CRC-32 as PNG has it.
fn crc(bytes: &[u8]) -> u32 {
    !bytes.iter().fold(!0_u32, |crc, byte| {
        (0..8).fold(
            crc ^ u32::from(*byte),
            |crc, _| if crc & 1 == 1 { 0xedb8_8320 ^ (crc >> 1) } else { crc >> 1 },
        )
    })
}

#[test]
fn vertices() {
    let attribute = |name: &str, kind: &str, values: &[f32]| {
        let mut file = Builder::triangle();
        let accessor = file.floats(kind, values);
        file.json["meshes"][0]["primitives"][0]["attributes"][name] = json!(accessor);
        file.fault()
    };
    let nan = f32::NAN;
    assert_snapshot!(attribute("POSITION", "VEC3", &[0., 0., 0., 0., 0., 0., 0., nan, 0.]), @"error: `DIR/a.glb`: meshes[0].primitives[0]: POSITION of vertex 2 is not finite");
    assert_snapshot!(attribute("POSITION", "VEC3", &[0., 0., 0., 0., f32::INFINITY, 0., 0., 0., 0.]), @"error: `DIR/a.glb`: meshes[0].primitives[0]: POSITION of vertex 1 is not finite");
    assert_snapshot!(attribute("NORMAL", "VEC3", &[nan, 0., 0., 0., 0., 0., 0., 0., 0.]), @"error: `DIR/a.glb`: meshes[0].primitives[0]: NORMAL of vertex 0 is not finite");
    assert_snapshot!(attribute("TEXCOORD_0", "VEC2", &[0., 0., 0., nan, 0., 0.]), @"error: `DIR/a.glb`: meshes[0].primitives[0]: TEXCOORD_0 of vertex 1 is not finite");
    assert_snapshot!(attribute("TANGENT", "VEC4", &[0., 0., 0., nan, 0., 0., 0., 0., 0., 0., 0., 0.]), @"error: `DIR/a.glb`: meshes[0].primitives[0]: TANGENT of vertex 0 is not finite");
    assert_snapshot!(attribute("NORMAL", "VEC3", &[0.; 6]), @"error: `DIR/a.glb`: meshes[0].primitives[0]: 2 values of NORMAL for 3 vertices");
    assert_snapshot!(attribute("NORMAL", "VEC2", &[0.; 6]), @"error: `DIR/a.glb`: meshes[0].primitives[0]: NORMAL: accessors[1]: VEC3 is needed, it is VEC2");
    assert_snapshot!(attribute("POSITION", "VEC3", &[1e20, 0., 0., 0., 0., 0., 0., 0., 0.]), @"error: `DIR/a.glb`: `node 0` reaches beyond 1e15 units");
}

#[test]
fn indices() {
    let indices = |indices: &[u16]| {
        let mut file = Builder::triangle();
        let accessor = file.indices(indices);
        file.json["meshes"][0]["primitives"][0]["indices"] = json!(accessor);
        file.fault()
    };
    assert_snapshot!(indices(&[0, 1, 2, 0, 3, 1]), @"error: `DIR/a.glb`: meshes[0].primitives[0]: index 3 at 4 is out of range: there are 3 vertices");
    assert_snapshot!(indices(&[0, 1, 2, 0]), @"error: `DIR/a.glb`: meshes[0].primitives[0]: 4 indices are not a multiple of 3");
    assert_snapshot!(indices(&[0xffff, 1, 2]), @"error: `DIR/a.glb`: meshes[0].primitives[0]: index 65535 at 0 is out of range: there are 3 vertices");
    assert_snapshot!(fault(|json| json["meshes"][0]["primitives"][0]["indices"] = json!(0)), @"error: `DIR/a.glb`: meshes[0].primitives[0]: indices: accessors[0]: indices must be unsigned integers, SCALAR");
}

#[test]
fn accessors() {
    assert_snapshot!(fault(|json| json["accessors"][0]["count"] = json!(4)), @"error: `DIR/a.glb`: meshes[0].primitives[0]: POSITION: accessors[0]: 4 items reach beyond bufferViews[0]");
    assert_snapshot!(fault(|json| json["accessors"][0]["byteOffset"] = json!(u64::MAX)), @"error: `DIR/a.glb`: meshes[0].primitives[0]: POSITION: accessors[0]: 3 items reach beyond bufferViews[0]");
    assert_snapshot!(fault(|json| json["accessors"][0]["count"] = json!(u64::MAX)), @"error: `DIR/a.glb`: meshes[0].primitives[0]: the scene would take more than 4 GiB");
    assert_snapshot!(fault(|json| json["bufferViews"][0]["byteLength"] = json!(u64::MAX)), @"error: `DIR/a.glb`: meshes[0].primitives[0]: POSITION: bufferViews[0]: reaches beyond its buffer");
    assert_snapshot!(fault(|json| json["bufferViews"][0]["byteOffset"] = json!(u64::MAX)), @"error: `DIR/a.glb`: meshes[0].primitives[0]: POSITION: bufferViews[0]: reaches beyond its buffer");
    assert_snapshot!(fault(|json| json["bufferViews"][0]["byteStride"] = json!(8)), @"error: `DIR/a.glb`: meshes[0].primitives[0]: POSITION: accessors[0]: items of 12 bytes do not fit a stride of 8");
    assert_snapshot!(fault(|json| json["accessors"][0]["componentType"] = json!(5125)), @"error: `DIR/a.glb`: meshes[0].primitives[0]: POSITION: accessors[0]: floats are needed, it has 32-bit integers");
    let mut file = Builder::triangle();
    let indices = file.view(&[9]);
    let values = file.view(&[0; 12]);
    file.json["accessors"][0]["sparse"] = json!({
        "count": 1, "indices": {"bufferView": indices, "componentType": 5121}, "values": {"bufferView": values},
    });
    assert_snapshot!(file.fault(), @"error: `DIR/a.glb`: meshes[0].primitives[0]: POSITION: accessors[0]: sparse index 9 is out of range: there are 3 items");
    // A small file of many vertices: nothing stands behind the count.
    let mut file = Builder::triangle();
    let indices = file.view(&[0]);
    let values = file.view(&[0; 12]);
    file.json["accessors"][0].as_object_mut().unwrap().remove("bufferView");
    file.json["accessors"][0]["count"] = json!(3_000_000_000_u64);
    file.json["accessors"][0]["sparse"] = json!({
        "count": 1, "indices": {"bufferView": indices, "componentType": 5121}, "values": {"bufferView": values},
    });
    assert_snapshot!(file.fault(), @"error: `DIR/a.glb`: meshes[0].primitives[0]: the scene would take more than 4 GiB");
}

#[test]
fn references() {
    assert_snapshot!(fault(|json| json["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = json!(7)), @r#"error: `DIR/a.glb`: meshes[0].primitives[0].attributes["POSITION"]: index 7 is out of range: there are 1"#);
    assert_snapshot!(fault(|json| {
        json["nodes"][0]["mesh"] = json!(3);
        json["meshes"][0]["primitives"][0]["material"] = json!(0);
    }), @r"
    error: `DIR/a.glb`: meshes[0].primitives[0].material: the index is out of range

    error: `DIR/a.glb`: nodes[0].mesh: the index is out of range
    ");
    assert_snapshot!(fault(|json| json["meshes"][0]["primitives"][0]["attributes"] = json!({})), @r#"error: `DIR/a.glb`: meshes[0].primitives[0].attributes["POSITION"]: missing"#);
    assert_snapshot!(fault(|json| json["nodes"][0]["children"] = json!([0])), @"error: `DIR/a.glb`: nodes[0]: reached twice; nodes must form a tree");
    assert_snapshot!(fault(|json| json["extensionsRequired"] = json!(["KHR_lights_punctual", "KHR_draco_mesh_compression", "X"])), @r"
    error: `DIR/a.glb`: the extension `KHR_draco_mesh_compression` is required and not supported
     = one of: KHR_lights_punctual, KHR_materials_emissive_strength, KHR_mesh_quantization, KHR_texture_transform

    error: `DIR/a.glb`: the extension `X` is required and not supported
     = one of: KHR_lights_punctual, KHR_materials_emissive_strength, KHR_mesh_quantization, KHR_texture_transform
    ");
}

#[test]
fn values() {
    let material = |material: Value| {
        fault(|json| {
            json["materials"] = json!([material]);
            json["meshes"][0]["primitives"][0]["material"] = json!(0);
        })
    };
    assert_snapshot!(material(json!({"pbrMetallicRoughness": {"metallicFactor": 2, "roughnessFactor": -1}})), @r"
    error: `DIR/a.glb`: materials[0]: metallicFactor must be from 0 to 1

    error: `DIR/a.glb`: materials[0]: roughnessFactor must be from 0 to 1
    ");
    assert_snapshot!(material(json!({"name": "m", "emissiveFactor": [-1, 0, 0]})), @"error: `DIR/a.glb`: materials[0] `m`: emissiveFactor × emissiveStrength must be finite and at least 0");
    assert_snapshot!(fault(|json| json["nodes"][0]["rotation"] = json!([0, 0, 0, 0])), @"error: `DIR/a.glb`: nodes[0]: its rotation is not a quaternion");
    assert_snapshot!(fault(|json| json["nodes"][0]["scale"] = json!([3e38, 1, 1])), @"error: `DIR/a.glb`: `node 0` reaches beyond 1e15 units");
    assert_snapshot!(fault(|json| json["nodes"][0]["matrix"] = json!([1,0,0,1, 0,1,0,0, 0,0,1,0, 0,0,0,1])), @"error: `DIR/a.glb`: nodes[0]: the last row of its matrix is not 0 0 0 1");
    let light = |light: Value| {
        fault(|json| {
            json["extensions"] = json!({"KHR_lights_punctual": {"lights": [light]}});
            json["nodes"][0]["extensions"] = json!({"KHR_lights_punctual": {"light": 0}});
        })
    };
    assert_snapshot!(light(json!({"type": "point", "intensity": -1})), @"error: `DIR/a.glb`: lights[0]: color × intensity must be finite and at least 0");
    assert_snapshot!(light(json!({"type": "spot", "spot": {"innerConeAngle": 1, "outerConeAngle": 0.5}})), @r#"
    error: `DIR/a.glb`: lights[0]: spot: the inner angle must be at least 0° and below the outer angle
    "#);
    assert_snapshot!(light(json!({"type": "spot", "spot": {"outerConeAngle": 2}})), @"error: `DIR/a.glb`: lights[0]: spot: the outer angle must be above 0° and at most 90°");
    assert_snapshot!(light(json!({"type": "spot"})), @"error: `DIR/a.glb`: extensions.khrLightsPunctual.lights[0].spot: missing");
    assert_snapshot!(fault(|json| {
        json["cameras"] = json!([{"type": "perspective", "perspective": {"yfov": 4, "znear": 1}}]);
        json["nodes"][0]["camera"] = json!(0);
    }), @r#"
    error: `DIR/a.glb`: cameras[0]: yfov must be above 0° and below 180°
    "#);
}
