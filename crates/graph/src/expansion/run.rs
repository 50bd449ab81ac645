//! A step as a sentence: what it runs, reads and writes, and over what.

use crate::bundle::Bundle;
use crate::expansion::{Expansion, LEVEL_RUN_BYTES, Mounts};
use crate::plan::{Groups, Step, Target, Vertices};

/// What a compute step runs over.
#[derive(Clone, Copy, Debug)]
pub enum Over {
    /// The occupied cells of a level of the pass's voxels, a thread each.
    Cells(u32),
    /// The texels of an image and its layers, a thread each.
    Texels(usize),
    /// The texels of the first so many layers of an image, a thread each.
    Layers(usize, u32),
    /// The quads of an image's texels that lie between the same four texels of one of half the size, and its layers, a thread each.
    Quads(usize),
    /// So many workgroups.
    Groups([u32; 3]),
    /// As many workgroups as a buffer says at an offset in bytes.
    Indirect {
        /// The buffer.
        resource: usize,
        /// Where its three words are.
        offset: u64,
    },
}

/// A value of an `override`.
pub trait Constant {
    /// As pipelines are given it.
    fn value(self) -> f64;
}

impl Constant for bool {
    fn value(self) -> f64 {
        f64::from(u8::from(self))
    }
}

impl Constant for u32 {
    fn value(self) -> f64 {
        f64::from(self)
    }
}

impl Constant for f64 {
    fn value(self) -> f64 {
        self
    }
}

/// What a step is given beside what its pass has.
#[derive(Debug, Default)]
pub(crate) struct Given {
    pub targets: Vec<(String, Target)>,
    pub constants: Vec<(String, f64)>,
    pub mounts: Mounts,
    pub bundle: Option<Bundle>,
}

/// A step on its way. It is added to the pass by [`Run::over`], [`Run::draws`] or [`Run::rasters`].
#[derive(Debug)]
#[must_use]
pub struct Run<'e, 'c, 'a> {
    pass: &'e mut Expansion<'c, 'a>,
    module: String,
    entry: &'static str,
    given: Given,
}

impl<'e, 'c, 'a> Run<'e, 'c, 'a> {
    pub(crate) fn new(pass: &'e mut Expansion<'c, 'a>, module: &str) -> Run<'e, 'c, 'a> {
        Run { pass, module: module.to_owned(), entry: "main", given: Given::default() }
    }

    /// Another entry point than `main`.
    pub fn entry(mut self, entry: &'static str) -> Self {
        self.entry = entry;
        self
    }

    /// Binds a variable that it reads. What the entry's own names bring along needs no mention.
    pub fn reads(mut self, variable: &str, target: Target) -> Self {
        self.given.targets.push((variable.to_owned(), target));
        self
    }

    /// Binds a variable that it writes.
    pub fn writes(self, variable: &str, target: Target) -> Self {
        self.reads(variable, target)
    }

    /// Binds several variables.
    pub fn writes_all(mut self, targets: &[(String, Target)]) -> Self {
        self.given.targets.extend(targets.iter().cloned());
        self
    }

    /// Gives an `override` a value.
    pub fn with(mut self, constant: &str, value: impl Constant) -> Self {
        self.given.constants.push((constant.to_owned(), value.value()));
        self
    }

    /// Has imports below `package::<name>` mean a module or the modules of a folder.
    pub fn mount(mut self, name: &'static str, target: &str) -> Self {
        self.given.mounts.push((name, target.to_owned()));
        self
    }

    /// Has all that a bundle brings along, though the entry doesn't name it.
    pub fn using(mut self, bundle: &Bundle) -> Self {
        self.given.bundle = Some(bundle.clone());
        self
    }

    /// Adds a compute step.
    pub fn over(self, over: Over) {
        let groups = match over {
            Over::Cells(level) => {
                // Missing only where nothing voxelizes, which is a fault of its own.
                let Some(Target::Resource(levels)) = self.pass.variable("levels") else { return };
                Groups::Indirect { resource: levels, offset: u64::from(level) * LEVEL_RUN_BYTES }
            }
            Over::Texels(image) => Groups::Tiles { image, quads: false, layers: None },
            Over::Layers(image, count) => Groups::Tiles { image, quads: false, layers: Some(count) },
            Over::Quads(image) => Groups::Tiles { image, quads: true, layers: None },
            Over::Groups(groups) => Groups::Fixed(groups),
            Over::Indirect { resource, offset } => Groups::Indirect { resource, offset },
        };
        if let Some(program) = self.pass.program(&self.module, &[self.entry], &self.given) {
            self.pass.steps.push(Step::Compute { program, groups });
        }
    }

    /// Adds a draw of all the scene's triangles into colour targets by location and a layer of a depth target; `reversed`
    /// depth is 1 near and 0 infinitely far.
    pub fn draws(self, colors: &[Option<usize>], depth: (usize, u32), reversed: bool) {
        if let Some(program) = self.pass.program(&self.module, &DRAWN, &self.given) {
            self.pass.steps.push(Step::Draw { program, colors: colors.to_vec(), depth, reversed });
        }
    }

    /// Adds a draw of triangles that the program makes itself, onto a target that nothing is drawn on.
    pub fn rasters(self, target: usize, vertices: Vertices) {
        if let Some(program) = self.pass.program(&self.module, &DRAWN, &self.given) {
            self.pass.steps.push(Step::Raster { program, target, vertices });
        }
    }
}

/// The entry points of a program that draws.
const DRAWN: [&str; 2] = ["vertex_main", "fragment_main"];
