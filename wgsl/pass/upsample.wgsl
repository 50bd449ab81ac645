// An image of twice the size: each texel is the mean over the four coarse ones around it, those weighing most that show what it
// shows (joint bilateral upsampling, Kopf et al. 2007; VGI §5.1 brings its light to the screen's size so).

import package::common::guide::{GUIDE_PLANE, unpack_guide};

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

@compute @workgroup_size(8, 8)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let size = textureDimensions(image);
    if (any(id.xy >= size)) {
        return;
    }
    let own = unpack_guide(textureLoad(guide, id.xy, 0, 0));
    let last = vec2i(textureDimensions(coarse_guide)) - 1;
    // Where the texel's middle lies between the coarse ones'.
    let at = (vec2f(id.xy) + 0.5) * 0.5 - 0.5;
    let low = floor(at);
    let share = at - low;
    var sum = vec4f(0.0);
    var weight = 0.0;
    for (var i = 0; own.hit && i < 4; i++) {
        let corner = vec2i(i & 1, i >> 1);
        let texel = clamp(vec2i(low) + corner, vec2i(0), last);
        let other = unpack_guide(textureLoad(coarse_guide, texel, 0, 0));
        let linear = select(1.0 - share, share, corner == vec2i(1));
        let distance = dot(other.position - own.position, own.normal) / GUIDE_PLANE;
        let alike = exp2(-4.0 * distance * distance) * pow(max(dot(other.normal, own.normal), 0.0), NORMAL_POWER);
        let w = select(0.0, linear.x * linear.y * max(alike, LEAST), other.hit);
        var value = textureLoad(gathered, texel, id.z, 0);
        let half = textureNumLayers(gathered) / 2;
        if (LEANS && id.z < half) {
            // As much more as arrives at the finer normal, of what came from there.
            let vector = textureLoad(gathered, texel, id.z + half, 0).xyz;
            let there = max(dot(vector, other.normal), 1e-6);
            value = vec4f(value.rgb * clamp(dot(vector, own.normal) / there, 1.0 / MOST, MOST), value.a);
        }
        sum += w * value;
        weight += w;
    }
    textureStore(image, id.xy, id.z, sum / max(weight, 1e-12));
}
