// Each voxel's sheets from the triangles that its sides show, packed (see common/sheet.wgsl).

import package::common::bands::triangle_voxel;
import package::common::dispatch::dispatch_index;
import package::common::fragment::{corners_of, fragment_at};
import package::common::front::{COVERS, CUT, axis_squares, axis_touched, facet, front_triangles, side_fronts};
import package::common::material::{HAS_EMISSION, base_color, emission, materials, roughness_metallic};
import package::common::radiance::pack_radiance;
import package::common::sheet::{ALL_SQUARES, FIRST_EMISSION, HAS_BACK, LOW, MORE, SHEETS, SHEET_ENTRIES, SIDES, Sheet, SideMaterial, THERE, TWO_SIDED, before, pack_sheet, pack_side_material, square_middle, unswizzled};
import package::common::voxels::level_cell;

// As common/fronts.wgsl leaves them.
var<storage, read> fronts: array<u32>;
// As many of each voxel as it may have: see common/side.wgsl.
var<storage, read_write> sheets: array<vec2u>;

struct Shown {
    height: f32,
    slope: vec2f,
    material: SideMaterial,
    emission: vec3f,
}

// What a triangle shows of itself in a voxel.
fn shown(triangle: u32, axis: u32, cell: vec3u) -> Shown {
    let corners = corners_of(triangle, triangle_voxel(triangle));
    let plane = facet(corners.v, axis, cell);
    let f = fragment_at(corners, vec3f(cell) + 0.5);
    let material = materials[corners.material];
    let shine = roughness_metallic(material, f.uv, f.lod);
    let color = base_color(material, f.uv, f.lod).rgb;
    var emitted = vec3f(0.0);
    if (HAS_EMISSION) {
        emitted = emission(material, f.uv, f.lod);
    }
    return Shown(clamp(plane.height, -1.5, 1.5), plane.slope, SideMaterial(color, shine.x, shine.y), emitted);
}

fn mixed(a: Shown, b: Shown, t: f32) -> Shown {
    let color = mix(a.material.base_color, b.material.base_color, t);
    let roughness = mix(a.material.roughness, b.material.roughness, t);
    let metallic = mix(a.material.metallic, b.material.metallic, t);
    let emitted = mix(a.emission, b.emission, t);
    return Shown(mix(a.height, b.height, t), mix(a.slope, b.slope, t), SideMaterial(color, roughness, metallic), emitted);
}

fn side_words(first: u32) -> vec4u {
    return vec4u(fronts[first], fronts[first + 1], fronts[first + 2], fronts[first + 3]);
}

// The mean of what a side shows at its points. Of its words what covers a point counts alone if there is any.
fn side_shown(words: vec4u, axis: u32, cell: vec3u) -> Shown {
    let triangles = front_triangles(words);
    let covering = words >= vec4u(COVERS);
    var left = select(words != vec4u(0), covering, any(covering));
    var mean: Shown;
    var count = 0.0;
    // Mostly all four are one triangle's.
    while (any(left)) {
        let triangle = select(select(select(triangles.w, triangles.z, left.z), triangles.y, left.y), triangles.x, left.x);
        let same = left & (triangles == vec4u(triangle));
        let share = dot(vec4f(same), vec4f(1.0));
        count += share;
        mean = mixed(mean, shown(triangle, axis, cell), share / count);
        left = left & !same;
    }
    return mean;
}

// A sheet lies on one side of another's plane if its squares reach over the plane by no more than this: half a square, in voxels.
const REACH = 0.1;

// How a sheet lies to the voxel's others of other axes: all of it in front of them, all of it behind them, or neither. Both where they
// are nearly one plane.
struct Relation {
    before: bool,
    behind: bool,
}

fn relation(sheet: Sheet, others: ptr<function, array<Sheet, SIDES>>, count: u32) -> Relation {
    var r = Relation(true, true);
    var left = sheet.bits & ALL_SQUARES;
    while (left != 0) {
        let at = square_middle(firstTrailingBit(left));
        left &= left - 1;
        let point = unswizzled(at, sheet.height + dot(sheet.slope, at), sheet.axis);
        for (var i = 0u; i < count; i++) {
            let other = (*others)[i];
            if (other.axis != sheet.axis) {
                let distance = before(other, point);
                r.before = r.before && distance > -REACH;
                r.behind = r.behind && distance < REACH;
            }
        }
    }
    return r;
}

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let slot = dispatch_index(id, 64);
    var cell: vec3u;
    if (!level_cell(slot, 0, &cell)) {
        return;
    }
    var sides = 0u;
    for (var side = 0u; side < SIDES; side++) {
        sides |= select(0u, 1u << side, any(side_words(side_fronts(slot, side)) != vec4u(0)));
    }
    let stride = arrayLength(&sheets) / SHEET_ENTRIES;
    for (var i = SHEETS; i < SHEET_ENTRIES; i++) {
        sheets[slot + i * stride] = vec2u(0);
    }
    var found: array<Sheet, SIDES>;
    var count = 0u;
    var left = sides;
    while (left != 0) {
        let side = firstTrailingBit(left);
        left &= left - 1;
        let mean = side_shown(side_words(side_fronts(slot, side)), side / 2, cell);
        let material = pack_side_material(mean.material);
        var bits = fronts[axis_squares(slot, side / 2)] | THERE | select(0u, LOW, (side & 1) == 1) | select(0u, MORE, left != 0);
        let emitted = pack_radiance(mean.emission);
        let materials_at = slot + (SHEETS + side / 2) * stride;
        let emission_at = slot + (FIRST_EMISSION + side / 2) * stride;
        sheets[materials_at][side & 1] = material;
        if (HAS_EMISSION) {
            sheets[emission_at][side & 1] = emitted;
        }
        if ((bits & TWO_SIDED) != 0 && ((sides >> (side ^ 1)) & 1) == 0) {
            bits |= HAS_BACK;
            sheets[materials_at][(side & 1) ^ 1] = material;
            if (HAS_EMISSION) {
                sheets[emission_at][(side & 1) ^ 1] = emitted;
            }
        }
        let is_cut = (fronts[axis_touched(slot, side / 2)] & CUT) != 0;
        found[count] = Sheet(mean.height, mean.slope, side / 2, bits, is_cut, false);
        count++;
    }
    for (var i = 0u; i < SHEETS; i++) {
        var words = vec2u(0);
        if (i < count) {
            var sheet = found[i];
            // Where sheets of different axes meet, squares half covered close the gap that a corner would have: of a hollow the rest
            // lies behind the other sheet, of a body rays are told where it ends. An edge by itself ends where it ends.
            let meets_others = (sides & ~(3u << (2 * sheet.axis))) != 0;
            if (meets_others) {
                let r = relation(sheet, &found, count);
                if (r.before || r.behind) {
                    sheet.bits |= fronts[axis_touched(slot, sheet.axis)] & ALL_SQUARES;
                    sheet.ends = !r.before;
                }
            }
            words = pack_sheet(sheet);
        }
        sheets[slot + i * stride] = words;
    }
}
