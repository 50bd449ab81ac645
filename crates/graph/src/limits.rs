//! WebGPU's default limits, checked before a device is touched.

use voxlume_fault::{Fault, Faults};

use crate::expand::Context;
use crate::pipeline::Pipeline;
use crate::plan::ResourceKind;

/// Largest side of a 2D texture.
const TEXTURE_2D: u32 = 8192;
/// Largest side of a 3D texture.
const TEXTURE_3D: u32 = 2048;
/// Pixels of an image that a buffer of 256 MiB holds, at 8 bytes each.
const IMAGE_PIXELS: u64 = (256 << 20) / 8;
/// Layers of a texture array.
const LAYERS: u32 = 256;
/// Bytes of one storage buffer binding.
const STORAGE_BINDING: u64 = 128 << 20;

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
            ResourceKind::ShadowMaps { layers, .. } if *layers > LAYERS => {
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
    let vertices = u64::from(context.facts.vertices) * 32;
    if vertices > STORAGE_BINDING || u64::from(triangles) * 12 > STORAGE_BINDING {
        let message = format!(
            "a scene of {triangles} triangles and {} vertices; one buffer of 128 MiB holds 4 Mi vertices, 10 Mi triangles",
            context.facts.vertices
        );
        context.faults.push(Fault::new(message));
    }
}
