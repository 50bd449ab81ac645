//! The JSON of a glTF file, checked before anything is read by index.

use gltf::json::validation::{Checked, Error, Validate};
use gltf::json::{Index, Path, Root, mesh::Semantic};
use serde_json::{Map, Value};
use voxlume_fault::{Fault, Faults, one_of};

use super::{at, source};

/// Extensions that a file may require.
const SUPPORTED: [&str; 4] = [
    "KHR_lights_punctual",
    "KHR_materials_emissive_strength",
    "KHR_mesh_quantization",
    "KHR_texture_transform",
];

/// The JSON text and the `BIN` chunk of a `.glb`; a `.gltf` is JSON alone.
pub(super) fn split(bytes: &[u8]) -> Result<(&[u8], Option<&[u8]>), Fault> {
    if !bytes.starts_with(b"glTF") {
        return Ok((bytes, None));
    }
    let word = |at: usize| bytes.get(at..at + 4).and_then(|b| b.try_into().ok()).map(u32::from_le_bytes);
    let truncated = |needed: u64| {
        Fault::new(format!("truncated: {needed} bytes are announced, {} are there", bytes.len()))
    };
    match word(4) {
        Some(2) => {}
        Some(version) => return Err(Fault::new(format!("GLB version {version}; only 2 is supported"))),
        None => return Err(truncated(12)),
    }
    let length = word(8).ok_or_else(|| truncated(12))?;
    if length as usize > bytes.len() {
        return Err(truncated(length.into()));
    }
    let chunk = |start: usize, kind: &[u8; 4]| -> Result<Option<(&[u8], usize)>, Fault> {
        let (Some(size), Some(found)) = (word(start), bytes.get(start + 4..start + 8)) else {
            return Ok(None);
        };
        let end = (start + 8).saturating_add(size as usize);
        let body = bytes.get(start + 8..end).ok_or_else(|| truncated(end as u64))?;
        Ok((found == kind).then_some((body, end)))
    };
    let (json, end) = chunk(12, b"JSON")?.ok_or_else(|| Fault::new("the first chunk is not JSON"))?;
    Ok((json, chunk(end, b"BIN\0")?.map(|(body, _)| body)))
}

/// Parses and checks the JSON: afterwards every index in it is in range.
pub(super) fn parse(json: &[u8]) -> Result<Root, Faults> {
    let mut root: Root = serde_json::from_slice(json).or_else(|error| again(json, &error))?;
    if let Some(fault) = unknown_version(&root.asset.version) {
        return Err(fault.into());
    }
    let mut faults = Faults::default();
    for (t, texture) in root.textures.iter().enumerate() {
        let elsewhere = texture.extensions.as_ref().and_then(|extensions| extensions.others.keys().next());
        if let Some(extension) = elsewhere.filter(|_| root.images.get(texture.source.value()).is_none()) {
            let what = format!("its image is in `{extension}`, which is not read: only PNG and JPEG are");
            faults.push(at(format!("textures[{t}]"), what));
        }
    }
    // The list is emptied for the validation below, which knows fewer of them.
    for name in std::mem::take(&mut root.extensions_required) {
        if !SUPPORTED.contains(&name.as_str()) {
            let fault = Fault::new(format!("the extension `{name}` is required and not supported"));
            faults.push(fault.note(one_of(SUPPORTED)));
        }
    }
    // The validation looks up positions' accessors without a check of its own.
    for (m, mesh) in root.meshes.iter().enumerate() {
        for (p, primitive) in mesh.primitives.iter().enumerate() {
            let positions = primitive.attributes.get(&Checked::Valid(Semantic::Positions));
            if positions.is_some_and(|index: &Index<_>| index.value() >= root.accessors.len()) {
                let place = format!("meshes[{m}].primitives[{p}].attributes[\"POSITION\"]");
                faults.push(at(place, out_of_range(positions, root.accessors.len())));
            }
        }
    }
    let root = faults.into_result(root)?;

    let mut faults = Faults::default();
    root.validate(&root, Path::new, &mut |path, error| {
        if error == Error::Missing && is_optional(path().as_str()) {
            return;
        }
        let what = match error {
            Error::IndexOutOfBounds => "the index is out of range",
            Error::Invalid => "not a valid value",
            Error::Missing => "missing",
            Error::Oversize => "too large",
            Error::Unsupported => "not supported",
        };
        faults.push(at(path(), what));
    });
    faults.into_result(root)
}

/// Parses what was refused with `error` once more, without what glTF 2.0 allows and the parser doesn't.
fn again(json: &[u8], error: &serde_json::Error) -> Result<Root, Fault> {
    let refused = |_| {
        let what = source::kind(json).map_or_else(|| error.to_string(), str::to_owned);
        Fault::new(format!("not a glTF file: {what}"))
    };
    let mut value: Value = serde_json::from_slice(json).map_err(refused)?;
    if let Some(fault) = value.pointer("/asset/version").and_then(Value::as_str).and_then(unknown_version) {
        return Err(fault);
    }
    if let Some(root) = value.as_object_mut() {
        complete(root);
    }
    serde_json::from_value(value).map_err(refused)
}

fn unknown_version(version: &str) -> Option<Fault> {
    let known = version.split('.').next() == Some("2");
    (!known).then(|| Fault::new(format!("glTF version {version}; only 2 is supported")))
}

/// Leaves out channels that animate no node, and gives scenes without nodes none.
fn complete(root: &mut Map<String, Value>) {
    if let Some(animations) = list(root, "animations") {
        animations.retain_mut(|animation| {
            let channels = animation.as_object_mut().and_then(|animation| list(animation, "channels"));
            channels.is_none_or(|channels| {
                channels.retain(|channel| channel.pointer("/target/node").is_some());
                !channels.is_empty()
            })
        });
    }
    for scene in list(root, "scenes").into_iter().flatten().filter_map(Value::as_object_mut) {
        scene.entry("nodes").or_insert_with(|| Value::Array(Vec::new()));
    }
}

fn list<'a>(object: &'a mut Map<String, Value>, name: &str) -> Option<&'a mut Vec<Value>> {
    object.get_mut(name).and_then(Value::as_array_mut)
}

/// What the parser misses and nobody needs: bounds of positions, which are taken from the positions, and the view of an accessor that
/// is all zeros (glTF 2.0 §3.6.2.1).
fn is_optional(path: &str) -> bool {
    let is_of = |list: &str, field: &str| path.starts_with(list) && path.ends_with(field);
    is_of("meshes[", ".min") || is_of("meshes[", ".max") || is_of("accessors[", ".bufferView")
}

fn out_of_range<T>(index: Option<&Index<T>>, count: usize) -> String {
    let index = index.map_or(0, Index::value);
    format!("index {index} is out of range: there are {count}")
}
