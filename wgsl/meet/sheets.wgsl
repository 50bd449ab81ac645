// What a ray meets in an occupied cell: the sheets of the cell's surfaces, as far as they are there.

import package::common::ray::{Passage, Ray, RayHit, is_of};
import package::common::sheet::{before, LOW, MORE, TWO_SIDED, inner_squares, sheet_normal, square_at, unpack_sheet, SHEETS, SIDES};
import package::common::side::{sheet_entry, side_number};

// How far out of its cell a sheet is still met, so that sheets of neighbours leave no gap between them.
const OVERLAP = 0.03;
// How far from its apex a ray may still meet the surface that it leaves, or from its end the one that it runs up to.
const NEAR = 1.5;

// Whether a point of one of a voxel's sheets lies before another's front, so that the sheet has ended there.
fn has_ended(slot: u32, axis: u32, at: vec3f) -> bool {
    for (var i = 0u; i < SHEETS; i++) {
        let words = sheet_entry(slot, i);
        let other = unpack_sheet(words);
        if (other.axis != axis && before(other, at) > 0.0) {
            return true;
        }
        if ((words.y & MORE) == 0) {
            break;
        }
    }
    return false;
}

fn meets(ray: Ray, cell: vec3u, slot: u32, passage: Passage, hit: ptr<function, RayHit>) -> bool {
    let centre = vec3f(cell) + 0.5;
    let origin = ray.origin - centre;
    var nearest = ray.reach;
    for (var i = 0u; i < SHEETS; i++) {
        let words = sheet_entry(slot, i);
        if (words.y == 0) {
            // Too little of a surface for a sheet: all of the cell.
            *hit = RayHit(true, passage.enter, cell, passage.normal, SIDES * slot, true);
            return true;
        }
        let sheet = unpack_sheet(words);
        let normal = sheet_normal(sheet);
        let towards = dot(normal, ray.direction);
        let t = (sheet.height - dot(normal, origin)) / towards;
        let at = origin + t * ray.direction;
        let from_behind = (towards > 0.0) == ((words.y & LOW) == 0);
        let shown = !from_behind || (words.y & TWO_SIDED) != 0;
        // Squares reach over an edge by up to half of one. So past the edge of a body a ray would meet them from behind: the outermost don't count then.
        // Where several sheets meet they close a corner, and a mask's squares are cut as they are: there all count.
        let meets_others = i > 0 || (words.y & MORE) != 0;
        let there = select(inner_squares(words.y), words.y, shown || meets_others || sheet.has_holes);
        if (t > 0.0 && t < nearest && all(abs(at) <= vec3f(0.5 + OVERLAP)) && (there & square_at(at, sheet.axis)) != 0
            && !(sheet.ends && has_ended(slot, sheet.axis, at))) {
            let of_left = t < NEAR && is_of(normal, dot(normal, centre) + sheet.height, ray.left);
            let of_goal = ray.reach - t < NEAR && is_of(normal, dot(normal, centre) + sheet.height, ray.goal);
            // Where a mean plane lies over the surface itself, a ray begins behind it, and leaves by its back.
            let behind = !shown && t < 1.0;
            if (!of_left && !of_goal && !behind) {
                nearest = t;
                let number = side_number(words.y, from_behind);
                *hit = RayHit(true, t, cell, select(normal, -normal, towards > 0.0), SIDES * slot + number, shown);
            }
        }
        if ((words.y & MORE) == 0) {
            break;
        }
    }
    return nearest < ray.reach;
}
