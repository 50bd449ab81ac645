// The six faces stand one above the other along z in one texture: +x, −x, +y, −y, +z, −z.
// face[+x] is what an observer at +x sees.

const FACES = 6u;

fn face_of(axis: u32, negative: bool) -> u32 {
    return 2 * axis + select(0u, 1u, negative);
}
