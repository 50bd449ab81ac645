//! What glTF files become.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod common;

use common::{Builder, Folder, png};
use glam::{DVec3, Vec2, Vec3, Vec4};
use serde_json::{Value, json};
use voxlume_scene::{Geometry, LightKind, Scene};

fn geometry(scene: &Scene) -> Geometry {
    Geometry::new(scene, DVec3::ZERO)
}

/// The geometric normals agree with the shading ones.
fn assert_fronts(geometry: &Geometry) {
    for t in &geometry.triangles {
        let [a, b, c] = t.map(|i| geometry.positions[i as usize]);
        let normal = (b - a).cross(c - a);
        assert!(t.iter().all(|i| geometry.normals[*i as usize].dot(normal) > 0.0), "{t:?}");
    }
}

#[test]
fn a_lone_model_gets_a_sky_a_camera_and_flat_normals() {
    let scene = Builder::triangle().load().unwrap();
    assert_eq!((scene.name.as_str(), scene.sky, scene.lights.len()), ("a", Vec3::ONE, 0));
    let mesh = &scene.meshes[0];
    assert_eq!(
        (mesh.normals.as_slice(), mesh.triangles.as_slice()),
        ([Vec3::Z; 3].as_slice(), [[0, 1, 2]].as_slice())
    );
    // The specification's default material is a white metal.
    assert_eq!((scene.materials[0].base_color, scene.materials[0].metallic), (Vec4::ONE, 1.0));
    let camera = &scene.cameras[0];
    assert_eq!((camera.name.as_str(), camera.vertical_fov.to_degrees()), ("default", 45.0));
    for corner in &mesh.positions {
        let to = (corner.as_dvec3() - camera.eye).as_vec3();
        let (ahead, up) = (to.dot(camera.forward), to.dot(camera.up));
        assert!(up.abs() < ahead * (camera.vertical_fov / 2.0).tan(), "{corner} is out of view");
    }
}

#[test]
fn an_empty_scene_loads() {
    let mut file = Builder::new();
    file.json["nodes"] = json!([{}]);
    let scene = file.load().unwrap();
    assert_eq!((scene.bounds(), scene.cameras.len(), scene.instances.len()), (None, 1, 0));
    assert_eq!(scene.emissive_polygons(DVec3::ZERO, 0), Some(vec![]));
}

