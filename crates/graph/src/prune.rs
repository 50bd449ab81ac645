//! What no pass reads is neither drawn nor made.

use std::collections::BTreeSet;

use crate::plan::{Groups, Life, Pass, Program, Resource, Step, Target, Vertices};

/// Leaves out colour targets that nobody reads, then resources that no step touches; and keeps of each pass's outputs only
/// what some pass, or the reader of the plan's `output`, may find there. The indices in `kept` follow.
pub(crate) fn prune(
    passes: &mut [Pass],
    resources: &mut Vec<Resource>,
    kept: [&mut [usize]; 2],
    output: &str,
) {
    let named = resources.iter().position(|resource| resource.name == output);
    let mut needed: BTreeSet<usize> = passes.iter().flat_map(|pass| pass.inputs.iter().copied()).collect();
    needed.extend(named);
    // What is read a frame later is no input.
    let histories = resources.iter().enumerate().filter(|(_, resource)| resource.life == Life::History);
    needed.extend(histories.map(|(index, _)| index));
    for pass in &mut *passes {
        pass.outputs.retain(|index| needed.contains(index));
        for step in &mut pass.steps {
            if let Step::Draw { colors, .. } = step {
                colors.iter_mut().for_each(|color| *color = color.filter(|index| needed.contains(index)));
            }
        }
    }
    let mut touched: BTreeSet<usize> = named.into_iter().collect();
    for step in passes.iter_mut().flat_map(|pass| &mut pass.steps) {
        each(step, &mut |index| {
            touched.insert(*index);
        });
    }
    let places: Vec<Option<usize>> = {
        let mut next = 0..;
        (0..resources.len()).map(|index| touched.contains(&index).then(|| next.next()).flatten()).collect()
    };
    let mut index = 0;
    resources.retain(|_| {
        index += 1;
        places[index - 1].is_some()
    });
    let moved = |index: &mut usize| *index = places[*index].unwrap_or_default();
    for pass in passes {
        pass.steps.iter_mut().for_each(|step| each(step, &mut |index| moved(index)));
        pass.inputs.iter_mut().chain(&mut pass.outputs).for_each(moved);
        pass.params.iter_mut().for_each(|slot| moved(&mut slot.resource));
    }
    kept.into_iter().flatten().for_each(moved);
}

/// Every resource that a step names.
fn each(step: &mut Step, found: &mut dyn FnMut(&mut usize)) {
    let bound = |program: &mut Program, found: &mut dyn FnMut(&mut usize)| {
        for bind in &mut program.binds {
            if let Target::Resource(index) | Target::Last(index) | Target::Mip { resource: index, .. } =
                &mut bind.target
            {
                found(index);
            }
        }
    };
    match step {
        Step::Clear(index) => found(index),
        Step::Copy { from, to } => {
            found(from);
            found(to);
        }
        Step::Counted => {}
        Step::Compute { program, groups } => {
            bound(program, found);
            match groups {
                Groups::Fixed(_) => {}
                Groups::Tiles { image: index, .. } | Groups::Indirect { resource: index, .. } => found(index),
            }
        }
        Step::Draw { program, colors, depth, .. } => {
            bound(program, found);
            colors.iter_mut().flatten().for_each(&mut *found);
            found(&mut depth.0);
        }
        Step::Raster { program, target, vertices } => {
            bound(program, found);
            found(target);
            if let Vertices::Indirect { resource, .. } = vertices {
                found(resource);
            }
        }
    }
}
