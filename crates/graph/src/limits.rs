//! WebGPU's default limits, checked before a device is touched.

use voxlume_fault::{Fault, Faults};

use crate::expansion::Context;
use crate::facts::SceneFacts;
use crate::pipeline::Pipeline;
use crate::plan::{ImageExtent, Plan, ResourceKind};

/// Largest side of a 2D texture.
pub(crate) const TEXTURE_2D: u32 = 8192;
/// Largest side of a 3D texture.
const TEXTURE_3D: u32 = 2048;
/// Pixels of an image that a buffer of 256 MiB holds, at 8 bytes each.
const IMAGE_PIXELS: u64 = (256 << 20) / 8;
/// Layers of a texture array.
const LAYERS: u32 = 256;
/// Bytes of one storage buffer binding.
const STORAGE_BINDING: u64 = 128 << 20;

/// Bytes of a vertex on the device.
const VERTEX: u64 = 32;
/// Bytes of a triangle's indices.
const TRIANGLE: u64 = 12;

pub(crate) fn check_screen(screen: [u32; 2], faults: &mut Faults) {
    let [width, height] = screen;
    if width == 0 || height == 0 || width > TEXTURE_2D || height > TEXTURE_2D {
        let message = format!("an image of {width} × {height} pixels");
        faults.push(Fault::new(message).note(format!("each side: 1 to {TEXTURE_2D}")));
    } else if u64::from(width) * u64::from(height) > IMAGE_PIXELS {
        let message = format!("an image of {width} × {height} pixels");
        faults.push(Fault::new(message).note(format!("at most {IMAGE_PIXELS} pixels can be read back")));
    }
}

/// What is known before voxels are counted: the engine checks the rest once they are.
pub(crate) fn check_budget(plan: &Plan, facts: &SceneFacts) -> Result<(), Fault> {
    let Some(budget) = plan.memory_budget else { return Ok(()) };
    let scene = u64::from(facts.vertices) * VERTEX + u64::from(facts.triangles) * TRIANGLE;
    let needed = plan.total_bytes(0, 0) + scene;
    if needed <= budget {
        return Ok(());
    }
    let message =
        format!("the plan needs at least {needed} bytes on the device, over the budget of {budget}");
    let largest = (0..plan.resources.len()).max_by_key(|index| plan.bytes(*index, 0, 0));
    let most = largest.map(|index| {
        let bytes = plan.bytes(index, 0, 0).unwrap_or(0);
        format!(
            "most of all `{}`, {bytes} bytes; a lower resolution or a smaller image needs less",
            plan.resources[index].name
        )
    });
    Err(Fault::new(message).note(most.unwrap_or_default()))
}

pub(crate) fn check_resources(pipeline: &Pipeline, context: &mut Context<'_>) {
    for resource in &context.resources {
        let message = match &resource.kind {
            ResourceKind::Buffer(bytes) if *bytes > STORAGE_BINDING => {
                format!("`{}` needs {bytes} bytes; one buffer holds at most {STORAGE_BINDING}", resource.name)
            }
            ResourceKind::Volume { size, .. } if size.iter().any(|side| *side > TEXTURE_3D) => {
                let [x, y, z] = size;
                format!(
                    "`{}` needs {x} × {y} × {z} texels; a 3D texture's side is at most {TEXTURE_3D}",
                    resource.name
                )
            }
            ResourceKind::Image { extent: ImageExtent::Fixed(_), layers, .. } if *layers > LAYERS => {
                format!("the lights need {layers} shadow maps; at most {LAYERS} fit")
            }
            ResourceKind::Image { layers, .. } if *layers > LAYERS => {
                format!("`{}` needs {layers} layers; at most {LAYERS} fit", resource.name)
            }
            _ => continue,
        };
        context.faults.push(pipeline.fault(&pipeline.resolution.span, message, "at this resolution"));
    }
    let triangles = context.facts.triangles;
    let vertices = u64::from(context.facts.vertices) * VERTEX;
    if vertices > STORAGE_BINDING || u64::from(triangles) * TRIANGLE > STORAGE_BINDING {
        let message = format!(
            "a scene of {triangles} triangles and {} vertices; one buffer of 128 MiB holds 4 Mi vertices, 10 Mi triangles",
            context.facts.vertices
        );
        context.faults.push(Fault::new(message));
    }
}
