//! The hard cases.

use voxlume::Scene;

use super::bench::Bench;
use super::figure::{
    Figures, aperture, bits, brightness, carpet, colour, energy, feedback, finite, grazing, irradiance, leak,
    lone, moved, opening, range, refused,
};

/// A case.
pub struct Case {
    /// Its name.
    pub name: &'static str,
    /// What should hold.
    pub property: &'static str,
    /// File and text.
    pub scene: (&'static str, &'static str),
    pub(crate) measure: Measure,
    /// Unless others are asked for.
    pub(crate) resolutions: &'static [u32],
}

/// How it is measured.
pub enum Measure {
    /// On a device, in every format, encoding and resolution.
    Rendered(fn(&Bench<'_>, &Scene) -> Figures),
    /// Once, without a device.
    Loaded(fn((&str, &str)) -> Figures),
}

macro_rules! hard {
    ($file:literal) => {
        (concat!("scenes/hard/", $file, ".ron"), include_str!(concat!("../../scenes/hard/", $file, ".ron")))
    };
}

const FURNACE: (&str, &str) = ("scenes/furnace.ron", include_str!("../../scenes/furnace.ron"));
const BOTH: &[u32] = &[32, 64];
const LONE: &[u32] = &[32, 64, 128];

const fn case(
    name: &'static str,
    property: &'static str,
    scene: (&'static str, &'static str),
    measure: fn(&Bench<'_>, &Scene) -> Figures,
    resolutions: &'static [u32],
) -> Case {
    Case { name, property, scene, measure: Measure::Rendered(measure), resolutions }
}

const fn refuse(name: &'static str, scene: (&'static str, &'static str)) -> Case {
    Case {
        name,
        property: "refused with its place",
        scene,
        measure: Measure::Loaded(refused::refused),
        resolutions: &[],
    }
}

const FINITE: &str = "finite images and volumes";

/// All of them.
pub static CASES: [Case; 47] = [
    case("leak", "a sealed box is dark under a sky", hard!("sealed_box"), leak::from_sky, BOTH),
    case(
        "leak_black",
        "so it is with walls that reflect nothing",
        hard!("sealed_box"),
        leak::through_black,
        BOTH,
    ),
    case("leak_askew", "so it is askew to the grid", hard!("sealed_box_turned"), leak::from_sky, BOTH),
    case("leak_sun", "so it is in the sun", hard!("sealed_box_sun"), leak::from_sun, BOTH),
    case(
        "leak_lit",
        "the light outside changes nothing in a lit room",
        hard!("sealed_box_lit"),
        leak::beside_lamp,
        BOTH,
    ),
    case(
        "leak_level_0",
        "so it is for rays, which keep to level 0",
        hard!("sealed_box_sun"),
        leak::at_level_0,
        BOTH,
    ),
    case(
        "grazing_wall",
        "so it is where the sun grazes it",
        hard!("grazing_wall"),
        grazing::through_wall,
        BOTH,
    ),
    case(
        "slit",
        "a slit in a roof of sheets is as wide as it is",
        hard!("slit_sheets"),
        opening::between_sheets,
        BOTH,
    ),
    case("slit_thick", "so it is in a roof of boxes", hard!("slit_boxes"), opening::between_boxes, BOTH),
    case("lone_cube", "a cube alone sees nothing of itself", hard!("lone_cube"), lone::lone, LONE),
    case("lone_ball", "nor does a ball", hard!("lone_ball"), lone::lone, LONE),
    case("carpet", "a carpet hides the floor under it", hard!("carpet"), carpet::over_floor, BOTH),
    case("grazing", "a plain casts no shadow on itself", hard!("grazing"), grazing::own_shadow, BOTH),
    case(
        "back_to_back",
        "walls back to back keep their colours",
        hard!("back_to_back"),
        colour::crosstalk,
        BOTH,
    ),
    case("paper", "a sheet without thickness casts its shadow", hard!("paper"), colour::shadow, BOTH),
    case(
        "brightness",
        "as bright at every resolution",
        hard!("room"),
        brightness::brightness,
        &[32, 64, 128, 256],
    ),
    case("offset", "and wherever walls lie in voxels", hard!("room"), brightness::over_offsets, BOTH),
    case("energy", "a wall is the same on every level", hard!("one_wall"), energy::along_an_axis, BOTH),
    case("energy_askew", "so it is askew to the grid", hard!("slanted_wall"), energy::askew, BOTH),
    case("furnace", "irradiance in a closed box is its closed form", FURNACE, irradiance::furnace, BOTH),
    case("border", "nothing beyond the grid darkens its border", hard!("border"), irradiance::open_sky, BOTH),
    case("feedback", "bounces in a closed box fade", FURNACE, feedback::closed, &[32]),
    case("narrow_gap", "so they do between near plates", hard!("narrow_gap"), feedback::as_it_is, &[32]),
    case("radiance", "from 10⁻⁶ to 10⁵ alike", FURNACE, range::range, &[32]),
    case("origin", "the same up to 10⁶ units from the origin", hard!("room"), moved::origin, &[64]),
    case("scale", "the same from 10⁻⁴ to 10⁴ units wide", hard!("room"), moved::scale, &[64]),
    case("mirrored", "the same mirrored", hard!("room"), moved::mirrored, &[64]),
    case("turned", "as bright turned", hard!("room"), moved::turned, BOTH),
    case("runs", "the same bits in every run", hard!("room"), bits::runs, BOTH),
    case("shuffled", "the same bits in any order of triangles", hard!("room"), bits::shuffled, BOTH),
    case(
        "aperture",
        "cones from 0° to almost 180° are finite",
        hard!("wide_lights"),
        aperture::aperture,
        &[32],
    ),
    case(
        "roughness",
        "so are mirrored ones of every roughness",
        hard!("wide_lights"),
        aperture::roughness,
        &[32],
    ),
    case("odd_sizes", "so are images and grids of odd sizes", hard!("room"), finite::odd_sizes, &[32, 45]),
    case("slivers", FINITE, hard!("slivers"), finite::finite, BOTH),
    case("across", FINITE, hard!("across"), finite::finite, BOTH),
    case("million", FINITE, hard!("million"), finite::finite, &[64]),
    case("far_away", FINITE, hard!("far_away"), finite::finite, BOTH),
    case("tiny", FINITE, hard!("tiny"), finite::finite, BOTH),
    case("huge", FINITE, hard!("huge"), finite::finite, BOTH),
    case("uneven", FINITE, hard!("mirrored"), finite::finite, BOTH),
    case("no_size_light", FINITE, hard!("no_size_light"), finite::finite, BOTH),
    case("against_the_light", FINITE, hard!("against_the_light"), finite::finite, BOTH),
    case("camera_inside", FINITE, hard!("camera_inside"), finite::finite, BOTH),
    case("coplanar", FINITE, hard!("coplanar"), finite::finite, BOTH),
    case("emissive_sliver", FINITE, hard!("emissive_sliver"), finite::finite, BOTH),
    case("flat", FINITE, hard!("flat"), finite::finite, BOTH),
    case("empty", FINITE, hard!("empty"), finite::finite, BOTH),
];

/// Cases that a file alone decides.
pub static REFUSED: [Case; 2] =
    [refuse("not_a_number", hard!("not_a_number")), refuse("infinity", hard!("infinity"))];
