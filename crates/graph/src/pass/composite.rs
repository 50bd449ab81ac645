//! The image from its parts.

use super::{PassKind, Port, Sort, Unread};
use crate::bundle::Bundle;
use crate::expansion::{Expansion, Over, screen_image};
use crate::pipeline::{PassEntry, Value};
use crate::plan::{ImageTexel, Target};
use crate::tracer::Tracer;

/// See [`PassKind::sentence`].
#[derive(Debug)]
pub(crate) struct Composite;

impl PassKind for Composite {
    fn name(&self) -> &str {
        "composite"
    }

    fn sentence(&self) -> &str {
        "adds up the image"
    }

    fn reads(&self) -> &[Port] {
        const PORTS: &[Port] = &[
            Port::new("surface", Sort::SURFACE, "what the camera sees"),
            Port::optional("shadow", Sort::IMAGE, "share of each light that arrives"),
            Port::optional("ao", Sort::IMAGE, "ambient openness"),
            Port::new("diffuse", Sort::IMAGE, "gathered irradiance"),
            Port::optional("specular", Sort::IMAGE, "gathered glossy radiance"),
        ];
        PORTS
    }

    fn writes(&self) -> &[Port] {
        &[const { Port::new("final", Sort::IMAGE, "linear radiance") }]
    }

    fn unread(&self, entry: &PassEntry, _tracer: &Tracer) -> &'static [Unread] {
        const AO: &[Unread] =
            &[Unread { port: "ao", why: "`ao_weight` is 0", decided_by: Some("ao_weight") }];
        if entry.param("ao_weight") == Some(&Value::Number(0.0)) { AO } else { &[] }
    }

    fn expand(&self, pass: &mut Expansion<'_, '_>) {
        let image = pass.resource(&pass.written(), screen_image(ImageTexel::Rgba16Float, 1));
        pass.makes(Bundle::of(&pass.written(), Target::Resource(image)));
        pass.run("pass/composite").writes("image", Target::Resource(image)).over(Over::Texels(image));
    }
}
