//! Small glTF files made by hand.
#![allow(dead_code, clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use std::path::{Path, PathBuf};

use serde_json::{Value, json};
use tempfile::TempDir;
use voxlume_scene::Scene;

/// The repository's root.
pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// A folder whose path messages show as `DIR`.
pub struct Folder(TempDir);

impl Folder {
    pub fn new() -> Folder {
        Folder(tempfile::tempdir().unwrap())
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    pub fn write(&self, name: &str, bytes: impl AsRef<[u8]>) -> PathBuf {
        std::fs::create_dir_all(self.path(name).parent().unwrap()).unwrap();
        std::fs::write(self.path(name), bytes).unwrap();
        self.path(name)
    }

    pub fn load(&self, name: &str) -> Result<Scene, String> {
        let shown = self.0.path().display().to_string();
        Scene::load(&self.path(name)).map_err(|faults| faults.to_string().replace(&shown, "DIR"))
    }

    pub fn fault(&self, name: &str) -> String {
        self.load(name).expect_err("it should be refused")
    }
}

/// JSON and binary of a glTF file that grows by accessors.
pub struct Builder {
    pub json: Value,
    pub bin: Vec<u8>,
}

impl Builder {
    pub fn new() -> Builder {
        let json = json!({
            "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
            "meshes": [], "accessors": [], "bufferViews": [],
        });
        Builder { json, bin: Vec::new() }
    }

    /// A triangle in the xy plane that faces +z.
    pub fn triangle() -> Builder {
        let mut file = Builder::new();
        let positions = file.floats("VEC3", &[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0]);
        file.json["meshes"] = json!([{"primitives": [{"attributes": {"POSITION": positions}}]}]);
        file
    }

    fn push(&mut self, list: &str, item: Value) -> usize {
        if self.json[list].is_null() {
            self.json[list] = json!([]);
        }
        let list = self.json[list].as_array_mut().unwrap();
        list.push(item);
        list.len() - 1
    }

    pub fn view(&mut self, bytes: &[u8]) -> usize {
        let view = json!({"buffer": 0, "byteOffset": self.bin.len(), "byteLength": bytes.len()});
        self.bin.extend(bytes);
        self.bin.resize(self.bin.len().next_multiple_of(4), 0);
        self.push("bufferViews", view)
    }

    pub fn accessor(&mut self, kind: &str, component: u32, count: usize, bytes: &[u8]) -> usize {
        let view = self.view(bytes);
        // Only positions need them, and nobody looks at their values.
        let (min, max) = ([0.0; 3], [1.0; 3]);
        self.push(
            "accessors",
            json!({"bufferView": view, "type": kind, "componentType": component, "count": count, "min": min, "max": max}),
        )
    }

    pub fn floats(&mut self, kind: &str, values: &[f32]) -> usize {
        let parts = match kind {
            "VEC2" => 2,
            "VEC3" => 3,
            _ => 4,
        };
        let bytes: Vec<u8> = values.iter().flat_map(|v| v.to_le_bytes()).collect();
        self.accessor(kind, 5126, values.len() / parts, &bytes)
    }

    pub fn indices(&mut self, indices: &[u16]) -> usize {
        let bytes: Vec<u8> = indices.iter().flat_map(|v| v.to_le_bytes()).collect();
        self.accessor("SCALAR", 5123, indices.len(), &bytes)
    }

    /// A binary file.
    pub fn glb(mut self) -> Vec<u8> {
        self.json["buffers"] = json!([{"byteLength": self.bin.len()}]);
        let mut text = self.json.to_string().into_bytes();
        text.resize(text.len().next_multiple_of(4), b' ');
        let total = 12 + 8 + text.len() + 8 + self.bin.len();
        let mut file = b"glTF".to_vec();
        for word in [2, total as u32, text.len() as u32] {
            file.extend(word.to_le_bytes());
        }
        file.extend(b"JSON");
        file.extend(text);
        file.extend((self.bin.len() as u32).to_le_bytes());
        file.extend(b"BIN\0");
        file.extend(self.bin);
        file
    }

    /// Writes `name`, a JSON file, and its buffer beside it, and loads it.
    pub fn load_gltf(mut self, folder: &Folder, name: &str) -> Result<Scene, String> {
        self.json["buffers"] = json!([{"byteLength": self.bin.len(), "uri": "buffer.bin"}]);
        folder.write("buffer.bin", &self.bin);
        folder.write(name, self.json.to_string());
        folder.load(name)
    }

    pub fn load(self) -> Result<Scene, String> {
        let folder = Folder::new();
        folder.write("a.glb", self.glb());
        folder.load("a.glb")
    }

    pub fn fault(self) -> String {
        self.load().expect_err("it should be refused")
    }
}

/// A PNG of one row.
pub fn png(texels: &[[u8; 4]]) -> Vec<u8> {
    let image = image::RgbaImage::from_raw(texels.len() as u32, 1, texels.concat()).unwrap();
    let mut file = std::io::Cursor::new(Vec::new());
    image.write_to(&mut file, image::ImageFormat::Png).unwrap();
    file.into_inner()
}
