//! The kinds of passes, one table.

use crate::expand;
use crate::expand::Expansion;

/// A kind of pass: what it takes, what it makes, and how it becomes steps.
#[derive(Debug)]
pub struct Kind {
    /// The word after `run:`.
    pub name: &'static str,
    /// What it does.
    pub sentence: &'static str,
    /// What it may read.
    pub reads: &'static [Port],
    /// What it makes.
    pub writes: &'static [Port],
    /// What it changes.
    pub updates: &'static [Port],
    /// Its parameters beside those in its shader's `Params`.
    pub words: &'static [ParamWords],
    pub(crate) expand: fn(&mut Expansion<'_, '_>),
}

/// A resource that a kind of pass reads, makes or changes.
#[derive(Debug)]
pub struct Port {
    /// Name of the resource.
    pub name: &'static str,
    /// What it is.
    pub sentence: &'static str,
    /// Whether the pass can do without.
    pub optional: bool,
}

/// A parameter that decides what is planned.
#[derive(Debug)]
pub struct ParamWords {
    /// Its name.
    pub name: &'static str,
    /// What it decides.
    pub sentence: &'static str,
    /// Its values: words, or a range of whole numbers.
    pub values: Values,
}

/// Values of a [`ParamWords`].
#[derive(Debug)]
pub enum Values {
    /// One of these words.
    Words(&'static [&'static str]),
    /// A whole number in this range, ends included.
    Whole(u32, u32),
    /// A number in this range, ends included.
    Number(f64, f64),
}

const fn port(name: &'static str, sentence: &'static str) -> Port {
    Port { name, sentence, optional: false }
}

const fn optional(name: &'static str, sentence: &'static str) -> Port {
    Port { name, sentence, optional: true }
}

const VOXELS: Port = port("voxels", "occupied voxels with reflectance, normal and emission");
const VOLUME: Port = port("volume", "filtered radiance and opacity, in the storage format");

/// All kinds but the effects, which are WGSL files.
pub const KINDS: &[Kind] = &[
    Kind {
        name: "voxelize",
        sentence: "finds the voxels that triangles overlap and sums their attributes",
        reads: &[],
        writes: &[VOXELS],
        updates: &[],
        words: &[
            ParamWords {
                name: "method",
                sentence: "who walks a triangle's voxels; the voxels are the same; `balanced` unless given",
                values: Values::Words(&["triangle", "fragment", "hybrid", "balanced"]),
            },
            ParamWords {
                name: "cutoff",
                sentence: "voxel² of projected area up to which `hybrid` has a thread walk a triangle; 4 unless given",
                values: Values::Number(0.0, 1e9),
            },
            ParamWords {
                name: "coverage",
                sentence: "opacity of a voxel: 1, or the area that triangles cover of its face; `binary` unless given",
                values: Values::Words(&["binary", "area"]),
            },
            ParamWords {
                name: "conflict",
                sentence: "a voxel's reflectance where triangles meet: their mean, the largest packed word, or a mean \
                           that depends on the order; `sum` unless given",
                values: Values::Words(&["sum", "max", "running_average"]),
            },
        ],
        expand: expand::voxelize::voxelize,
    },
    Kind {
        name: "shadow_maps",
        sentence: "draws the scene's depth from every directional, spot and point light",
        reads: &[],
        writes: &[port("shadow_maps", "depth maps")],
        updates: &[],
        words: &[ParamWords {
            name: "size",
            sentence: "side of a map in texels",
            values: Values::Whole(16, 4096),
        }],
        expand: expand::shadow_maps::shadow_maps,
    },
    Kind {
        name: "emission",
        sentence: "lets every voxel gather what the sky and emissive surfaces send, once",
        reads: &[VOXELS],
        writes: &[port("emitted", "what each voxel reflects of the sky and of emission")],
        updates: &[],
        words: &[],
        expand: expand::light::emission,
    },
    Kind {
        name: "light",
        sentence: "lights every voxel directly",
        reads: &[
            VOXELS,
            optional("shadow_maps", "depth maps, for occlusion"),
            optional("emitted", "what voxels reflect of the sky and of emission"),
        ],
        writes: &[port("radiance", "each voxel's outgoing radiance")],
        updates: &[],
        words: &[
            ParamWords {
                name: "occlusion",
                sentence: "what tells whether a voxel sees a light",
                values: Values::Words(&["shadow_map", "voxel_ray"]),
            },
            ParamWords {
                name: "emission",
                sentence: "a few emissive polygons as area lights, or all emission gathered from voxels",
                values: Values::Words(&["area_lights", "gather"]),
            },
        ],
        expand: expand::light::light,
    },
    Kind {
        name: "filter",
        sentence: "stores the voxels' radiance in the storage format and makes its coarser levels",
        reads: &[VOXELS, port("radiance", "each voxel's outgoing radiance")],
        writes: &[VOLUME],
        updates: &[],
        words: &[ParamWords {
            name: "cells",
            sentence: "parents made: those of occupied voxels, or all, which only costs more; `active` unless given",
            values: Values::Words(&["active", "all"]),
        }],
        expand: expand::light::filter,
    },
    Kind {
        name: "bounce",
        sentence: "lets every voxel gather the volume, adds what it reflects and filters again, so many times",
        reads: &[VOXELS, port("radiance", "each voxel's outgoing radiance")],
        writes: &[],
        updates: &[VOLUME],
        words: &[ParamWords { name: "bounces", sentence: "how many times", values: Values::Whole(0, 16) }],
        expand: expand::light::bounce,
    },
    Kind {
        name: "gbuffer",
        sentence: "draws what the camera sees",
        reads: &[],
        writes: &[port("surface", "albedo, normal, geometry, emission and depth, one image each")],
        updates: &[],
        words: &[],
        expand: expand::gbuffer::gbuffer,
    },
    Kind {
        name: "composite",
        sentence: "adds up the image",
        reads: &[
            port("surface", "what the camera sees"),
            optional("shadow", "share of each light that arrives"),
            optional("ao", "ambient openness"),
            port("diffuse", "gathered irradiance"),
            optional("specular", "gathered glossy radiance"),
        ],
        writes: &[port("final", "linear radiance")],
        updates: &[],
        words: &[],
        expand: expand::screen::screen,
    },
    Kind {
        name: "voxel_view",
        sentence: "shows the voxels of one level as cubes, to debug a pipeline",
        reads: &[VOXELS, optional("volume", "for the channels `opacity`, `radiance` and `lit`")],
        writes: &[port("voxel_view", "one channel of the voxels, as the camera sees them")],
        updates: &[],
        words: &[
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
        ],
        expand: expand::voxel_view::voxel_view,
    },
];

/// Images that `surface` stands for.
pub const SURFACE_IMAGES: [&str; 5] = ["albedo", "normal", "geometry", "depth", "emission"];

impl Kind {
    /// Whether it makes images of the screen's size that can be an output; effects do, too.
    pub fn is_screen(&self) -> bool {
        matches!(self.name, "composite" | "voxel_view")
    }

    /// The kind called `name`.
    pub fn get(name: &str) -> Option<&'static Kind> {
        KINDS.iter().find(|kind| kind.name == name)
    }
}
