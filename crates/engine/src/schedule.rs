//! Which passes a frame has to run, worked out from what each depends on. No device.

use voxlume_graph::{Pass, Plan, Resource, ResourceKind, Step, Target, Update};

/// How often something has changed.
type Version = u64;

/// Versions of what a frame is made of beside the resources of its plan.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Versions {
    /// Where triangles are.
    pub geometry: Version,
    /// Lights and sky.
    pub lights: Version,
    /// The camera, and the screen's size.
    pub camera: Version,
}

/// What is known of a plan's passes and resources from frame to frame.
#[derive(Clone, Debug)]
pub(crate) struct Schedule {
    nodes: Vec<Node>,
    now: State,
    /// What each pass saw when it last ran.
    seen: Vec<Option<Seen>>,
    pub versions: Versions,
    frame: u64,
}

/// A pass, as far as it decides what runs.
#[derive(Clone, Debug)]
struct Node {
    sources: voxlume_graph::Sources,
    update: Update,
    /// What it reads, and the last pass before it that makes this.
    inputs: Vec<(usize, Option<usize>)>,
    outputs: Vec<usize>,
    /// Those outputs that another pass reads as this one leaves them, or that are the result.
    wanted: Vec<usize>,
    /// Where in `inputs` the runs of voxels are, if an output has a value for each voxel.
    slots: Option<usize>,
}

#[derive(Clone, Debug)]
struct State {
    /// How often each pass has run.
    runs: Vec<Version>,
    /// How often each resource was written from outside.
    written: Vec<Version>,
    /// The pass that wrote each resource last.
    writers: Vec<Option<usize>>,
}

#[derive(Clone, Debug)]
struct Seen {
    versions: Versions,
    inputs: Vec<(Version, Version)>,
    frame: u64,
}

impl Schedule {
    pub fn new(plan: &Plan) -> Schedule {
        Schedule::of(&plan.passes, &plan.resources, &plan.levels, plan.output)
    }

    fn of(passes: &[Pass], resources: &[Resource], levels: &[usize], output: usize) -> Schedule {
        let makers = |resource: usize, before: usize| {
            passes[..before].iter().rposition(|pass| pass.outputs.contains(&resource))
        };
        let inputs: Vec<Vec<(usize, Option<usize>)>> = passes
            .iter()
            .enumerate()
            .map(|(index, pass)| {
                let all = pass.inputs.iter().copied().chain(parameters(pass, resources));
                all.map(|resource| (resource, makers(resource, index))).collect()
            })
            .collect();
        let wanted = |index: usize, resource: usize| {
            let made = (resource, Some(index));
            let is_read = inputs.iter().any(|of_pass| of_pass.contains(&made));
            is_read || (resource == output && makers(resource, passes.len()) == Some(index))
        };
        let is_slotted = |resource: &usize| {
            matches!(resources[*resource].kind, ResourceKind::PerVoxel(_) | ResourceKind::PerCell(_))
        };
        let slots = |index: usize, pass: &Pass| {
            let runs = inputs[index].iter().position(|(resource, _)| levels.contains(resource));
            runs.filter(|_| pass.outputs.iter().any(is_slotted))
        };
        let node = |(index, pass): (usize, &Pass)| Node {
            sources: pass.sources,
            update: pass.update,
            inputs: inputs[index].clone(),
            outputs: pass.outputs.clone(),
            wanted: pass.outputs.iter().copied().filter(|resource| wanted(index, *resource)).collect(),
            slots: slots(index, pass),
        };
        let now = State {
            runs: vec![0; passes.len()],
            written: vec![0; resources.len()],
            writers: vec![None; resources.len()],
        };
        let nodes = passes.iter().enumerate().map(node).collect();
        Schedule { nodes, now, seen: vec![None; passes.len()], versions: Versions::default(), frame: 0 }
    }

    /// Says that a resource was written from outside: who reads it runs again.
    pub fn touch(&mut self, resource: usize) {
        self.now.written[resource] += 1;
    }

    /// Says that what passes left in a resource is gone: who makes it runs again.
    pub fn forget(&mut self, resource: usize) {
        self.now.writers[resource] = None;
        for (node, seen) in self.nodes.iter().zip(&mut self.seen) {
            if node.outputs.contains(&resource) {
                *seen = None;
            }
        }
    }

