//! Figures that are known to miss their bounds, and why. The book's page on stability has the same list.

use voxlume_report::StabilityRow;

/// A known miss.
pub struct Miss {
    pub case: &'static str,
    /// The tracer; `None` for every one.
    pub tracer: Option<&'static str>,
    /// Formats or encodings; none stands for all.
    pub of: &'static [&'static str],
    /// What the figure's name begins with.
    pub figure: &'static str,
    /// Its size at most: beyond, it is no longer the miss that is known.
    pub worst: f64,
    pub reason: &'static str,
}

const CONES: Option<&str> = Some(voxlume::CONES.name);
const RAYS: Option<&str> = Some(voxlume::RAYS.name);

/// All of them.
pub static MISSES: [Miss; 21] = [
    Miss { case: "leak", tracer: CONES, of: &[], figure: "leak", worst: 0.5, reason: BEHIND },
    Miss { case: "leak_askew", tracer: CONES, of: &[], figure: "leak", worst: 0.2, reason: BEHIND },
    Miss { case: "leak_sun", tracer: CONES, of: &["isotropic"], figure: "leak", worst: 0.12, reason: BEHIND },
    Miss { case: "leak_sun", tracer: CONES, of: &["sh2"], figure: "leak", worst: 0.004, reason: BANDS },
    Miss {
        case: "leak_lit",
        tracer: CONES,
        of: &[],
        figure: "change by the sky",
        worst: 12.0,
        reason: BEHIND,
    },
    Miss {
        case: "leak_black",
        tracer: CONES,
        of: &["isotropic"],
        figure: "leak",
        worst: 0.15,
        reason: LEVELS,
    },
    Miss {
        case: "leak_black",
        tracer: CONES,
        of: &["six_face", "sh2"],
        figure: "leak",
        worst: 0.25,
        reason: SLANTED,
    },
    Miss {
        case: "back_to_back",
        tracer: CONES,
        of: &[],
        figure: "green over red",
        worst: 1.3,
        reason: ONE_VALUE,
    },
    Miss {
        case: "slit_thick",
        tracer: RAYS,
        of: &[],
        figure: "width too much",
        worst: 0.25,
        reason: BOTH_RIMS,
    },
    Miss { case: "slit", tracer: CONES, of: &[], figure: "width too much", worst: 5.7, reason: WIDE },
    Miss {
        case: "slit_thick",
        tracer: CONES,
        of: &["isotropic"],
        figure: "width too much",
        worst: 0.95,
        reason: WIDE,
    },
    Miss {
        case: "slit_thick",
        tracer: CONES,
        of: &["six_face", "sh2"],
        figure: "width too much",
        worst: 7.7,
        reason: SLANTED,
    },
    Miss { case: "carpet", tracer: CONES, of: &[], figure: "green", worst: 0.44, reason: ONE_VALUE },
    Miss {
        case: "offset",
        tracer: CONES,
        of: &["isotropic"],
        figure: "brightness",
        worst: 0.0275,
        reason: LEVELS,
    },
    Miss { case: "turned", tracer: CONES, of: &[], figure: "brightness", worst: 0.45, reason: DISJOINT },
    Miss { case: "energy_askew", tracer: None, of: &[], figure: "`", worst: 0.5, reason: DISJOINT },
    Miss {
        case: "furnace",
        tracer: CONES,
        of: &["isotropic"],
        figure: "irradiance",
        worst: 0.1,
        reason: LEVELS,
    },
    Miss {
        case: "furnace",
        tracer: CONES,
        of: &["six_face", "sh2"],
        figure: "irradiance",
        worst: 0.28,
        reason: SLANTED,
    },
    Miss {
        case: "radiance",
        tracer: None,
        of: &[],
        figure: "irradiance beside that of 1 at 1e-6",
        worst: 0.4,
        reason: HALF_LOW,
    },
    Miss {
        case: "radiance",
        tracer: None,
        of: &[],
        figure: "irradiance beside that of 1 at 1e5",
        worst: 0.9,
        reason: HALF_HIGH,
    },
    Miss {
        case: "radiance",
        tracer: None,
        of: &["rgba8"],
        figure: "irradiance beside that of 1",
        worst: 1.0,
        reason: BYTES,
    },
];

const BEHIND: &str = "the filter of a coarse cell reaches back through the wall that a cone leaves, whose other side is lit and \
                      faces the way that the cone looks";
const BANDS: &str = "two bands of what a cell shows to one side are not quite dark to the other";
const SLANTED: &str = "a side that is seen at a slant is as opaque as its cosine, and the narrow cells that keep clear of the own \
                       surface pass through a wall before they add up to all of it";
const LEVELS: &str = "a coarser cell shifts a wall by up to half a cell, past a sample or behind one";
const ONE_VALUE: &str = "a voxel has one colour for all its surfaces, and walls nearer than a voxel share it";
const BOTH_RIMS: &str = "where both rims of a slit lie in one voxel, its upper sheet is that of both, and each rim is right to half \
                         of a square of the voxel's face";
const WIDE: &str =
    "a cone's samples on the way are as wide as the cone, and a slit of a voxel is a small part of each";
const DISJOINT: &str = "the farther child shows only where the nearer doesn't cover it on average; pieces of a slanted wall that lie \
                        beside each other are taken to hide each other";
const HALF_LOW: &str = "half floats have few bits left below 6·10⁻⁵";
const HALF_HIGH: &str = "half floats end at 65504, which images are clamped to";
const BYTES: &str = "bytes hold 255 steps of a declared range, by default up to 4: what is dimmer than half a step is lost, what \
                     is brighter is clamped";

/// Why a row misses its bound, where that is known.
pub fn reason(row: &StabilityRow) -> Option<&'static str> {
    let known = MISSES.iter().find(|miss| {
        miss.case == row.case
            && miss.tracer.is_none_or(|of| of == row.tracer)
            && (miss.of.is_empty()
                || [&row.format, &row.encoding].iter().any(|of| miss.of.contains(&of.as_str())))
            && row.figure.starts_with(miss.figure)
            && row.value.abs() <= miss.worst
    });
    known.map(|miss| miss.reason)
}
