//! What glTF 2.0 allows and the parser refuses, taken out of the JSON before it is parsed.

use serde_json::{Map, Value};

/// Leaves out channels that animate no node and references to textures without an image, and gives scenes without nodes none. What is
/// not as it should be is left for the parser to tell.
pub(super) fn accept(json: &mut Value) {
    let Some(root) = json.as_object_mut() else { return };
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
    // An extension may hold the image instead.
    let is_empty = |texture: &Value| texture.get("source").is_none() && texture.get("extensions").is_none();
    let empty: Vec<bool> =
        list(root, "textures").into_iter().flatten().map(|texture| is_empty(texture)).collect();
    if empty.contains(&true) {
        for material in list(root, "materials").into_iter().flatten().filter_map(Value::as_object_mut) {
            remove(material, &empty);
        }
    }
}

/// Textures whose image is only in an extension, by number, with the extension's name.
pub(super) fn elsewhere<'a>(json: &'a Value) -> Vec<(usize, &'a str)> {
    let textures = json.get("textures").and_then(Value::as_array).into_iter().flatten().enumerate();
    let of = |(index, texture): (usize, &'a Value)| match texture.get("source") {
        Some(_) => None,
        None => Some((index, texture.get("extensions")?.as_object()?.keys().next()?.as_str())),
    };
    textures.filter_map(of).collect()
}

fn list<'a>(object: &'a mut Map<String, Value>, name: &str) -> Option<&'a mut Vec<Value>> {
    object.get_mut(name).and_then(Value::as_array_mut)
}

/// Removes what refers to a texture that is marked, however deep.
fn remove(object: &mut Map<String, Value>, marked: &[bool]) {
    let index = |value: &Value| value.get("index").and_then(Value::as_u64).map(|index| index as usize);
    object.retain(|name, value| {
        !(name.ends_with("Texture") && index(value).is_some_and(|index| marked.get(index) == Some(&true)))
    });
    for inner in object.values_mut().filter_map(Value::as_object_mut) {
        remove(inner, marked);
    }
}
