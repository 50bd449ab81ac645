// What `sh2` leaves open.

// Level 0: one value for all directions, or the coefficients of an emitter.
override BASE: u32 = 0;
const BASE_ISOTROPIC = 0u;
const BASE_LOBE = 1u;

// A parent: its children's mean, or what they send through its faces.
override MIP: u32 = 0;
const MIP_LINEAR = 0u;
const MIP_PROJECTED = 1u;

// Radiance below zero: cut off, or avoided by less of band 1.
override NEGATIVES: u32 = 0;
const NEGATIVES_CLAMP = 0u;
const NEGATIVES_WINDOW = 1u;
