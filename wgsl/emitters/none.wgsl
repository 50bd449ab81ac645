// No emissive polygon is asked by itself: emission comes from voxels or from lights, or there is none.

import package::common::trace::{Apex, Arriving};

const SAMPLED = false;

fn emitters_irradiance(apex: Apex, normal: vec3f, rays: u32) -> Arriving {
    return Arriving(vec3f(0.0), vec3f(0.0));
}