    /// Says that nothing is left of earlier frames.
    pub fn forget_all(&mut self) {
        self.seen.fill(None);
        self.now.writers.fill(None);
    }

    /// Begins a frame: the passes that it runs, in order. Those in `demanded` are asked for by name.
    pub fn begin(&mut self, all: bool, demanded: &[usize]) -> Vec<usize> {
        self.frame += 1;
        let mut forced = vec![all; self.nodes.len()];
        loop {
            let (chosen, more) = self.choose(&forced, demanded);
            if more.is_empty() {
                return chosen;
            }
            more.into_iter().for_each(|pass| forced[pass] = true);
        }
    }

    /// The passes to run if these are forced to, and those that must be forced too: they make what one of the chosen reads,
    /// and another pass has written over it since.
    fn choose(&self, forced: &[bool], demanded: &[usize]) -> (Vec<usize>, Vec<usize>) {
        let (mut state, mut chosen, mut more) = (self.now.clone(), Vec::new(), Vec::new());
        for (index, node) in self.nodes.iter().enumerate() {
            // What was left for later passes is written over in this frame by an earlier one.
            let is_lost = |resource: &usize| state.writers[*resource].is_some_and(|by| chosen.contains(&by));
            let runs = forced[index]
                || node.wanted.iter().any(is_lost)
                || self.is_due(index, &state, demanded.contains(&index));
            if !runs {
                continue;
            }
            let replaced = node.inputs.iter().filter_map(|(resource, maker)| {
                let maker = (*maker)?;
                (state.writers[*resource] != Some(maker)).then_some(maker)
            });
            more.extend(replaced);
            state.ran(index, node);
            chosen.push(index);
        }
        (chosen, more)
    }

    fn is_due(&self, index: usize, state: &State, is_demanded: bool) -> bool {
        let Some(seen) = &self.seen[index] else { return true };
        let Node { sources, update, .. } = self.nodes[index];
        let (then, now) = (seen.versions, self.versions);
        let has_changed = || {
            sources.time
                || sources.geometry && then.geometry != now.geometry
                || sources.lights && then.lights != now.lights
                || sources.camera && then.camera != now.camera
                || seen.inputs != state.inputs(&self.nodes[index])
        };
        // What is kept for each voxel is in the order of voxels, which is another once they have moved.
        let now_inputs = || state.inputs(&self.nodes[index]);
        if self.nodes[index].slots.is_some_and(|place| seen.inputs[place] != now_inputs()[place]) {
            return true;
        }
        match update {
            Update::Changed => has_changed(),
            Update::Every(frames) => self.frame - seen.frame >= u64::from(frames) && has_changed(),
            Update::OnDemand => is_demanded,
        }
    }

    /// Says that a pass has run, after those before it.
    pub fn ran(&mut self, index: usize) {
        let node = &self.nodes[index];
        let inputs = self.now.inputs(node);
        self.seen[index] = Some(Seen { versions: self.versions, inputs, frame: self.frame });
        self.now.ran(index, node);
    }
}

impl State {
    /// Versions of a pass's inputs: as their maker left them and as they were written from outside.
    fn inputs(&self, node: &Node) -> Vec<(Version, Version)> {
        let version = |(resource, maker): &(usize, Option<usize>)| {
            (maker.map_or(0, |pass| self.runs[pass]), self.written[*resource])
        };
        node.inputs.iter().map(version).collect()
    }

    fn ran(&mut self, index: usize, node: &Node) {
        self.runs[index] += 1;
        node.outputs.iter().for_each(|resource| self.writers[*resource] = Some(index));
    }
}

/// The uniforms that a pass's programs read.
fn parameters<'p>(pass: &'p Pass, resources: &'p [Resource]) -> impl Iterator<Item = usize> + 'p {
    let uniforms = pass.steps.iter().filter_map(Step::program).flat_map(|program| &program.binds);
    let mut found: Vec<usize> = uniforms
        .filter_map(|bind| match bind.target {
            Target::Resource(index) if matches!(resources[index].kind, ResourceKind::Uniform(_)) => {
                Some(index)
            }
            _ => None,
        })
        .filter(|index| !pass.inputs.contains(index))
        .collect();
    found.sort_unstable();
    found.dedup();
    found.into_iter()
}

#[cfg(test)]
mod tests;
