//! Direct light of voxels.

use super::volume::SIDE_RADIANCE;
use super::{ParamWords, PassKind, Port, RADIANCE, Sort, Unread, VOXELS, Values};
use crate::bundle::Bundle;
use crate::expansion::{Expansion, Over};
use crate::pipeline::{PassEntry, Value};
use crate::plan::Target;
use crate::tracer::Tracer;

/// See [`PassKind::sentence`].
#[derive(Debug)]
pub(crate) struct Light;

impl PassKind for Light {
    fn name(&self) -> &str {
        "light"
    }

    fn sentence(&self) -> &str {
        "lights every voxel directly"
    }

    fn reads(&self) -> &[Port] {
        const PORTS: &[Port] = &[
            VOXELS,
            Port::optional("shadow_maps", Sort::SHADOW_MAPS, "depth maps, for occlusion"),
            Port::optional("emitted", Sort::RADIANCE, "what voxels reflect of the sky and of emission"),
        ];
        PORTS
    }

    fn writes(&self) -> &[Port] {
        &[RADIANCE]
    }

    fn words(&self) -> &[ParamWords] {
        const WORDS: &[ParamWords] = &[
            ParamWords {
                name: "occlusion",
                sentence: "what tells whether a voxel sees a light; with a tracer that walks voxels always a ray",
                values: Values::Words(&["shadow_map", "voxel_ray"]),
            },
            ParamWords {
                name: "emission",
                sentence: "a few emissive polygons as area lights, or all emission gathered from voxels",
                values: Values::Words(&["area_lights", "gather"]),
            },
        ];
        WORDS
    }

    fn unread(&self, entry: &PassEntry, tracer: &Tracer) -> &'static [Unread] {
        const MAPS: &[Unread] =
            &[Unread { port: "shadow_maps", why: "occlusion is by voxel ray", decided_by: None }];
        let by_ray = entry.param("occlusion") == Some(&Value::Word("voxel_ray".into()));
        if by_ray || tracer.walks() { MAPS } else { &[] }
    }

    fn gathers_all_emission(&self, entry: &PassEntry) -> bool {
        entry.param("emission") == Some(&Value::Word("gather".into()))
    }

    fn expand(&self, pass: &mut Expansion<'_, '_>) {
        let occlusion = pass.word("occlusion");
        // Read already, when the lights were chosen.
        pass.word("emission");
        let radiance = pass.resource(&pass.written(), SIDE_RADIANCE);
        let emitted = pass.input("emitted");
        let by_ray = occlusion == Some("voxel_ray") || pass.tracer().walks();
        let maps = !by_ray && pass.input("shadow_maps").is_some();
        pass.run("pass/light")
            .writes("direct", Target::Resource(radiance))
            .with("USE_SHADOW_MAP", maps)
            .over(Over::Cells(0));
        // What is gathered is added where voxels are stored: lights may then change without gathering anew.
        let mut bundle = Bundle::of("direct", Target::Resource(radiance));
        if let Some(emitted) = emitted {
            bundle.join(&emitted);
        }
        pass.makes(bundle);
    }
}
