//! The kinds of passes: a file each, one table, and room for kinds from other crates.

mod bounce;
mod composite;
mod effect;
mod emission;
mod filter;
mod gbuffer;
mod light;
mod shadow_maps;
mod volume;
mod voxel_view;
mod voxelize;

use std::fmt::Debug;
use std::sync::Arc;

pub(crate) use volume::store_and_mipmap;
pub use voxelize::DEFAULT_METHOD;
pub(crate) use voxelize::attribute_stride;

use crate::entries::images;
use crate::expansion::Expansion;
use crate::pipeline::{PassEntry, Pipeline};
use crate::tracer::Tracer;

/// A kind of pass: what it takes, what it makes, when it is left out, and how it becomes steps.
///
/// Two kinds know nothing of each other but the resources that one makes and the other reads.
pub trait PassKind: Debug + Send + Sync {
    /// The word after `run:`.
    fn name(&self) -> &str;

    /// What it does, in a sentence that begins with a verb.
    fn sentence(&self) -> &str;

    /// What it reads.
    fn reads(&self) -> &[Port] {
        &[]
    }

    /// What it makes. The entry names each in this order, as it likes.
    fn writes(&self) -> &[Port];

    /// What it reads and changes.
    fn updates(&self) -> &[Port] {
        &[]
    }

    /// Its parameters beside those in its shader's `Params`.
    fn words(&self) -> &[ParamWords] {
        &[]
    }

    /// Why an entry has nothing to do, whatever the scene.
    fn idle(&self, _entry: &PassEntry) -> Option<Idle> {
        None
    }

    /// Read ports that an entry names and, by its parameters or its tracer, never looks at.
    fn unread(&self, _entry: &PassEntry, _tracer: &Tracer) -> &'static [Unread] {
        &[]
    }

    /// Whether it asks its tracer what lies in a direction, and looks at a volume in no other way.
    fn traces(&self) -> bool {
        false
    }

    /// Whether an entry asks that no emissive polygon is a light of its own.
    fn gathers_all_emission(&self, _entry: &PassEntry) -> bool {
        false
    }

    /// How many bounces of indirect light an entry adds to what voxels show.
    fn bounces(&self, _entry: &PassEntry) -> u32 {
        0
    }

    /// Adds an entry's steps, and says what its written names stand for.
    fn expand(&self, pass: &mut Expansion<'_, '_>);
}

/// Something that a kind of pass reads, makes or changes.
#[derive(Clone, Debug)]
pub struct Port {
    /// Its name in the kind's shaders, and the one that an entry gives it as a rule.
    pub name: &'static str,
    /// What sort of thing it is: what one pass makes, another can read as the same sort only.
    pub sort: Sort,
    /// What it is.
    pub sentence: &'static str,
    /// Whether the pass can do without.
    pub optional: bool,
}

/// A sort of thing in the graph.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sort {
    /// The word for it in messages.
    pub name: &'static str,
    /// Images that it stands for, each of which can be the output.
    pub images: &'static [&'static str],
}

impl Sort {
    /// One image, which can be the output.
    pub const IMAGE: Sort = Sort::new("image");
    /// Occupied voxels of a grid, with their attributes.
    pub const VOXELS: Sort = Sort::new("voxels");
    /// A storage format's volumes.
    pub const VOLUME: Sort = Sort::new("volume");
    /// Light of every voxel of a grid.
    pub const RADIANCE: Sort = Sort::new("radiance");
    /// Depth as lights see it.
    pub const SHADOW_MAPS: Sort = Sort::new("shadow maps");
    /// What the camera sees.
    pub const SURFACE: Sort =
        Sort { name: "surface", images: &["albedo", "normal", "geometry", "depth", "emission"] };

    /// A sort that stands for no further images.
    pub const fn new(name: &'static str) -> Sort {
        Sort { name, images: &[] }
    }
}

impl Port {
    /// Something that is always there.
    pub const fn new(name: &'static str, sort: Sort, sentence: &'static str) -> Port {
        Port { name, sort, sentence, optional: false }
    }

