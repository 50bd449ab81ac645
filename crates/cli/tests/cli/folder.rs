//! A folder with files of a small scene and a small pipeline, and the program run in it.

use std::collections::BTreeMap;
use std::path::Path;
use std::process::Command;

use tempfile::TempDir;

/// A white square seen from its front.
pub const SCENE: &str = "(
    materials: {\"white\": (base_color: 0.5)},
    objects: [(name: \"square\", material: \"white\", shape: Quad(corners: [(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)]))],
    cameras: [
        (name: \"front\", eye: (0, 0, 3), target: (0, 0, 0), fov_deg: 45),
        (name: \"side\", eye: (2, 0, 3), target: (0, 0, 0), fov_deg: 45),
    ],
)
";

/// An effect of the user's own that needs no volume, and all that it takes to run it.
pub const PIPELINE: &str = "(
    format: \"isotropic\",
    encoding: \"rgba16float\",
    resolution: 32,
    separability: \"conservative\",
    output: \"tint\",
    passes: [
        (run: \"gbuffer\", writes: [\"surface\"]),
        (run: \"tint.wgsl\", reads: [\"surface\"], writes: [\"tint\"], params: (strength: 0.5)),
    ],
)
";

/// The effect.
pub const TINT: &str = "import package::common::surface::Surface;

struct Params {
    /// How much of the colour remains, [0, 1].
    strength: f32,
}

fn effect(surface: Surface, params: Params) -> vec4f {
    return vec4f(surface.base_color * params.strength, 1.0);
}
";

/// The folder; it is gone when this is dropped.
pub struct Folder(TempDir);

/// What a run left.
pub struct Ran {
    pub code: Option<i32>,
    pub stdout: String,
    pub stderr: String,
}

impl Folder {
    /// `box.ron`, `pipe.ron`, `tint.wgsl`.
    pub fn new() -> Folder {
        let folder = Folder(tempfile::tempdir().unwrap());
        folder.file("box.ron", SCENE).file("pipe.ron", PIPELINE).file("tint.wgsl", TINT);
        folder
    }

    pub fn path(&self) -> &Path {
        self.0.path()
    }

    pub fn file(&self, name: &str, content: impl AsRef<[u8]>) -> &Folder {
        std::fs::write(self.path().join(name), content).unwrap();
        self
    }

    /// `text` of the file with `from`, which must be there, replaced.
    pub fn edit(&self, name: &str, text: &str, from: &str, to: &str) -> &Folder {
        assert!(text.contains(from), "{from}");
        self.file(name, text.replacen(from, to, 1))
    }

    /// The program in this folder, to be started.
    pub fn command(&self, words: &str) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_voxlume"));
        command.args(words.split_whitespace()).current_dir(self.path()).env_remove("RUST_LOG");
        command
    }

    pub fn run(&self, words: &str) -> Ran {
        self.run_with(&words.split_whitespace().collect::<Vec<_>>())
    }

    pub fn run_with(&self, arguments: &[&str]) -> Ran {
        let mut command = Command::new(env!("CARGO_BIN_EXE_voxlume"));
        let output =
            command.args(arguments).current_dir(self.path()).env_remove("RUST_LOG").output().unwrap();
        let text = |bytes| String::from_utf8(bytes).unwrap();
        Ran { code: output.status.code(), stdout: text(output.stdout), stderr: text(output.stderr) }
    }

    /// Runs, and holds against the whole of stderr; nothing else may come of it.
    #[track_caller]
    pub fn refuses(&self, words: &str, stderr: &str) {
        let before = self.contents();
        let ran = self.run(words);
        assert_eq!(ran.stderr.trim_end(), stderr.trim_end());
        assert_eq!(ran.code, Some(2));
        assert_eq!(ran.stdout, "");
        assert_eq!(self.contents(), before, "files were touched");
    }

    /// Names and bytes of its files.
    pub fn contents(&self) -> BTreeMap<String, Vec<u8>> {
        let files = std::fs::read_dir(self.path()).unwrap().map(|entry| entry.unwrap().path());
        let name = |path: &Path| path.file_name().unwrap().to_str().unwrap().to_owned();
        files.filter(|path| path.is_file()).map(|path| (name(&path), std::fs::read(&path).unwrap())).collect()
    }
}
