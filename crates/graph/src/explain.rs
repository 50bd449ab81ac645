//! A plan in words.

use std::fmt::Write;

use crate::plan::{Groups, Pass, Plan, ResourceKind, Sources, Step, Update};

/// The passes in order, the resources with their bytes, and what was left out.
pub fn explain(plan: &Plan) -> String {
    let mut text = String::new();
    let [x, y, z] = plan.grid.size;
    let [width, height] = plan.screen;
    // Writing to a string can't fail.
    let _ = writeln!(
        text,
        "{} {}, traced by {} · grid {x} × {y} × {z}, voxels of {:.4} · {width} × {height} pixels · {} triangles\n",
        plan.format, plan.encoding, plan.tracer, plan.grid.voxel_size, plan.triangles
    );
    let _ = writeln!(text, "passes");
    for pass in &plan.passes {
        let names = |list: &[String]| if list.is_empty() { "nothing".to_owned() } else { list.join(", ") };
        let _ = writeln!(text, "  {:<18} {} → {}", pass.name, names(&pass.reads), names(&pass.writes));
        let _ = writeln!(text, "  {:<18}   runs {}", "", when(pass));
        let _ = writeln!(text, "  {:<18}   {}", "", work(pass.steps.iter()));
    }
    let _ = writeln!(text, "\nresources");
    for (index, resource) in plan.resources.iter().enumerate() {
        let size = match &resource.kind {
            ResourceKind::Scene | ResourceKind::Uniform(_) => continue,
            ResourceKind::PerVoxel(bytes) => format!("{bytes} B × occupied voxels"),
            ResourceKind::PerCell(bytes) => format!("{bytes} B × occupied cells of all levels"),
            _ => plan.bytes(index, 0, 0).map(mebibytes).unwrap_or_default(),
        };
        let _ = writeln!(text, "  {:<18} {:<41} {size}", resource.name, shape(plan, &resource.kind));
    }
    let _ = writeln!(text, "\nleft out");
    for item in &plan.left_out {
        let saved =
            if item.bytes > 0 { format!(" (saves {})", mebibytes(item.bytes)) } else { String::new() };
        let _ = writeln!(text, "  {:<38} {}{saved}", item.what, item.why);
    }
    text
}

/// What makes a pass run, in words.
fn when(pass: &Pass) -> String {
    let Sources { geometry, lights, camera, parameters, time } = pass.sources;
    let sources = [
        (geometry, "triangles that move"),
        (lights, "lights"),
        (camera, "camera"),
        (parameters, "parameters"),
        (time, "time"),
    ];
    let sources = sources.into_iter().filter(|(depends, _)| *depends).map(|(_, name)| name.to_owned());
    let all: Vec<String> = sources.chain(pass.waits_for.iter().cloned()).collect();
    let changed =
        if all.is_empty() { "once".to_owned() } else { format!("when these change: {}", all.join(", ")) };
    match pass.update {
        Update::Changed => changed,
        Update::Every(frames) => format!("{changed}, at most once in {frames} frames"),
        Update::OnDemand => "once, and on demand".to_owned(),
    }
}

fn work<'a>(steps: impl Iterator<Item = &'a Step>) -> String {
    let (mut compute, mut indirect, mut draws) = (0, 0, 0);
    for step in steps {
        match step {
            Step::Compute { groups: Groups::Fixed(_) | Groups::Tiles { .. }, .. } => compute += 1,
            Step::Compute { groups: Groups::Indirect { .. }, .. } => indirect += 1,
            Step::Draw { .. } | Step::Raster { .. } => draws += 1,
            Step::Clear(_) | Step::Copy { .. } | Step::Counted => {}
        }
    }
    let parts = [(compute, "dispatch"), (indirect, "indirect dispatch"), (draws, "draw")];
    let words: Vec<String> = parts
        .into_iter()
        .filter(|(count, _)| *count > 0)
        .map(|(count, what)| match count {
            1 => format!("1 {what}"),
            _ => format!("{count} {what}{}", if what.ends_with('h') { "es" } else { "s" }),
        })
        .collect();
    words.join(", ")
}

fn shape(plan: &Plan, kind: &ResourceKind) -> String {
    match kind {
        ResourceKind::Scene | ResourceKind::Uniform(_) => String::new(),
        ResourceKind::Buffer(_) | ResourceKind::PerVoxel(_) | ResourceKind::PerCell(_) => "buffer".into(),
        ResourceKind::Volume { size: [x, y, z], mips, encoding, numbers } => {
            format!("{x} × {y} × {z} {}, {}", numbers.texel(*encoding).word(), count(*mips, "level"))
        }
        ResourceKind::Image { extent, texel, layers, .. } => {
            let [width, height] = extent.size(plan.screen);
            format!("{width} × {height} {}, {}", texel.name(), count(*layers, "layer"))
        }
        ResourceKind::Raster { side } => format!("{side} × {side} fragments"),
    }
}

fn count(n: u32, what: &str) -> String {
    format!("{n} {what}{}", if n == 1 { "" } else { "s" })
}

fn mebibytes(bytes: u64) -> String {
    if bytes < 1 << 10 {
        format!("{bytes} B")
    } else if bytes < 1 << 20 {
        format!("{:.1} KiB", bytes as f64 / f64::from(1 << 10))
    } else {
        format!("{:.2} MiB", bytes as f64 / f64::from(1 << 20))
    }
}
