// Each voxel's sheets from the triangles that its sides show, packed (see common/sheet.wgsl).

import package::common::bands::triangle_voxel;
import package::common::dispatch::dispatch_index;
import package::common::fragment::{corners_of, fragment_at};
import package::common::front::{COVERS, FRONTS, axis_squares, facet, front_triangle, side_fronts};
import package::common::material::{base_color, materials, roughness_metallic};
import package::common::sheet::{HAS_BACK, LOW, MORE, SHEETS, SHEET_ENTRIES, SIDES, Sheet, SideMaterial, THERE, TWO_SIDED, pack_sheet, pack_side_material};
import package::common::voxels::level_cell;

// As common/fronts.wgsl leaves them.
var<storage, read> fronts: array<u32>;
// As many of each voxel as it may have: see common/side.wgsl.
var<storage, read_write> sheets: array<vec2u>;


struct Shown {
    height: f32,
    slope: vec2f,
    material: SideMaterial,
}

// What a triangle shows of itself in a voxel.
fn shown(triangle: u32, axis: u32, cell: vec3u) -> Shown {
    let corners = corners_of(triangle, triangle_voxel(triangle));
    let plane = facet(corners.v, axis, cell);
    let f = fragment_at(corners, vec3f(cell) + 0.5);
    let material = materials[corners.material];
    let shine = roughness_metallic(material, f.uv, f.lod);
    let color = base_color(material, f.uv, f.lod).rgb;
    return Shown(clamp(plane.height, -1.5, 1.5), plane.slope, SideMaterial(color, shine.x, shine.y));
}

fn mixed(a: Shown, b: Shown, t: f32) -> Shown {
    let color = mix(a.material.base_color, b.material.base_color, t);
    let roughness = mix(a.material.roughness, b.material.roughness, t);
    let metallic = mix(a.material.metallic, b.material.metallic, t);
    return Shown(mix(a.height, b.height, t), mix(a.slope, b.slope, t), SideMaterial(color, roughness, metallic));
}

// Whether a side shows anything, and if so the mean of what it shows at its points.
fn side_shown(slot: u32, side: u32, cell: vec3u, mean: ptr<function, Shown>) -> bool {
    let first = side_fronts(slot, side);
    var words: array<u32, FRONTS>;
    var any_word = 0u;
    for (var i = 0u; i < FRONTS; i++) {
        words[i] = fronts[first + i];
        any_word |= words[i];
    }
    if (any_word == 0) {
        return false;
    }
    var last = 0u;
    var one: Shown;
    var sum: Shown;
    var count = 0.0;
    for (var i = 0u; i < FRONTS; i++) {
        let word = words[i];
        // What covers a point counts alone if there is any.
        if (word == 0 || (word & COVERS) != (any_word & COVERS)) {
            continue;
        }
        if (count == 0.0 || front_triangle(word) != last) {
            last = front_triangle(word);
            one = shown(last, side / 2, cell);
        }
        sum = mixed(sum, one, 1.0 / (count + 1.0));
        count += 1.0;
    }
    *mean = sum;
    return true;
}

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let slot = dispatch_index(id, 64);
    var cell: vec3u;
    if (!level_cell(slot, 0, &cell)) {
        return;
    }
    var found: array<bool, SIDES>;
    var materials_of: array<u32, SIDES>;
    var means: array<Shown, SIDES>;
    for (var side = 0u; side < SIDES; side++) {
        var mean: Shown;
        found[side] = side_shown(slot, side, cell, &mean);
        means[side] = mean;
        materials_of[side] = pack_side_material(mean.material);
    }
    var count = 0u;
    for (var side = 0u; side < SIDES; side++) {
        if (!found[side]) {
            continue;
        }
        var bits = fronts[axis_squares(slot, side / 2)] | THERE | select(0u, LOW, (side & 1) == 1);
        if ((bits & TWO_SIDED) != 0 && !found[side ^ 1]) {
            bits |= HAS_BACK;
            materials_of[side ^ 1] = materials_of[side];
        }
        if (count > 0) {
            sheets[SHEET_ENTRIES * slot + count - 1].y |= MORE;
        }
        sheets[SHEET_ENTRIES * slot + count] = pack_sheet(Sheet(means[side].height, means[side].slope, side / 2, bits));
        count++;
    }
    for (; count < SHEETS; count++) {
        sheets[SHEET_ENTRIES * slot + count] = vec2u(0);
    }
    for (var i = 0u; i < SIDES / 2; i++) {
        sheets[SHEET_ENTRIES * slot + SHEETS + i] = vec2u(materials_of[2 * i], materials_of[2 * i + 1]);
    }
}
