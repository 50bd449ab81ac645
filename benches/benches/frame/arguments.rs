//! What is measured.

use std::path::{Path, PathBuf};

use clap::ValueEnum;
use voxlume::{Grid, Registry, one_of};
use voxlume_benches::shared_scene;

/// What a frame costs, by scene, format, tracer, grid, pixels and what has changed since the frame before
///
/// Lists are separated by commas. Tables are Markdown on stdout; what is being done is told on stderr. Paths start from the repository.
#[derive(Debug, clap::Parser)]
#[command(bin_name = "cargo bench -p voxlume-benches --bench frame --", after_help = EXAMPLES)]
pub struct Arguments {
    /// Tables to print; all, or with --against none of these
    #[arg(long, value_name = "TABLES", value_delimiter = ',')]
    tables: Vec<Table>,

    /// Files, or names: cornell, lights, moving, cornell_blender, cornell_double_sided, sibenik, sponza, sponza_lite; cornell
    /// and sponza_lite unless given. Growth is that of the first
    #[arg(long, value_name = "SCENES", value_delimiter = ',', value_parser = scene)]
    pub scenes: Vec<PathBuf>,

    /// Storage formats; all unless given. Growth is in the first
    #[arg(long, value_name = "FORMATS", value_delimiter = ',', value_parser = format)]
    pub formats: Vec<String>,

    /// Tracers; all unless given, with --against the pipeline's
    #[arg(long, value_name = "TRACERS", value_delimiter = ',', value_parser = tracer)]
    pub tracers: Vec<String>,

    /// Voxels along the grid's longest side; 128 unless given
    #[arg(long, value_name = "NUMBERS", value_delimiter = ',', value_parser = resolution())]
    pub resolutions: Vec<u32>,

    /// Width and height of the image in pixels; 320x180 unless given, with --against 640x360
    #[arg(long, value_name = "SIZES", value_delimiter = ',', value_parser = size)]
    pub sizes: Vec<[u32; 2]>,

    /// What has changed since the frame before; all, for growth everything and the camera, unless given
    #[arg(long, value_name = "CHANGES", value_delimiter = ',')]
    pub changes: Vec<Change>,

    /// Frames to time, after one of warm-up
    #[arg(long, value_name = "N", default_value_t = 5, value_parser = clap::value_parser!(u32).range(1..=1000))]
    pub repeat: u32,

    /// Also the image's error against the path tracer's, which takes minutes for each scene
    #[arg(long)]
    pub errors: bool,

    /// Another build of the program `voxlume`, to alternate with
    #[arg(long, value_name = "BINARY")]
    pub against: Option<PathBuf>,

    /// This build of it; target/release/voxlume unless given
    #[arg(long, value_name = "PATH", requires = "against")]
    program: Option<PathBuf>,

    /// How often each of the two is run
    #[arg(long, value_name = "N", default_value_t = 3, requires = "against", value_parser = clap::value_parser!(u32).range(1..=1000))]
    pub rounds: u32,

    // Cargo says so to every benchmark.
    #[arg(long, hide = true)]
    bench: bool,
}

const EXAMPLES: &str = "Examples:
  cargo bench -p voxlume-benches --bench frame -- --scenes cornell --formats isotropic --changes camera
  cargo bench -p voxlume-benches --bench frame -- --tables frames --scenes my.glb --sizes 640x360,1280x720
  cargo bench -p voxlume-benches --bench frame -- --tables lights,triangles --tracers rays
  cargo bench -p voxlume-benches --bench frame -- --against ../before/target/release/voxlume --scenes cornell";

/// A table.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Table {
    /// Scenes, formats, tracers, grids and sizes
    Frames,
    /// Growth with the grid: 64³ to 512³
    Resolution,
    /// Growth with the pixels: 1, 2 and 4 times as many
    Pixels,
    /// Growth with the lamps: 1 to 16
    Lights,
    /// Growth with the triangles of an object: 10² to 10⁵
    Triangles,
}

/// What has changed since the frame before.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Change {
    /// All passes run
    Everything,
    /// An object of 1,000 triangles moves
    Object,
    /// A lamp moves
    Lamp,
    /// The camera moves
    Camera,
    /// No pass has anything to do
    Nothing,
}

impl Arguments {
    /// Fills in what isn't given.
    pub fn tables(&self) -> Vec<Table> {
        match self.against {
            None => or(&self.tables, Table::value_variants()),
            Some(_) => self.tables.clone(),
        }
    }

    /// This build's program.
    pub fn program(&self) -> PathBuf {
        self.program.clone().unwrap_or_else(|| {
            let target = std::env::var_os("CARGO_TARGET_DIR").unwrap_or_else(|| "target".into());
            Path::new(&target).join("release/voxlume")
        })
    }
}

/// What is given, or else this.
pub fn or<T: Clone>(given: &[T], otherwise: &[T]) -> Vec<T> {
    if given.is_empty() { otherwise.to_vec() } else { given.to_vec() }
}

/// Names of the storage formats.
pub fn format_names() -> Vec<String> {
    Registry::builtin().formats.iter().map(|format| format.name().to_owned()).collect()
}

/// Names of the tracers.
pub fn tracer_names() -> Vec<String> {
    Registry::builtin().tracers.iter().map(|tracer| tracer.name.to_owned()).collect()
}

/// A format's options follow its name.
fn format(word: &str) -> Result<String, String> {
    known(word, word.split(':').next().unwrap_or_default(), &format_names())
}

fn tracer(word: &str) -> Result<String, String> {
    known(word, word, &tracer_names())
}

fn known(word: &str, name: &str, names: &[String]) -> Result<String, String> {
    match names.iter().any(|known| known == name) {
        true => Ok(word.to_owned()),
        false => Err(one_of(names.iter().map(String::as_str))),
    }
}

fn resolution() -> clap::builder::RangedI64ValueParser<u32> {
    let (least, most) = (*Grid::RESOLUTIONS.start(), *Grid::RESOLUTIONS.end());
    clap::value_parser!(u32).range(i64::from(least)..=i64::from(most))
}

fn size(text: &str) -> Result<[u32; 2], String> {
    let sides =
        text.split_once('x').and_then(|(width, height)| Some([width.parse().ok()?, height.parse().ok()?]));
    sides.ok_or_else(|| "two whole numbers with an `x` between them, such as 640x360".into())
}

/// Scenes of the repository, and of the folder beside it.
const SCENES: [&str; 3] = ["cornell", "lights", "moving"];
const SHARED: [&str; 5] = ["cornell_blender", "cornell_double_sided", "sibenik", "sponza", "sponza_lite"];

/// The file of a scene's name, or a file itself.
pub fn scene(word: &str) -> Result<PathBuf, String> {
    let path = Path::new(word);
    if SCENES.contains(&word) {
        Ok(Path::new("scenes").join(word).with_extension("ron"))
    } else if SHARED.contains(&word) {
        Ok(shared_scene(word))
    } else if path.extension().is_some() && path.is_file() {
        Ok(path.to_owned())
    } else {
        let known = SCENES.into_iter().chain(SHARED);
        Err(format!("{}, or a .ron, .gltf or .glb file that is there", one_of(known)))
    }
}
