//! Types as WGSL writes them.

use naga::common::wgsl::TypeContext;
use naga::{Handle, Module, Type, TypeInner};

/// `vec3f`, `array<mat4x4f, 2>`, `Surface`.
pub(crate) fn of_type(module: &Module, ty: Handle<Type>) -> String {
    shortened(module.to_ctx().type_to_string(ty))
}

/// The same for a type that may not be in the module.
pub(crate) fn of_inner(module: &Module, inner: &TypeInner) -> String {
    let mut text = String::new();
    // Writing to a string cannot fail.
    let _ = module.to_ctx().write_type_inner(inner, &mut text);
    shortened(text)
}

/// naga writes `vec3<f32>`; people write `vec3f`.
fn shortened(mut text: String) -> String {
    const SHAPES: [&str; 12] = [
        "vec2", "vec3", "vec4", "mat2x2", "mat2x3", "mat2x4", "mat3x2", "mat3x3", "mat3x4", "mat4x2",
        "mat4x3", "mat4x4",
    ];
    for shape in SHAPES {
        for (scalar, letter) in [("f32", 'f'), ("i32", 'i'), ("u32", 'u')] {
            text = text.replace(&format!("{shape}<{scalar}>"), &format!("{shape}{letter}"));
        }
    }
    text
}