#[test]
fn transforms_accumulate_mirror_and_scale() {
    let mut file = Builder::new();
    let positions = file.floats("VEC3", &[1.0, 0.0, 0.0, 1.0, 1.0, 0.0, 1.0, 0.0, 1.0]);
    // A slope between +x and +y, with a tangent along z and a bitangent of positive sign.
    let s = 0.5_f32.sqrt();
    let normals = file.floats("VEC3", &[1.0, 0.0, 0.0, s, s, 0.0, 1.0, 0.0, 0.0]);
    let tangents = file.floats("VEC4", &[0.0, 1.0, 0.0, 1.0, 0.0, 0.0, 2.0, 1.0, 0.0, 1.0, 0.0, -1.0]);
    let attributes = json!({"POSITION": positions, "NORMAL": normals, "TANGENT": tangents});
    file.json["meshes"] = json!([{"primitives": [{"attributes": attributes}]}]);
    file.json["nodes"] = json!([
        {"children": [1, 2], "translation": [10, 0, 0]},
        {"mesh": 0, "name": "mirrored", "scale": [-2, 1, 1]},
        {"mesh": 0, "rotation": [0, s, 0, s], "children": [3]},
        {"mesh": 0, "matrix": [1,0,0,0, 0,4,0,0, 0,0,1,0, 0,0,-5,1]},
    ]);
    let scene = file.load().unwrap();
    assert_eq!(
        (scene.meshes.len(), scene.instances.len(), scene.instances[0].name.as_str()),
        (1, 3, "mirrored")
    );
    let geometry = geometry(&scene);
    assert_fronts(&geometry);

    // Mirrored and stretched along x: turned round, the slope less steep in x.
    assert_eq!(geometry.triangles[0], [0, 2, 1]);
    assert_eq!(geometry.positions[1], Vec3::new(8.0, 1.0, 0.0));
    let slope = Vec3::new(-0.5, 1.0, 0.0).normalize();
    assert!(geometry.normals[1].abs_diff_eq(slope, 1e-6), "{}", geometry.normals[1]);
    // The bitangent is mirrored as any other vector.
    let bitangent =
        |i: usize| geometry.normals[i].cross(geometry.tangents[i].truncate()) * geometry.tangents[i].w;
    let before = Vec3::new(s, s, 0.0).cross(Vec3::Z);
    assert!(bitangent(1).dot(before * Vec3::new(-2.0, 1.0, 1.0)) > 0.9);
    assert!(geometry.tangents[1].abs_diff_eq(Vec4::new(0.0, 0.0, 1.0, -1.0), 1e-6));
    assert_eq!(geometry.tangents[2].w, 1.0);

    // Turned by 90° about y: +x goes to −z.
    assert!(geometry.positions[3].abs_diff_eq(Vec3::new(10.0, 0.0, -1.0), 1e-6));
    assert!(geometry.normals[3].abs_diff_eq(-Vec3::Z, 1e-6));
    // A child's matrix comes first.
    assert!(
        geometry.positions[7].abs_diff_eq(Vec3::new(10.0 - 5.0, 4.0, -1.0), 1e-6),
        "{}",
        geometry.positions[7]
    );
    let slope = Vec3::new(0.0, 0.25, -1.0).normalize();
    assert!(geometry.normals[7].abs_diff_eq(slope, 1e-6), "{}", geometry.normals[7]);

    let (low, high) = scene.bounds().unwrap();
    assert!(low.abs_diff_eq(DVec3::new(5.0, 0.0, -1.0), 1e-6), "{low}");
    assert!(high.abs_diff_eq(DVec3::new(11.0, 4.0, 1.0), 1e-6), "{high}");
}

#[test]
fn a_flattened_instance_keeps_normals() {
    let mut file = Builder::triangle();
    file.json["nodes"][0]["scale"] = json!([3, 2, 0]);
    let flat = geometry(&file.load().unwrap());
    assert_eq!(flat.normals, [Vec3::Z; 3]);
    let mut file = Builder::triangle();
    file.json["nodes"][0]["scale"] = json!([0, 0, 0]);
    let point = geometry(&file.load().unwrap());
    assert!(
        point.normals.iter().all(|n| n.is_normalized())
            && point.tangents.iter().all(|t| t.truncate().is_normalized())
    );
}

#[test]
fn strips_fans_indices_and_points() {
    let mut file = Builder::new();
    // A zigzag that faces +z.
    let positions = file.floats("VEC3", &[0., 0., 0., 1., 0., 0., 0., 1., 0., 1., 1., 0., 0., 2., 0.]);
    let bytes = file.accessor("SCALAR", 5121, 4, &[0, 1, 2, 3]);
    let words: Vec<u8> = [0_u32, 1, 3, 2].iter().flat_map(|i| i.to_le_bytes()).collect();
    let words = file.accessor("SCALAR", 5125, 4, &words);
    let primitive = |mode: u32, indices: Value| json!({"attributes": {"POSITION": positions}, "mode": mode, "indices": indices});
    file.json["meshes"] = json!([{"primitives": [
        {"attributes": {"POSITION": positions}, "mode": 5},
        primitive(5, json!(bytes)), primitive(6, json!(words)), primitive(0, json!(bytes)), primitive(3, json!(bytes)),
    ]}]);
    let scene = file.load().unwrap();
    let counts: Vec<_> = scene.meshes.iter().map(|mesh| mesh.triangles.len()).collect();
    assert_eq!(counts, [3, 2, 2]);
    let geometry = geometry(&scene);
    assert_fronts(&geometry);
    assert!(geometry.normals.iter().all(|n| *n == Vec3::Z));
}

