//! What is asked of WGSL beyond what naga checks.

use naga::common::wgsl::ToWgsl;
use naga::{ImageClass, Module, StorageAccess, TypeInner};
use voxlume_fault::{Fault, Faults, one_of};

use crate::linked::Linked;

/// The formats with the `STORAGE_BINDING` capability in the WebGPU standard's table of plain colour formats,
/// without an optional feature.
const STORAGE: [&str; 16] = [
    "r32float",
    "r32sint",
    "r32uint",
    "rg32float",
    "rg32sint",
    "rg32uint",
    "rgba16float",
    "rgba16sint",
    "rgba16uint",
    "rgba32float",
    "rgba32sint",
    "rgba32uint",
    "rgba8sint",
    "rgba8snorm",
    "rgba8uint",
    "rgba8unorm",
];

/// Those that can be read and written through one variable.
const READ_WRITE: [&str; 3] = ["r32float", "r32sint", "r32uint"];

/// Every storage texture whose format needs an optional feature, which naga accepts, and every workgroup
/// whose size is not a number yet, which WGSL accepts but dispatches are computed from.
pub(crate) fn check(linked: &Linked, module: &Module) -> Faults {
    let mut faults = storage_formats(linked, module);
    for entry in module.entry_points.iter().filter(|entry| entry.workgroup_size_overrides.is_some()) {
        let fault = Fault::new(format!("the workgroup size of `{}` depends on an override", entry.name));
        faults.push(linked.at_declaration(fault, &entry.name, "write a number or a `const`"));
    }
    faults
}

fn storage_formats(linked: &Linked, module: &Module) -> Faults {
    let mut faults = Faults::default();
    for (handle, variable) in module.global_variables.iter() {
        let TypeInner::Image { class: ImageClass::Storage { format, access }, .. } =
            module.types[variable.ty].inner
        else {
            continue;
        };
        let format = format.to_wgsl();
        let (allowed, how): (&[&str], _) = if access.contains(StorageAccess::LOAD | StorageAccess::STORE) {
            (&READ_WRITE, " with read_write access")
        } else {
            (&STORAGE, "")
        };
        if !allowed.contains(&format) {
            let name = variable.name.as_deref().unwrap_or_default();
            let fault = Fault::new(format!("storage texture `{name}`: {format}{how} is no WebGPU default"));
            let span = module.global_variables.get_span(handle);
            faults.push(linked.placed(fault, span, &one_of(allowed.iter().copied())));
        }
    }
    faults
}
