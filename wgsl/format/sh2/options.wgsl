// What `sh2` leaves open.

// Level 0: one value for all directions, or the coefficients of a one-sided emitter.
override BASE: u32 = 0;
const BASE_ISOTROPIC = 0u;
const BASE_LOBE = 1u;

// A parent: what its sides show, the mean of its children's coefficients, or of what they send through its faces.
override MIP: u32 = 0;
const MIP_COMPOSITED = 0u;
const MIP_LINEAR = 1u;
const MIP_PROJECTED = 2u;

// Radiance from a direction: what the sides towards it show, or the two bands' sum there. That may be below zero, which is cut off,
// or avoided by less of band 1.
override NEGATIVES: u32 = 0;
const NEGATIVES_SIDES = 0u;
const NEGATIVES_CLAMP = 1u;
const NEGATIVES_WINDOW = 2u;
