// The sides of a voxel's surfaces, each with a radiance of its own: for each axis k that towards +k and that towards −k.

import package::common::attributes::{HAS_VOXEL_EMISSION, VoxelSurface};
import package::common::conflict::{CONFLICT, CONFLICT_SUM};
import package::common::radiance::unpack_radiance;
import package::common::sheet::{AXIS_SHIFT, FIRST_EMISSION, HAS_BACK, LOW, MORE, SHEETS, SHEET_ENTRIES, SIDES, SideMaterial, middle_of, sheet_normal, unpack_sheet, unpack_side_material};
import package::common::reflectance::{reflectance_from, total_reflectance};
import package::common::trace::{Apex, Share};

// Of each voxel: as many sheets as it may have, those that are there first; then the material of each of its sides, and what it emits, if voxels keep that.
var<storage, read> sheets: array<vec2u>;

// Entry number `index` of a voxel. All voxels' first entries come first, then all second ones: most voxels have no second sheet.
fn sheet_entry(slot: u32, index: u32) -> vec2u {
    return sheets[index * (arrayLength(&sheets) / SHEET_ENTRIES) + slot];
}


// Number 2k looks towards +k, number 2k + 1 towards −k.
fn side_number(bits: u32, back: bool) -> u32 {
    return 2 * ((bits >> AXIS_SHIFT) & 3) + select(0u, 1u, ((bits & LOW) != 0) != back);
}

// A side as light arrives at it.
struct Side {
    // In all voxels' sides.
    index: u32,
    apex: Apex,
    // Of even light.
    reflectance: vec3f,
    // Whether the material is known; else what it reflects is the same from all directions.
    has_material: bool,
    material: SideMaterial,
    // Gathered from voxels, W·m⁻²·sr⁻¹.
    emission: vec3f,
}

// What a side reflects of light from one direction, to all sides together.
fn side_reflectance(side: Side, direction: vec3f) -> vec3f {
    if (!side.has_material) {
        return side.reflectance;
    }
    let m = side.material;
    return saturate(reflectance_from(m.base_color, m.metallic, m.roughness, dot(direction, side.apex.normal)));
}

// Goes to the next side that a voxel shows; `at` begins with 0. False after the last.
fn next_side(cell: vec3u, slot: u32, surface: VoxelSurface, share: Share, at: ptr<function, u32>, side: ptr<function, Side>) -> bool {
    let centre = vec3f(cell) + 0.5;
    // Even: the front of a sheet. Odd: its back.
    var step = *at;
    var words = sheet_entry(slot, step / 2);
    if (step == 0 && words.y == 0) {
        // Too little of a surface for a sheet: one side along the mean normal.
        *at = 2 * SHEETS;
        *side = Side(SIDES * slot, Apex(centre, surface.normal, share), surface.albedo, false, SideMaterial(), surface.emission);
        return any(surface.normal != vec3f(0.0));
    }
    if ((step & 1) == 1 && (words.y & HAS_BACK) == 0) {
        step += 1;
    }
    if (step >= 2 * SHEETS || ((step & 1) == 0 && step > 0 && (sheet_entry(slot, step / 2 - 1).y & MORE) == 0)) {
        return false;
    }
    words = sheet_entry(slot, step / 2);
    *at = step + 1;
    let back = (step & 1) == 1;
    let sheet = unpack_sheet(words);
    let number = side_number(words.y, back);
    let up = normalize(sheet_normal(sheet));
    let apex = Apex(centre + middle_of(sheet), select(up, -up, (number & 1) == 1), share);
    let material = unpack_side_material(sheet_entry(slot, SHEETS + number / 2)[number & 1]);
    var reflectance = surface.albedo;
    if (CONFLICT == CONFLICT_SUM) {
        reflectance = saturate(total_reflectance(material.base_color, material.metallic, material.roughness));
    }
    var emission = vec3f(0.0);
    if (HAS_VOXEL_EMISSION) {
        emission = unpack_radiance(sheet_entry(slot, FIRST_EMISSION + number / 2)[number & 1]);
    }
    *side = Side(SIDES * slot + number, apex, reflectance, CONFLICT == CONFLICT_SUM, material, emission);
    return true;
}
