//! Damaged files: a clear error or a right result, never a panic, a hang, or memory beyond a budget.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]
// The allocator counts; there is no safe way to have one.
#![allow(unsafe_code)]

use std::alloc::{GlobalAlloc, Layout, System};
use std::path::PathBuf;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

use std::sync::Arc;

use voxlume::{Library, Pipeline, Registry, Request, Scene, SceneFacts, Source, check_all, plan};
use voxlume_tests::{Random, built_in, mutated_bytes, mutated_text, root};

/// Bytes that reading one of these files may take. They are a few kilobytes each; a shape may grow to four million cells
/// of two triangles by a damaged number, which is allowed and takes most of it.
const BUDGET: usize = 2 << 30;

struct Counting;

static NOW: AtomicUsize = AtomicUsize::new(0);
static PEAK: AtomicUsize = AtomicUsize::new(0);

// SAFETY: the system's allocator does all the work.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        let now = NOW.fetch_add(layout.size(), Ordering::Relaxed) + layout.size();
        PEAK.fetch_max(now, Ordering::Relaxed);
        // SAFETY: the caller's promise.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        NOW.fetch_sub(layout.size(), Ordering::Relaxed);
        // SAFETY: the caller's promise.
        unsafe { System.dealloc(pointer, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// Tests that count run one after the other.
static ALONE: Mutex<()> = Mutex::new(());

/// Reads damaged files; tells how many were refused and how many still read.
fn survive<T>(what: &str, count: usize, mut read: impl FnMut(&mut Random) -> Result<T, String>) {
    let _alone = ALONE.lock().unwrap();
    let before = NOW.load(Ordering::Relaxed);
    PEAK.store(before, Ordering::Relaxed);
    let mut random = Random::new(0x5eed);
    let mut refused = 0;
    for _ in 0..count {
        match read(&mut random) {
            Ok(_) => {}
            Err(message) => {
                assert!(!message.trim().is_empty(), "{what}: refused without a word");
                refused += 1;
            }
        }
    }
    let peak = PEAK.load(Ordering::Relaxed).saturating_sub(before);
    println!("{what}: {refused} of {count} refused, at most {} MiB", peak >> 20);
    assert!(peak <= BUDGET, "{what}: {peak} bytes");
    // Damage that is never noticed, or always, would prove nothing.
    assert!(refused > count / 4 && refused < count, "{what}: {refused} of {count} refused");
}

fn texts(folder: &str) -> Vec<(PathBuf, String)> {
    let files = std::fs::read_dir(root().join(folder)).unwrap().map(|entry| entry.unwrap().path());
    let mut files: Vec<_> = files.filter(|path| path.extension().is_some_and(|e| e == "ron")).collect();
    files.sort();
    files.into_iter().map(|path| (path.clone(), std::fs::read_to_string(path).unwrap())).collect()
}

#[test]
fn scenes() {
    let files = [texts("scenes"), texts("scenes/hard")].concat();
    survive("scenes", 1500, |random| {
        let (path, text) = &files[random.below(files.len())];
        let source = Source::new(path.display().to_string(), mutated_text(text, random));
        Scene::parse(&source).map_err(|faults| faults.to_string())
    });
}

#[test]
fn pipelines() {
    let facts = SceneFacts::of(&built_in("cornell.ron")).unwrap();
    let text = std::fs::read_to_string(root().join("pipelines/gi.ron")).unwrap();
    let registry = Registry::builtin();
    survive("pipelines", 400, |random| {
        let source =
            Source::new(root().join("pipelines/gi.ron").display().to_string(), mutated_text(&text, random));
        let pipeline = Pipeline::parse(&source).map_err(|faults| faults.to_string())?;
        plan(&pipeline, &facts, &registry, &Request::image(64, 64)).map_err(|faults| faults.to_string())
    });
}

const ALTERNATIVES: [(&str, &[&str]); 13] = [
    ("filter", &["filter/hardware", "filter/by_hand"]),
    ("tracer", &["tracer/cones", "tracer/rays"]),
    ("walk", &["walk/bricks", "walk/columns"]),
    ("level_walk", &["walk/bricks"]),
    ("seen", &["seen/pixel", "seen/reduced"]),
    ("meet", &["meet/sheets", "meet/cells"]),
    ("lamps", &["lamps/none", "lamps/area", "lamps/voxels"]),
    ("emitters", &["emitters/none", "emitters/sampled"]),
    ("format", &["format/isotropic", "format/six_face", "format/sh2"]),
    (
        "effect",
        &[
            "effect/diffuse",
            "effect/shadow",
            "effect/soft_shadow",
            "effect/ambient_occlusion",
            "effect/specular",
        ],
    ),
    ("encoding", &["encoding/rgba8", "encoding/rgba16float", "encoding/rgba32float"]),
    ("visitor", &["visitor/occupancy", "visitor/attributes"]),
    ("texel", &["texel/rgba16float"]),
];

#[test]
fn shaders() {
    let builtin = Library::builtin();
    let paths: Vec<&str> = builtin.paths().collect();
    survive("shaders", 90, |random| {
        let path = paths[random.below(paths.len())];
        let is_of = |path: &str, of: &str| path == of || path.starts_with(&format!("{of}/"));
        // Of each kind of module the one that is changed, or any; the others are not there.
        let one = ALTERNATIVES.map(|(name, all)| {
            let changed = all.iter().find(|of| is_of(path, of)).copied();
            (name, [changed.unwrap_or_else(|| all[random.below(all.len())])])
        });
        let chosen = |path: &str| one.iter().any(|(_, [of])| is_of(path, of));
        let alternative =
            |path: &str| ALTERNATIVES.iter().any(|(_, all)| all.iter().any(|of| is_of(path, of)));
        let mut library = Library::empty();
        for path in builtin.paths().filter(|path| chosen(path) || !alternative(path)) {
            library.insert(path, Arc::clone(builtin.get(path).unwrap()));
        }
        let one = one.each_ref().map(|(name, of)| (*name, of.as_slice()));
        let faults = check_all(&library, &one);
        assert!(faults.is_empty(), "{faults}");
        let text = std::fs::read_to_string(root().join(format!("wgsl/{path}.wgsl"))).unwrap();
        library.insert(path, Source::new(path, mutated_text(&text, random)));
        let faults = check_all(&library, &one);
        if faults.is_empty() { Ok(()) } else { Err(faults.to_string()) }
    });
}

/// A quad of two triangles with a texture, a light and a camera.
fn gltf() -> (String, Vec<u8>) {
    let mut binary: Vec<u8> = Vec::new();
    let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0f32]];
    binary.extend(corners.iter().flatten().flat_map(|v| v.to_le_bytes()));
    binary.extend(
        [[0.0, 1.0], [1.0, 1.0], [1.0, 0.0], [0.0, 0.0f32]].iter().flatten().flat_map(|v| v.to_le_bytes()),
    );
    binary.extend([0u16, 1, 2, 0, 2, 3].iter().flat_map(|v| v.to_le_bytes()));
    // One grey pixel.
    let png = "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAAAAAA6fptVAAAACklEQVR4nGNoAAAAggCBd81ytgAAAABJRU5ErkJggg==";
    let json = format!(
        r#"{{"asset": {{"version": "2.0"}}, "scene": 0, "scenes": [{{"nodes": [0, 1, 2]}}],
"extensionsUsed": ["KHR_lights_punctual"],
"extensions": {{"KHR_lights_punctual": {{"lights": [{{"type": "spot", "intensity": 5, "spot": {{"outerConeAngle": 0.6}}}}]}}}},
"nodes": [{{"mesh": 0, "scale": [2, 1, -1], "rotation": [0, 0, 0, 1]}},
 {{"translation": [0, 3, 0], "extensions": {{"KHR_lights_punctual": {{"light": 0}}}}}}, {{"camera": 0, "translation": [0, 0, 5]}}],
"cameras": [{{"type": "perspective", "perspective": {{"yfov": 0.8, "znear": 0.1}}}}],
"meshes": [{{"primitives": [{{"attributes": {{"POSITION": 0, "TEXCOORD_0": 1}}, "indices": 2, "material": 0}}]}}],
"materials": [{{"pbrMetallicRoughness": {{"baseColorTexture": {{"index": 0}}, "roughnessFactor": 0.4}}, "alphaMode": "MASK"}}],
"textures": [{{"source": 0}}], "images": [{{"uri": "data:image/png;base64,{png}"}}],
"accessors": [{{"bufferView": 0, "type": "VEC3", "componentType": 5126, "count": 4, "min": [0, 0, 0], "max": [1, 1, 0]}},
 {{"bufferView": 1, "type": "VEC2", "componentType": 5126, "count": 4}},
 {{"bufferView": 2, "type": "SCALAR", "componentType": 5123, "count": 6}}],
"bufferViews": [{{"buffer": 0, "byteLength": 48}}, {{"buffer": 0, "byteOffset": 48, "byteLength": 32}},
 {{"buffer": 0, "byteOffset": 80, "byteLength": 12}}],
"buffers": [{{"byteLength": {}}}]}}"#,
        binary.len()
    );
    (json, binary)
}

