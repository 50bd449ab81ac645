// From where the light of an effect's texel comes. An effect that sets this has its values follow the finer normals when it is
// brought up from a lower resolution (see pass/upsample.wgsl).

// The irradiance's vector: what arrives at another normal is proportional to its product with it.
var<private> leaning: vec3f;