#[test]
fn sparse_and_quantised_accessors() {
    let mut file = Builder::new();
    // Unnormalised bytes as positions, of which one is replaced; padded to a stride of 4.
    let bytes = [0_i8, 0, 0, 0, 100, 0, 0, 0, 0, 5, 0, 0].map(|v| v as u8);
    let positions = file.accessor("VEC3", 5120, 3, &bytes);
    file.json["bufferViews"][0]["byteStride"] = json!(4);
    let indices = file.view(&[1]);
    let values = file.view(&[(-7_i8) as u8, 0, 0]);
    file.json["accessors"][positions]["sparse"] = json!({
        "count": 1, "indices": {"bufferView": indices, "componentType": 5121}, "values": {"bufferView": values},
    });
    let normals = [0_i16, 0, -32768, 0, 0, -32767, 0, 0, -16000].map(i16::to_le_bytes).concat();
    let normals = file.accessor("VEC3", 5122, 3, &normals);
    file.json["accessors"][normals]["normalized"] = json!(true);
    let uvs = file.accessor("VEC2", 5120, 3, &[0, 127, 0x80, 0, 127, 127]);
    file.json["accessors"][uvs]["normalized"] = json!(true);
    file.json["meshes"] = json!([{"primitives": [{"attributes": {"POSITION": positions, "NORMAL": normals, "TEXCOORD_0": uvs}}]}]);
    file.json["extensionsRequired"] = json!(["KHR_mesh_quantization"]);
    let scene = file.load().unwrap();
    let mesh = &scene.meshes[0];
    assert_eq!(mesh.positions, [Vec3::ZERO, Vec3::new(-7.0, 0.0, 0.0), Vec3::new(0.0, 5.0, 0.0)]);
    assert_eq!(mesh.normals, [-Vec3::Z; 3]);
    assert_eq!(mesh.uvs, [Vec2::new(0.0, 1.0), Vec2::new(-1.0, 0.0), Vec2::ONE]);

    // Without a bufferView, values are zero where nothing replaces them.
    let mut file = Builder::triangle();
    let indices = file.view(&[2]);
    let values = file.view(&[1.0_f32, 2.0, 3.0].map(f32::to_le_bytes).concat());
    file.json["accessors"][0].as_object_mut().unwrap().remove("bufferView");
    file.json["accessors"][0]["sparse"] = json!({
        "count": 1, "indices": {"bufferView": indices, "componentType": 5121}, "values": {"bufferView": values},
    });
    assert_eq!(file.load().unwrap().meshes[0].positions, [Vec3::ZERO, Vec3::ZERO, Vec3::new(1.0, 2.0, 3.0)]);
}

#[test]
fn normals_without_length_come_from_the_triangles() {
    let mut file = Builder::triangle();
    let normals = file.floats("VEC3", &[0.0, 0.0, 0.0, 0.0, 3.0, 0.0, 0.0, 0.0, 0.0]);
    file.json["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = json!(normals);
    assert_eq!(file.load().unwrap().meshes[0].normals, [Vec3::Z, Vec3::Y, Vec3::Z]);
}

/// A material of every texture, over an upright picture and its mirror image.
fn textured() -> Builder {
    let mut file = Builder::new();
    // Two quads side by side that face +z; the right one has the picture mirrored. The middle vertices are shared.
    let positions =
        file.floats("VEC3", &[-1., 0., 0., 0., 0., 0., 1., 0., 0., -1., 1., 0., 0., 1., 0., 1., 1., 0.]);
    let normals = file.floats("VEC3", &[0.0, 0.0, 1.0].repeat(6));
    let uvs = file.floats("VEC2", &[0., 1., 1., 1., 0., 1., 0., 0., 1., 0., 0., 0.]);
    let indices = file.indices(&[0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4]);
    file.json["meshes"] = json!([{"primitives": [{
        "attributes": {"POSITION": positions, "NORMAL": normals, "TEXCOORD_0": uvs, "TEXCOORD_1": uvs},
        "indices": indices, "material": 0,
    }]}]);
    let view = file.view(&png(&[[255, 0, 0, 255], [0, 255, 0, 100]]));
    file.json["images"] = json!([{"bufferView": view, "name": "picture"}]);
    file.json["textures"] = json!([{"source": 0}]);
    file.json["materials"] = json!([{
        "name": "all", "doubleSided": true, "alphaMode": "MASK", "alphaCutoff": 0.5,
        "pbrMetallicRoughness": {
            "baseColorFactor": [0.5, 0.6, 0.7, 0.8], "baseColorTexture": {"index": 0},
            "metallicFactor": 0.25, "roughnessFactor": 0.75, "metallicRoughnessTexture": {"index": 0},
        },
        "normalTexture": {"index": 0, "scale": 2}, "emissiveFactor": [1, 0.5, 0], "emissiveTexture": {"index": 0},
        "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": 8}},
    }]);
    file
}