fn glb(json: &str, binary: &[u8]) -> Vec<u8> {
    let mut text = json.as_bytes().to_vec();
    text.resize(text.len().next_multiple_of(4), b' ');
    let total = 12 + 8 + text.len() + 8 + binary.len();
    let words = |words: &[u32]| words.iter().flat_map(|word| word.to_le_bytes()).collect::<Vec<_>>();
    [
        b"glTF".to_vec(),
        words(&[2, total as u32, text.len() as u32]),
        b"JSON".to_vec(),
        text,
        words(&[binary.len() as u32]),
        b"BIN\0".to_vec(),
        binary.to_vec(),
    ]
    .concat()
}

#[test]
fn models() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("model.glb");
    let (json, binary) = gltf();
    std::fs::write(&path, glb(&json, &binary)).unwrap();
    let whole = Scene::load(&path).unwrap_or_else(|faults| panic!("{faults}"));
    assert_eq!((whole.meshes.len(), whole.lights.len(), whole.textures.len()), (1, 1, 1));
    survive("models", 1500, |random| {
        let bytes = if random.below(2) == 0 {
            glb(&mutated_text(&json, random), &binary)
        } else {
            mutated_bytes(&glb(&json, &binary), random)
        };
        std::fs::write(&path, bytes).unwrap();
        Scene::load(&path).map_err(|faults| faults.to_string())
    });
}

/// Brackets twenty thousand deep: readers that call themselves would run out of stack.
#[test]
fn nesting() {
    let deep = |open: &str, close: &str| open.repeat(20_000) + &close.repeat(20_000);
    for (open, close) in [("(", ")"), ("[", "]"), ("(a: ", ")"), ("Some(", ")"), ("/*", "*/")] {
        let source = Source::new("deep.ron", deep(open, close));
        assert!(Scene::parse(&source).is_err(), "{open}");
        assert!(Pipeline::parse(&source).is_err(), "{open}");
    }
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("deep.gltf");
    std::fs::write(&path, deep("[", "]")).unwrap();
    assert!(Scene::load(&path).is_err());
    for (open, close) in [("(", ")"), ("{", "}"), ("-", ""), ("!", ""), ("if (true) {", "}")] {
        let mut library = Library::builtin();
        let text =
            format!("fn deep() -> f32 {{ return {}1.0{}; }}", open.repeat(20_000), close.repeat(20_000));
        library.insert("effect/deep", Source::new("deep.wgsl", text));
        assert!(
            !check_all(&library, &[("format", &["format/six_face"]), ("effect", &["effect/deep"])])
                .is_empty()
        );
    }
}