    /// Something that may be missing.
    pub const fn optional(name: &'static str, sort: Sort, sentence: &'static str) -> Port {
        Port { name, sort, sentence, optional: true }
    }
}

/// That an entry has nothing to do, by a parameter of its kind.
#[derive(Clone, Copy, Debug)]
pub struct Idle {
    /// Why.
    pub why: &'static str,
    /// The parameter, and a value with which it would have.
    pub unless: (&'static str, f64),
}

/// What most kinds of passes over voxels read.
const VOXELS: Port =
    Port::new("voxels", Sort::VOXELS, "occupied voxels with reflectance, normal and emission");
const RADIANCE: Port = Port::new("radiance", Sort::RADIANCE, "each voxel's outgoing radiance");
const VOLUME: Port =
    Port::new("volume", Sort::VOLUME, "filtered radiance and opacity, in the storage format");

/// A read port that is not looked at.
#[derive(Clone, Copy, Debug)]
pub struct Unread {
    /// The port's name.
    pub port: &'static str,
    /// Why.
    pub why: &'static str,
    /// The parameter of the shader whose value decides it: a new value needs a new plan.
    pub decided_by: Option<&'static str>,
}

/// A parameter that decides what is planned.
#[derive(Debug)]
pub struct ParamWords {
    /// Its name.
    pub name: &'static str,
    /// What it decides.
    pub sentence: &'static str,
    /// Its values: words, or a range of numbers.
    pub values: Values,
}

/// Values of a [`ParamWords`].
#[derive(Debug)]
pub enum Values {
    /// One of these words.
    Words(&'static [&'static str]),
    /// A whole number in this range, ends included.
    Whole(u32, u32),
    /// A number in this range, ends included.
    Number(f64, f64),
    /// Three numbers, world units.
    Point,
    /// The word of a storage format or an encoding, with its options.
    Variant,
}

/// The kinds of passes that a pipeline can name.
#[derive(Clone, Debug)]
pub struct Kinds(Vec<Arc<dyn PassKind>>);

impl Kinds {
    /// What Voxlume brings along. Effects are WGSL files and no kinds of their own.
    pub fn builtin() -> Kinds {
        Kinds(vec![
            Arc::new(voxelize::Voxelize),
            Arc::new(shadow_maps::ShadowMaps),
            Arc::new(emission::Emission),
            Arc::new(light::Light),
            Arc::new(filter::Filter),
            Arc::new(bounce::Bounce),
            Arc::new(gbuffer::Gbuffer),
            Arc::new(composite::Composite),
            Arc::new(voxel_view::VoxelView),
        ])
    }

    /// Adds a kind, in the place of the one that has its name already.
    pub fn add(&mut self, kind: impl PassKind + 'static) {
        self.0.retain(|known| known.name() != kind.name());
        self.0.push(Arc::new(kind));
    }

    /// The kind called `name`.
    pub fn get(&self, name: &str) -> Option<&dyn PassKind> {
        self.iter().find(|kind| kind.name() == name)
    }

    /// All of them.
    pub fn iter(&self) -> impl Iterator<Item = &dyn PassKind> {
        self.0.iter().map(Arc::as_ref)
    }

    /// Every image of a pipeline that can be its output: first those that have a name of their own.
    pub fn images<'p>(&'p self, pipeline: &'p Pipeline) -> Vec<&'p str> {
        images(pipeline, self)
    }

    /// How many bounces of indirect light a pipeline shows: one by gathering, and those that its passes add.
    pub fn bounces(&self, pipeline: &Pipeline) -> u32 {
        1 + pipeline.passes.iter().map(|entry| self.of(entry).bounces(entry)).sum::<u32>()
    }

    /// Why an entry has nothing to do, whatever the scene.
    pub fn idle(&self, entry: &PassEntry) -> Option<Idle> {
        self.of(entry).idle(entry)
    }

    /// The kind of an entry: what names no kind runs an effect.
    pub(crate) fn of(&self, entry: &PassEntry) -> &dyn PassKind {
        self.get(&entry.run.value).unwrap_or(&effect::Effect)
    }
}

impl Default for Kinds {
    fn default() -> Kinds {
        Kinds::builtin()
    }
}
