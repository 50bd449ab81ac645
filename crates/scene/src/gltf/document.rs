//! The JSON of a glTF file, checked before anything is read by index.

use gltf::json::validation::{Checked, Error, Validate};
use gltf::json::{Index, Path, Root, mesh::Semantic};
use serde_json::Value;
use voxlume_fault::{Fault, Faults, one_of};

use super::{at, lenient};

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
    let not_gltf =
        |error: serde_json::Error| Fault::new(format!("not a glTF file: {}", kind_of(json, &error)));
    let mut value: Value = serde_json::from_slice(json).map_err(not_gltf)?;
    if let Some(version) = value.pointer("/asset/version").and_then(Value::as_str)
        && version.split('.').next() != Some("2")
    {
        return Err(Fault::new(format!("glTF version {version}; only 2 is supported")).into());
    }
    lenient::accept(&mut value);
    let mut faults = Faults::default();
    for (texture, extension) in lenient::elsewhere(&value) {
        let what = format!("its image is in `{extension}`, which is not read: only PNG and JPEG are");
        faults.push(at(format!("textures[{texture}]"), what));
    }
    // The text itself knows the line of what is wrong.
    let parsed = serde_json::from_value(value);
    let mut root: Root =
        parsed.map_err(|error| not_gltf(serde_json::from_slice::<Root>(json).err().unwrap_or(error)))?;
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

/// What the parser misses and nobody needs: bounds of positions, which are taken from the positions; the view of an accessor that is
/// all zeros (glTF 2.0 §3.6.2.1); the image of a texture that nothing refers to.
fn is_optional(path: &str) -> bool {
    let is_of = |list: &str, field: &str| path.starts_with(list) && path.ends_with(field);
    is_of("meshes[", ".min")
        || is_of("meshes[", ".max")
        || is_of("accessors[", ".bufferView")
        || is_of("textures[", ".source")
}

/// What a file is that has been taken for glTF.
fn kind_of(bytes: &[u8], error: &serde_json::Error) -> String {
    let text = bytes.trim_ascii_start();
    if text.starts_with(b"version https://git-lfs") {
        "a pointer of Git LFS; `git lfs pull` gets the file itself".to_owned()
    } else if text.starts_with(b"<") {
        "HTML or XML".to_owned()
    } else {
        error.to_string()
    }
}

fn out_of_range<T>(index: Option<&Index<T>>, count: usize) -> String {
    let index = index.map_or(0, Index::value);
    format!("index {index} is out of range: there are {count}")
}
