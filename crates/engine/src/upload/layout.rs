//! Rust's structs lie in memory as WGSL's of the same name do.
#![allow(clippy::unwrap_used, clippy::panic)]

use voxlume_shader::{Library, StructLayout, link};

use super::frame::{Camera, Clock, Environment};
use super::light::Light;
use super::material::Material;
use super::mesh::Vertex;

/// Name, offset and size of each field, and the size of the whole.
struct Layout {
    fields: Vec<(&'static str, usize, usize)>,
    size: usize,
}

macro_rules! layout {
    ($of:ty: $($field:ident),*) => {{
        fn size<T, F>(_: impl Fn(&T) -> &F) -> usize {
            size_of::<F>()
        }
        Layout {
            fields: vec![$((
                stringify!($field),
                std::mem::offset_of!($of, $field),
                size(|value: &$of| &value.$field),
            )),*],
            size: size_of::<$of>(),
        }
    }};
}

fn in_wgsl(module: &str, name: &str) -> StructLayout {
    let mounts = [("walk", "walk/leaps"), ("meet", "meet/sheets"), ("emitters", "emitters/none")];
    let shader = link(&Library::builtin(), module, &mounts);
    let shader = shader.and_then(voxlume_shader::Linked::check).unwrap_or_else(|faults| panic!("{faults}"));
    shader.struct_layout(name).unwrap()
}

/// Where two layouts differ, in words.
fn difference(rust: &Layout, wgsl: &StructLayout) -> Option<String> {
    let of_rust: Vec<String> =
        rust.fields.iter().map(|(name, offset, size)| format!("{name}: {size} bytes at {offset}")).collect();
    let of_wgsl: Vec<String> = wgsl
        .fields
        .iter()
        .map(|field| format!("{}: {} bytes at {}", field.name, field.size, field.offset))
        .collect();
    let whole = rust.size as u64 != wgsl.size;
    (of_rust != of_wgsl || whole)
        .then(|| format!("Rust, {} bytes: {of_rust:#?}\nWGSL, {} bytes: {of_wgsl:#?}", rust.size, wgsl.size))
}

fn vertex() -> Layout {
    layout!(Vertex: position, material, normal, tangent, uv)
}

#[test]
fn rust_and_wgsl_agree() {
    let material = layout!(Material:
        base_color, emission, alpha_cutoff, metallic, roughness, normal_scale, double_sided, base_color_layer,
        metallic_roughness_layer, normal_layer, emission_layer);
    let light = layout!(Light:
        position, kind, intensity, size, direction, shadow_layer, falloff, area, padding, corners);
    let camera = layout!(Camera:
        view_projection, eye, near, forward, voxel_size, right, padding_right, up, padding_up, screen, padding);
    let environment = layout!(Environment: sky, light_count);
    let clock = layout!(Clock: seconds, frame, padding);
    for (module, name, rust) in [
        ("pass/gbuffer", "Camera", camera),
        ("pass/gbuffer", "Vertex", vertex()),
        ("pass/gbuffer", "Material", material),
        ("pass/light", "Light", light),
        ("pass/light", "Environment", environment),
        ("common/clock", "Clock", clock),
    ] {
        if let Some(difference) = difference(&rust, &in_wgsl(module, name)) {
            panic!("`{name}` differs\n{difference}");
        }
    }
}

/// Else the test above would prove nothing.
#[test]
fn a_difference_is_noticed() {
    let mut swapped = vertex();
    swapped.fields.swap(2, 3);
    assert!(difference(&swapped, &in_wgsl("pass/gbuffer", "Vertex")).is_some());
    assert!(difference(&vertex(), &in_wgsl("pass/gbuffer", "Material")).is_some());
}
