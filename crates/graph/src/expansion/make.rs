//! What a kind of pass makes: resources, what its written names stand for, steps.

use voxlume_shader::Shader;

use crate::bundle::Bundle;
use crate::expansion::{Expansion, Run};
use crate::plan::{LeftOut, Life, ResourceKind, Step};

impl<'c, 'a> Expansion<'c, 'a> {
    /// A buffer or texture, made as `kind` at its first use.
    pub fn resource(&mut self, name: &str, kind: ResourceKind) -> usize {
        self.context.resource(name, kind)
    }

    /// A buffer that passes which share it leave right for each other: see [`Life::Kept`].
    pub fn kept(&mut self, name: &str, kind: ResourceKind) -> usize {
        let resource = self.resource(name, kind);
        self.context.resources[resource].life = Life::Kept;
        resource
    }

    /// The resource called `name`, if there is one.
    pub fn known(&self, name: &str) -> Option<usize> {
        self.context.known(name)
    }

    /// A part of what the entry writes: called as the part alone where the entry writes it under `usual`, the port's own
    /// name, else with the entry's name before it.
    pub fn part(&mut self, usual: &str, part: &str, kind: ResourceKind) -> usize {
        self.part_of(&self.written(), usual, part, kind)
    }

    /// A part of what the graph calls `name`; see [`Expansion::part`].
    pub fn part_of(&mut self, name: &str, usual: &str, part: &str, kind: ResourceKind) -> usize {
        match name == usual {
            true => self.resource(part, kind),
            false => self.resource(&format!("{name}.{part}"), kind),
        }
    }

    /// Says what the name that the entry writes stands for.
    pub fn makes(&mut self, bundle: Bundle) {
        let name = self.written();
        self.context.bundles.insert(name, bundle);
    }

    /// Notes something that is left out for this scene.
    pub fn leaves_out(&mut self, what: &str, why: &str, bytes: u64) {
        self.context.left_out.push(LeftOut { what: what.to_owned(), why: why.to_owned(), bytes });
    }

    /// Notes a buffer with the runs of a grid's levels.
    pub(crate) fn counts_cells(&mut self, levels: usize) {
        self.context.levels.push(levels);
    }

    /// Notes a buffer that counts values which an encoding can't hold.
    pub(crate) fn counts_out_of_range(&mut self, resource: usize) {
        self.context.out_of_range.push(resource);
    }

    /// Fills a buffer with zeroes.
    pub fn clear(&mut self, resource: usize) {
        self.steps.push(Step::Clear(resource));
    }

    /// Copies a buffer to the beginning of another.
    pub fn copy(&mut self, from: usize, to: usize) {
        self.steps.push(Step::Copy { from, to });
    }

    /// Says that buffers sized by the number of occupied cells can be made from here on.
    pub fn counted(&mut self) {
        self.steps.push(Step::Counted);
    }

    /// Says that the steps so far have to be done only once.
    pub fn once(&mut self) {
        self.once.append(&mut self.steps);
    }

    /// A program of a WGSL module; what it is given and over what it runs is said on what this returns.
    pub fn run<'e>(&'e mut self, module: &str) -> Run<'e, 'c, 'a> {
        Run::new(self, module)
    }

    /// Checks an effect's module by itself, so that faults point into it.
    pub(crate) fn checked_effect(&mut self, module: &str) -> Option<Shader> {
        let mounts = self.mounts(&[], None);
        self.context.effect(module, &mounts)
    }
}
