//! The program `voxlume` with one tracer more: `cargo run --release -p voxlume-cli --example bent_cone -- render SCENE --tracer
//! bent_cone -o FILE`. The book's page *Write a tracer* goes through it.

use std::process::ExitCode;

use voxlume::{Registry, Sort, Source, Tracer};

// ANCHOR: main
const TRACER: Tracer = Tracer {
    name: "bent_cone",
    summary: "short rays near the apex, and one cone beyond them along the mean direction that they leave open",
    modules: "tracer/bent_cone",
    reads: &[Sort::VOXELS, Sort::VOLUME],
    samples: true,
};

fn main() -> ExitCode {
    let mut registry = Registry::builtin();
    for (name, text) in [("trace", include_str!("trace.wgsl")), ("rays", include_str!("rays.wgsl"))] {
        let path = format!("{}/{name}", TRACER.modules);
        registry.library.insert(&path, Source::new(format!("bent_cone/{name}.wgsl"), text));
    }
    registry.tracers.add(TRACER);
    voxlume_cli::main_with(&registry, std::env::args_os())
}
// ANCHOR_END: main