#[test]
fn materials_and_textures() {
    let scene = textured().load().unwrap();
    let material = &scene.materials[0];
    assert_eq!(
        (material.name.as_str(), material.double_sided, material.alpha_cutoff),
        ("all", true, Some(0.5))
    );
    assert_eq!(material.base_color, Vec4::new(0.5, 0.6, 0.7, 0.8));
    assert_eq!((material.metallic, material.roughness, material.normal_scale), (0.25, 0.75, 2.0));
    assert_eq!(material.emission, Vec3::new(8.0, 4.0, 0.0));
    // One image, once as colour and once as data.
    let of = |t: Option<voxlume_scene::TextureRef>| &scene.textures[t.unwrap().texture];
    assert_eq!(scene.textures.len(), 2);
    assert!(of(material.base_color_texture).srgb && of(material.emission_texture).srgb);
    assert!(!of(material.metallic_roughness_texture).srgb && !of(material.normal_texture).srgb);
    let texture = of(material.base_color_texture);
    assert_eq!((texture.name.as_str(), texture.width, texture.height), ("picture", 2, 1));
    assert_eq!(texture.rgba, [255, 0, 0, 255, 0, 255, 0, 100]);
    // An emissive texture is not an even emitter.
    assert_eq!(scene.emissive_polygons(DVec3::ZERO, 100), None);
    assert_eq!(scene.sky, Vec3::ZERO);
}

#[test]
fn masks_stay_only_where_a_texel_can_fail_them() {
    let cutoff = |mode: &str, cutoff: f32, alpha: f32| {
        let mut file = textured();
        file.json["materials"][0]["alphaMode"] = json!(mode);
        file.json["materials"][0]["alphaCutoff"] = json!(cutoff);
        file.json["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"] = json!([1, 1, 1, alpha]);
        file.load().unwrap().materials[0].alpha_cutoff
    };
    // The texture's lowest alpha is 100/255, about 0.39.
    assert_eq!(cutoff("MASK", 0.38, 1.0), None);
    assert_eq!(cutoff("MASK", 0.40, 1.0), Some(0.40));
    assert_eq!(cutoff("MASK", 0.38, 0.9), Some(0.38));
    assert_eq!(cutoff("BLEND", 0.1, 1.0), Some(0.5));
    assert_eq!(cutoff("OPAQUE", 0.5, 0.1), None);
    let mut plain = Builder::triangle();
    plain.json["materials"] = json!([{"alphaMode": "BLEND"}]);
    plain.json["meshes"][0]["primitives"][0]["material"] = json!(0);
    assert_eq!(plain.load().unwrap().materials[0].alpha_cutoff, None);
}

