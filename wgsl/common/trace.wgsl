// What every tracer is asked, and what it answers. Lengths are voxels of level 0.

// Of the directions that neighbours share out: which of how many sets. A trace's own set is spread over all of its lobe, and
// all sets together are spread evenly.
struct Share {
    index: u32,
    count: u32,
}

const WHOLE = Share(0, 1);

// Where the set lies among all, [0, 1).
fn turn_of(share: Share) -> f32 {
    return f32(share.index) / f32(share.count);
}

// Where a trace starts: on a surface, whose own voxels it must leave.
struct Apex {
    position: vec3f,
    // Unit, of the surface itself.
    normal: vec3f,
    share: Share,
}

// The directions that a trace covers, and the weight of each. What comes of them is a mean over the lobe.
struct Lobe {
    shape: u32,
    // Unit: the middle of a cone, or the normal.
    axis: vec3f,
    // Unit, towards the viewer, for `LOBE_GGX`.
    view: vec3f,
    // `LOBE_CONE`: sine of half the aperture, [0, 1]. `LOBE_GGX`: perceptual roughness, [0, 1].
    width: f32,
}

// All directions within a cone alike.
const LOBE_CONE = 0u;
// The hemisphere over a normal, by the cosine with it.
const LOBE_HEMISPHERE = 1u;
// Mirror images of the view in GGX's visible normals, as far as they lie over the surface.
const LOBE_GGX = 2u;

fn cone_lobe(direction: vec3f, half_sine: f32) -> Lobe {
    return Lobe(LOBE_CONE, direction, vec3f(0.0), half_sine);
}

fn hemisphere_lobe(normal: vec3f) -> Lobe {
    return Lobe(LOBE_HEMISPHERE, normal, vec3f(0.0), 1.0);
}

fn ggx_lobe(normal: vec3f, view: vec3f, roughness: f32) -> Lobe {
    return Lobe(LOBE_GGX, normal, view, roughness);
}

// Where a trace ends.
struct Reach {
    // Along its direction.
    distance: f32,
    // A surface that the trace runs up to without meeting its voxels: a point and the unit normal. Without one the normal is zero.
    point: vec3f,
    normal: vec3f,
}

fn reach_of(distance: f32) -> Reach {
    return Reach(distance, vec3f(0.0), vec3f(0.0));
}

fn reach_up_to(point: vec3f, normal: vec3f) -> Reach {
    return Reach(1e30, point, normal);
}

// Of linear Rec. 709 radiance.
fn luminance(radiance: vec3f) -> f32 {
    return dot(radiance, vec3f(0.2126, 0.7152, 0.0722));
}

// The least cosine with its normal that a direction's share of the vector is divided by.
const LEAST_COSINE = 0.2;

// What a direction adds to the vector.
fn vector_of(lobe: Lobe, direction: vec3f, radiance: vec3f) -> vec3f {
    return direction * (luminance(radiance) / max(dot(lobe.axis, direction), LEAST_COSINE));
}

// Light that arrives at a surface, W·m⁻².
struct Arriving {
    irradiance: vec3f,
    // Its mean luminance · direction / cosine: see `Gathered`.
    vector: vec3f,
}

// What comes of a trace.
struct Gathered {
    // Mean radiance that arrives, W·m⁻²·sr⁻¹; where nothing is met, the sky's.
    radiance: vec3f,
    // Mean opacity of what is met, [0, 1].
    opacity: f32,
    // To the first that it meets; without any, the reach.
    distance: f32,
    // Of `LOBE_HEMISPHERE`: the mean of luminance · direction / cosine. Times the lobe's normal it is the mean luminance; times
    // another normal nearby, about what arrives there (the irradiance's vector).
    vector: vec3f,
    // Whether rays of `LOBE_GGX` looked for area lights, which `radiance` then holds by their share (see common/lamp.wgsl).
    met_lamps: bool,
}
