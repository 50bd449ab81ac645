//! Reflection over a module of everything.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use voxlume_fault::Source;
use voxlume_shader::{
    Access, Binding, BindingKind, EntryPoint, Field, Library, Override, SampleKind, Shader, Stage,
    StructLayout, TextureDim, link,
};

const TEXT: &str = "
override LEVELS: u32;
override GAIN: f32 = 1.5;
override ON = true;

struct Params {
    /// Direction of travel.
    /// Unit length.
    direction: vec3f,
    /// Metres.
    @align(4) range: f32,
    // no doc
    to_world: mat4x4<f32>, /// In voxels.
    origin: vec3<i32>,
    table: array<vec4f, 2>,
    last: f32,
}

var<uniform> params: Params;
var volume: texture_3d<f32>;
var linear: sampler;
var compare: sampler_comparison;
var shadow: texture_depth_2d;
var colors: texture_2d_array<f32>;
var ids: texture_2d<u32>;
var image: texture_storage_3d<rgba16float, write>;
var counts: texture_storage_2d<r32uint, read_write>;
var<storage> runs: array<vec2u>;
var<storage, read_write> total: atomic<u32>;
var<uniform> unused: vec3f;
var samples: texture_multisampled_2d<f32>;
var sky: texture_cube<f32>;
var source: texture_storage_2d<rgba8unorm, read>;
var<workgroup> shared_sum: u32;

fn through(t: texture_3d<f32>, s: sampler, at: vec3f) -> vec4f { return textureSampleLevel(t, s, at, 0.0); }

@compute @workgroup_size(8, 4)
fn main() {
    var sum = through(volume, linear, params.direction) + textureSampleCompareLevel(shadow, compare, vec2f(), 0.5);
    sum += textureLoad(colors, vec2u(), 0, 0) + vec4f(textureLoad(ids, vec2u(), 0)) * GAIN;
    textureStore(image, vec3u(), sum);
    textureStore(counts, vec2u(), textureLoad(counts, vec2u()));
    atomicAdd(&total, runs[LEVELS].x);
}

@vertex
fn corner() -> @builtin(position) vec4f { return vec4f(unused, 1.0); }

@fragment
fn shade() -> @location(0) vec4f {
    return textureLoad(samples, vec2u(), 0) + textureSampleLevel(sky, linear, vec3f(), 0.0) + textureLoad(source, vec2u());
}
";

fn shader() -> Shader {
    let mut library = Library::empty();
    library.insert("all", Source::new("all.wgsl", TEXT));
    link(&library, "all", &[]).unwrap().check().unwrap()
}

fn binding(binding: u32, name: &str, kind: BindingKind) -> Binding {
    Binding { group: 0, binding, name: name.into(), module: "all".into(), kind }
}

fn texture(dim: TextureDim, sample: SampleKind, filterable: bool) -> BindingKind {
    BindingKind::Texture { dim, sample, multisampled: false, filterable }
}

fn storage_texture(dim: TextureDim, format: &str, access: Access) -> BindingKind {
    BindingKind::StorageTexture { dim, format: format.into(), access }
}

#[test]
fn bindings_that_an_entry_point_uses() {
    assert_eq!(
        shader().bindings("main"),
        [
            binding(0, "params", BindingKind::Uniform { size: 144 }),
            binding(1, "volume", texture(TextureDim::D3, SampleKind::Float, true)),
            binding(2, "linear", BindingKind::Sampler { comparison: false }),
            binding(3, "compare", BindingKind::Sampler { comparison: true }),
            binding(4, "shadow", texture(TextureDim::D2, SampleKind::Depth, false)),
            binding(5, "colors", texture(TextureDim::D2Array, SampleKind::Float, false)),
            binding(6, "ids", texture(TextureDim::D2, SampleKind::Uint, false)),
            binding(7, "image", storage_texture(TextureDim::D3, "rgba16float", Access::WriteOnly)),
            binding(8, "counts", storage_texture(TextureDim::D2, "r32uint", Access::ReadWrite)),
            binding(9, "runs", BindingKind::Storage { read_only: true, min_size: 8 }),
            binding(10, "total", BindingKind::Storage { read_only: false, min_size: 4 }),
        ]
    );
    assert_eq!(shader().bindings("corner"), [binding(11, "unused", BindingKind::Uniform { size: 16 })]);
    let many = BindingKind::Texture {
        dim: TextureDim::D2,
        sample: SampleKind::Float,
        multisampled: true,
        filterable: false,
    };
    assert_eq!(
        shader().bindings("shade"),
        [
            binding(2, "linear", BindingKind::Sampler { comparison: false }),
            binding(12, "samples", many),
            binding(13, "sky", texture(TextureDim::Cube, SampleKind::Float, true)),
            binding(14, "source", storage_texture(TextureDim::D2, "rgba8unorm", Access::ReadOnly)),
        ]
    );
    assert_eq!(shader().bindings("nowhere"), []);
}

#[test]
fn entry_points() {
    let entry = |name: &str, stage, workgroup_size| EntryPoint { name: name.into(), stage, workgroup_size };
    assert_eq!(
        shader().entry_points(),
        [
            entry("main", Stage::Compute, [8, 4, 1]),
            entry("corner", Stage::Vertex, [0; 3]),
            entry("shade", Stage::Fragment, [0; 3]),
        ]
    );
}

#[test]
fn overrides() {
    let value =
        |name: &str, ty: &str, has_default| Override { name: name.into(), ty: ty.into(), has_default };
    assert_eq!(
        shader().overrides(),
        [value("LEVELS", "u32", false), value("GAIN", "f32", true), value("ON", "bool", true),]
    );
}

/// A `vec3f` starts at a multiple of 16 but takes 12, so that a scalar fits behind it.
#[test]
fn struct_layout() {
    let field = |name: &str, ty: &str, offset, size, docs: &str| Field {
        name: name.into(),
        ty: ty.into(),
        offset,
        size,
        docs: docs.into(),
    };
    let fields = vec![
        field("direction", "vec3f", 0, 12, "Direction of travel.\nUnit length."),
        field("range", "f32", 12, 4, "Metres."),
        field("to_world", "mat4x4f", 16, 64, ""),
        field("origin", "vec3i", 80, 12, "In voxels."),
        field("table", "array<vec4f, 2>", 96, 32, ""),
        field("last", "f32", 128, 4, ""),
    ];
    assert_eq!(shader().struct_layout("Params"), Some(StructLayout { size: 144, fields }));
    assert_eq!(shader().struct_layout("Nowhere"), None);
}

#[test]
fn functions() {
    let through = shader().function("through").unwrap();
    let argument = |name: &str, ty: &str| (name.to_owned(), ty.to_owned());
    let expected = [argument("t", "texture_3d<f32>"), argument("s", "sampler"), argument("at", "vec3f")];
    assert_eq!(through.arguments, expected);
    assert_eq!(through.result.as_deref(), Some("vec4f"));
    assert_eq!(shader().function("nowhere"), None);
}
