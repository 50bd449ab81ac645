// A cone's geometry, and how it keeps clear of the surface that it leaves and of the one that it runs up to.

import package::common::grid::grid;
import package::common::trace::{Apex, Reach};

// A cell that a surface passes is opaque throughout, along the surface too: neighbours of the apex stand a cell high,
// and show up in cells that just clear the apex's plane. So cells are narrower than the clearance by this factor. With 1,
// diffuse light of `isotropic` in the Cornell box is 5 points of its mean brighter.
const EDGEWISE = 0.5;

struct Cone {
    origin: vec3f,
    // Unit.
    direction: vec3f,
    // Sine of half the aperture, [0, 1].
    half_sine: f32,
    // Distance along the axis at which it ends.
    reach: f32,
    // The widest cell that doesn't reach back to the surface that the cone leaves: at the origin, and its
    // growth along the axis.
    clearance: f32,
    clearance_growth: f32,
    // Likewise for what it ends at: growth with the distance from the end.
    end_growth: f32,
}

// How far over a surface of this normal a linear filter over cells of size 1 still finds it: the topmost cell that
// the surface touches has its centre at most |n|₁/2 over it, and the filter reaches |n|₁ further.
fn filter_reach(normal: vec3f) -> f32 {
    return 1.5 * (abs(normal.x) + abs(normal.y) + abs(normal.z));
}

// A cone begins as far over its surface as the filter at level 0 reaches, times `start`, and ends before the filter
// finds the surface that it runs up to.
fn cone_of(apex: Apex, start: f32, direction: vec3f, half_sine: f32, reach: Reach) -> Cone {
    let lift = filter_reach(apex.normal);
    let growth = max(dot(apex.normal, direction), 0.0) / lift;
    let origin = apex.position + apex.normal * (lift * start);
    if (all(reach.normal == vec3f(0.0))) {
        // In this order: where the end of a loop is a uniform less something, Mesa 22.3's software device crashes.
        let end = -lift * start + reach.distance;
        return Cone(origin, direction, half_sine, end, start, growth, 1.0);
    }
    let end_lift = filter_reach(reach.normal);
    let cosine = max(-dot(reach.normal, direction), 1e-4);
    let end = (dot(origin - reach.point, reach.normal) - end_lift) / cosine;
    return Cone(origin, direction, half_sine, end, start, growth, cosine / end_lift);
}

// The widest level, whole, whose linear filter neither reaches back to the surface left nor on to the end.
fn clear_level(cone: Cone, t: f32) -> f32 {
    // The sample lies up to half a cell nearer to the end than t.
    let to_end = cone.end_growth * (cone.reach - t) / (1.0 + 0.5 * cone.end_growth);
    let clearance = EDGEWISE * min(to_end, cone.clearance + cone.clearance_growth * t);
    return floor(min(log2(max(clearance, 1.0)), f32(grid.level_count - 1)));
}