#[test]
fn tangents_follow_the_picture() {
    let scene = textured().load().unwrap();
    let mesh = &scene.meshes[0];
    assert_eq!(mesh.triangles.len(), 4);
    // The two shared vertices are split where the picture is mirrored.
    assert_eq!((mesh.positions.len(), mesh.tangents.len()), (8, 8));
    for (t, expected) in mesh.triangles.iter().zip([1.0, 1.0, -1.0, -1.0]) {
        for i in t {
            let tangent = mesh.tangents[*i as usize];
            // Along +u; and the bitangent, along the picture's up, is +y for both.
            assert!(tangent.abs_diff_eq(Vec4::new(expected, 0.0, 0.0, expected), 1e-6), "{t:?}: {tangent}");
        }
    }
    // Tangents in the file are kept.
    let mut file = textured();
    let tangents = file.floats("VEC4", &[0.0, 2.0, 0.0, -1.0].repeat(6));
    file.json["meshes"][0]["primitives"][0]["attributes"]["TANGENT"] = json!(tangents);
    let mesh = &file.load().unwrap().meshes[0];
    assert_eq!(mesh.tangents, [Vec4::new(0.0, 1.0, 0.0, -1.0); 6]);
}

#[test]
fn texture_transforms_are_applied_where_they_agree() {
    let transform = json!({"KHR_texture_transform": {"offset": [0.5, 0.25], "scale": [2, 3], "texCoord": 1}});
    let mut file = textured();
    let material = &mut file.json["materials"][0];
    material["pbrMetallicRoughness"]["baseColorTexture"]["extensions"] = transform.clone();
    material["pbrMetallicRoughness"]["metallicRoughnessTexture"]["extensions"] = transform.clone();
    material["normalTexture"]["extensions"] = transform.clone();
    insta::assert_snapshot!(file.fault(), @"error: `DIR/a.glb`: materials[0] `all`: baseColorTexture and emissiveTexture have different texture transforms or coordinate sets; they must agree");

    let mut file = textured();
    let material = &mut file.json["materials"][0];
    material["emissiveTexture"]["extensions"] = transform.clone();
    material["pbrMetallicRoughness"]["baseColorTexture"]["extensions"] = transform.clone();
    material["pbrMetallicRoughness"]["metallicRoughnessTexture"]["extensions"] = transform.clone();
    material["normalTexture"]["extensions"] = transform;
    let scene = file.load().unwrap();
    assert_eq!(scene.meshes[0].uvs[0], Vec2::new(0.5, 3.25));
}

#[test]
fn lights_and_cameras() {
    let mut file = Builder::triangle();
    let s = 0.5_f32.sqrt();
    file.json["scenes"][0]["nodes"] = json!([0, 1, 2, 3, 4, 5]);
    let light = |light: u32, rotation: [f32; 4]| {
        json!({"translation": [1, 2, 3], "rotation": rotation, "scale": [2, 2, 2],
            "extensions": {"KHR_lights_punctual": {"light": light}}})
    };
    // −90° about x: −z goes to −y.
    let down = [-s, 0.0, 0.0, s];
    file.json["nodes"] = json!([
        {"mesh": 0}, light(0, down), light(1, down), light(2, down),
        {"name": "eye", "camera": 0, "translation": [0, 0, 9], "rotation": down}, {"camera": 1},
    ]);
    file.json["extensions"] = json!({"KHR_lights_punctual": {"lights": [
        {"type": "directional", "color": [1, 0.5, 0.25], "intensity": 4, "name": "sun"},
        {"type": "point", "intensity": 7, "range": 2},
        {"type": "spot", "spot": {"innerConeAngle": 0.5, "outerConeAngle": 0.5}},
    ]}});
    file.json["extensionsRequired"] = json!(["KHR_lights_punctual"]);
    file.json["cameras"] = json!([
        {"type": "perspective", "perspective": {"yfov": 0.7, "znear": 0.1}},
        {"type": "orthographic", "orthographic": {"xmag": 1, "ymag": 1, "znear": 0.1, "zfar": 1}},
    ]);
    let scene = file.load().unwrap();
    assert_eq!(scene.sky, Vec3::ZERO);
    let [sun, point, spot] = &scene.lights[..] else { panic!() };
    assert_eq!((sun.name.as_str(), sun.intensity), ("sun", Vec3::new(4.0, 2.0, 1.0)));
    let LightKind::Directional { direction, angular_diameter: 0.0 } = sun.kind else { panic!("{sun:?}") };
    assert!(direction.abs_diff_eq(-Vec3::Y, 1e-6), "{direction}");
    assert_eq!((point.name.as_str(), point.intensity), ("light 1", Vec3::splat(7.0)));
    assert_eq!(point.kind, LightKind::Point { position: DVec3::new(1.0, 2.0, 3.0), radius: 0.0 });
    let LightKind::Spot { inner, outer: 0.5, position, .. } = spot.kind else { panic!("{spot:?}") };
    assert!((0.499..0.5).contains(&inner) && position == DVec3::new(1.0, 2.0, 3.0));

    let [camera] = &scene.cameras[..] else { panic!() };
    assert_eq!(
        (camera.name.as_str(), camera.eye, camera.vertical_fov),
        ("eye", DVec3::new(0.0, 0.0, 9.0), 0.7)
    );
    assert!(camera.forward.abs_diff_eq(-Vec3::Y, 1e-6) && camera.up.abs_diff_eq(-Vec3::Z, 1e-6));
}

