// What `six_face` leaves open.

// Level 0: one value for all faces, or by the normal.
override BASE: u32 = 0;
const BASE_ISOTROPIC = 0u;
// All of it on the face that the normal is nearest to.
const BASE_DOMINANT = 1u;
// The squares of the normal's components (DVS §3), which sum to 1.
const BASE_WEIGHTED = 2u;
// The cosine between normal and face: what an observer there sees of the surface.
const BASE_COSINE = 3u;

// Faces of a directional level 0 that the normal gives nothing.
override EMPTY: u32 = 0;
// Transparent.
const EMPTY_CLEAR = 0u;
// Opaque, without light.
const EMPTY_BLACK = 1u;
// As an isotropic voxel has them.
const EMPTY_FILL = 2u;
