// An image of twice the size: each texel is the mean over the four coarse ones around it, those weighing most that show what it
// shows (joint bilateral upsampling, Kopf et al. 2007; VGI §5.1 brings its light to the screen's size so).

import package::common::guide::{GUIDE_PLANE, Guide, unpack_guide};

var image: texture_storage_2d_array<rgba16float, write>;
var gathered: texture_2d_array<f32>;
var guide: texture_2d_array<f32>;
var coarse_guide: texture_2d_array<f32>;

// Whether the second half of the coarse layers holds from where the light of the first half's comes.
override LEANS: bool = false;

// How fast weights fall as normals turn apart: to a half at 21°.
const NORMAL_POWER = 10.0;
// At most so much more or less: where normals differ much, the vector is a guess.
const MOST = 1.5;
// Where none of the four shows the same surface, the one that comes nearest to it stands for all.
const LEAST = 1e-6;

// One of the four coarse texels.
struct Near {
    guide: Guide,
    value: vec4f,
    leaning: vec4f,
}

fn near_at(texel: vec2i, layer: u32, leans: bool) -> Near {
    var near: Near;
    near.guide = unpack_guide(textureLoad(coarse_guide, texel, 0, 0));
    near.value = textureLoad(gathered, texel, layer, 0);
    if (leans) {
        near.leaning = textureLoad(gathered, texel, layer + textureNumLayers(gathered) / 2, 0);
    }
    return near;
}

fn mean_at(pixel: vec2u, share: vec2f, near: ptr<function, array<Near, 4>>, leans: bool) -> vec4f {
    let own = unpack_guide(textureLoad(guide, pixel, 0, 0));
    var sum = vec4f(0.0);
    var weight = 0.0;
    for (var i = 0u; own.hit && i < 4; i++) {
        let other = (*near)[i].guide;
        let linear = select(1.0 - share, share, vec2u(i & 1, i >> 1) == vec2u(1));
        let distance = dot(other.position - own.position, own.normal) / GUIDE_PLANE;
        let alike = exp2(-4.0 * distance * distance) * pow(max(dot(other.normal, own.normal), 0.0), NORMAL_POWER);
        let w = select(0.0, linear.x * linear.y * max(alike, LEAST), other.hit);
        var value = (*near)[i].value;
        if (leans) {
            // As much more as arrives at the finer normal. What another surface gets says nothing of that.
            let leaning = (*near)[i].leaning;
            let there = dot(leaning, vec4f(other.normal, 1.0));
            let more = clamp(dot(leaning, vec4f(own.normal, 1.0)) / max(there, 1e-6), 1.0 / MOST, MOST);
            value = vec4f(value.rgb * select(1.0, more, alike > LEAST && any(leaning != vec4f(0.0))), value.a);
        }
        sum += w * value;
        weight += w;
    }
    return sum / max(weight, 1e-12);
}

// A thread for the up to four texels between the same four coarse ones.
@compute @workgroup_size(8, 8)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let size = textureDimensions(image);
    let last = vec2i(textureDimensions(coarse_guide)) - 1;
    let low = vec2i(id.xy) - 1;
    if (any(2 * low + 1 >= vec2i(size))) {
        return;
    }
    // The layers of leanings are brought up as they are.
    let leans = LEANS && id.z < textureNumLayers(gathered) / 2;
    var near: array<Near, 4>;
    for (var i = 0; i < 4; i++) {
        near[i] = near_at(clamp(low + vec2i(i & 1, i >> 1), vec2i(0), last), id.z, leans);
    }
    for (var i = 0; i < 4; i++) {
        let pixel = 2 * low + 1 + vec2i(i & 1, i >> 1);
        if (all(pixel >= vec2i(0)) && all(pixel < vec2i(size))) {
            // Where its middle lies between the coarse ones'.
            let share = select(vec2f(0.25), vec2f(0.75), vec2i(i & 1, i >> 1) == vec2i(1));
            textureStore(image, pixel, id.z, mean_at(vec2u(pixel), share, &near, leans));
        }
    }
}
