// A side of a voxel's surfaces, as light arrives at it.

import package::common::trace::Apex;

struct Side {
    // On the surface, its normal to the front.
    apex: Apex,
    // How much of the voxel's surfaces it is, beside the other sides' shares; 0 for none.
    share: f32,
    // How much of what arrives at its back counts as well: surfaces of two sides have one value for both.
    opposite: f32,
}

// A voxel's sides, at most.
const SIDES = 6u;
