//! The voxels of a level, seen.

use super::{ParamWords, PassKind, Port, Sort, Unread, VOXELS, Values};
use crate::bundle::Bundle;
use crate::expansion::{Expansion, Over, screen_image, step_params};
use crate::pipeline::{PassEntry, Value};
use crate::plan::{ImageTexel, ResourceKind, Target};
use crate::tracer::Tracer;

/// See [`PassKind::sentence`].
#[derive(Debug)]
pub(crate) struct VoxelView;

/// Bytes of a `ShownVoxel`.
const SHOWN_VOXEL: u64 = 16;

/// Channels that show the volume; the others show attributes.
const VOLUME_CHANNELS: [&str; 3] = ["opacity", "radiance", "lit"];

impl PassKind for VoxelView {
    fn name(&self) -> &str {
        "voxel_view"
    }

    fn sentence(&self) -> &str {
        "shows the voxels of one level as cubes, to debug a pipeline"
    }

    fn reads(&self) -> &[Port] {
        const PORTS: &[Port] = &[
            VOXELS,
            Port::optional("volume", Sort::VOLUME, "for the channels `opacity`, `radiance` and `lit`"),
        ];
        PORTS
    }

    fn writes(&self) -> &[Port] {
        &[
            const { Port::new("voxel_view", Sort::IMAGE, "one channel of the voxels, as the camera sees them") },
        ]
    }

    fn words(&self) -> &[ParamWords] {
        const WORDS: &[ParamWords] = &[
            ParamWords {
                name: "channel",
                sentence: "what of a voxel is shown",
                values: Values::Words(&[
                    "albedo",
                    "normal",
                    "occupancy",
                    "emission",
                    "opacity",
                    "radiance",
                    "lit",
                ]),
            },
            ParamWords {
                name: "level",
                sentence: "which level, 0 being the finest",
                values: Values::Whole(0, 9),
            },
        ];
        WORDS
    }

    fn unread(&self, entry: &PassEntry, _tracer: &Tracer) -> &'static [Unread] {
        const VOLUME: &[Unread] =
            &[Unread { port: "volume", why: "the channel shows attributes", decided_by: None }];
        match entry.param("channel") {
            Some(Value::Word(word)) if VOLUME_CHANNELS.contains(&word.as_str()) => &[],
            _ => VOLUME,
        }
    }

    fn expand(&self, pass: &mut Expansion<'_, '_>) {
        let image = pass.resource(&pass.written(), screen_image(ImageTexel::Rgba16Float, 1));
        pass.makes(Bundle::of(&pass.written(), Target::Resource(image)));
        let (Some(channel), Some(level)) = (pass.word("channel"), pass.whole("level")) else { return };
        let coarsest = pass.grid().levels() - 1;
        if level > coarsest {
            pass.refuse("level", &format!("this grid's levels are 0 to {coarsest}"));
            return;
        }
        let shown = pass.resource("shown_voxels", ResourceKind::PerCell(SHOWN_VOXEL));
        let shown = Target::Resource(shown);
        // The normals of coarser levels are means of level 0's, whatever the channel.
        for at in 0..=level {
            let module = if at == 0 { "pass/voxel_channel" } else { "pass/voxel_channel_mean" };
            pass.run(module)
                .writes("shown_voxels", shown.clone())
                .reads("step_params", step_params(at))
                .over(Over::Cells(at));
        }
        if VOLUME_CHANNELS.contains(&channel) {
            pass.run("pass/voxel_channel_volume")
                .writes("shown_voxels", shown.clone())
                .reads("step_params", step_params(level))
                .over(Over::Cells(level));
        }
        pass.run("pass/voxel_view")
            .mount("level_walk", "walk/bricks")
            .mount("meet", "meet/cells")
            .reads("shown_voxels", shown)
            .reads("step_params", step_params(level))
            .writes("image", Target::Resource(image))
            .over(Over::Texels(image));
    }
}
