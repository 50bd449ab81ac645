// From where the light of an effect's texel comes. An effect that sets this has its values follow the finer normals when it is
// brought up from a lower resolution (see pass/upsample.wgsl).

// What arrives at a normal n is proportional to n · xyz + w: the irradiance's vector, and what falls on all normals alike.
var<private> leaning: vec4f;