#[test]
fn files_beside_the_scene() {
    let folder = Folder::new();
    let mut file = textured();
    file.json["images"] = json!([{"uri": "images/my%20picture.png"}]);
    folder.write("images/my picture.png", png(&[[1, 2, 3, 4]]));
    let scene = file.load_gltf(&folder, "a.gltf").unwrap();
    assert_eq!(scene.textures[0].rgba, [1, 2, 3, 4]);

    let mut file = Builder::triangle();
    let data = "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA";
    file.json["buffers"] = json!([{"byteLength": 36, "uri": data}]);
    folder.write("b.gltf", file.json.to_string());
    assert_eq!(folder.load("b.gltf").unwrap().meshes[0].positions[1], Vec3::X);
}

#[test]
fn without_scenes_every_root_is_shown() {
    let mut file = Builder::triangle();
    file.json.as_object_mut().unwrap().remove("scene");
    file.json["scenes"] = json!([]);
    file.json["nodes"] = json!([{"mesh": 0}, {"children": [0]}, {"mesh": 0}]);
    assert_eq!(file.load().unwrap().instances.len(), 2);
}

/// Two triangles that make a square, one alone, and one without area.
#[test]
fn emissive_polygons() {
    let mut file = Builder::new();
    let positions = file.floats(
        "VEC3",
        &[0., 0., 0., 1., 0., 0., 1., 1., 0., 0., 1., 0., 5., 0., 0., 6., 0., 0., 5., 1., 0., 7., 7., 7.],
    );
    let indices = file.indices(&[0, 1, 2, 4, 5, 6, 7, 7, 7, 0, 2, 3]);
    file.json["meshes"] =
        json!([{"primitives": [{"attributes": {"POSITION": positions}, "indices": indices, "material": 0}]}]);
    file.json["materials"] = json!([{"emissiveFactor": [1, 1, 0.5], "doubleSided": true}]);
    file.json["nodes"][0]["scale"] = json!([-1, 1, 1]);
    let scene = file.load().unwrap();
    let polygons = scene.emissive_polygons(DVec3::new(0.0, 0.0, 1.0), 2).unwrap();
    let corners: Vec<_> = polygons.iter().map(|p| p.corners.len()).collect();
    assert_eq!((corners, polygons[0].double_sided), (vec![4, 3], true));
    assert_eq!(polygons[0].radiance, Vec3::new(1.0, 1.0, 0.5));
    // Mirrored in x, it still faces +z, counter-clockwise.
    for polygon in &polygons {
        let c = &polygon.corners;
        assert!(
            (c[1] - c[0]).cross(c[2] - c[1]).z > 0.0 && c.iter().all(|c| c.z == -1.0 && c.x <= 0.0),
            "{c:?}"
        );
    }
    assert_eq!(scene.emissive_polygons(DVec3::ZERO, 1), None);
    let mut file = Builder::triangle();
    file.json["materials"] = json!([{"emissiveFactor": [0, 0, 0]}]);
    assert_eq!(file.load().unwrap().emissive_polygons(DVec3::ZERO, 0), Some(vec![]));
}
