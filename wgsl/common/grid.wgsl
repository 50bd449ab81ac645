// A voxel grid, and the layout of its bitmask: a word holds a brick of 4 x 4 x 2 cells, bricks run x, y, z within a
// level, levels follow each other, the finest first. `_voxel` positions count voxels from the grid's lowest corner.

struct Grid {
    // Lowest corner, world units relative to the scene's origin.
    min: vec3f,
    // World units.
    voxel_size: f32,
    // Voxels along x, y, z.
    size: vec3u,
    level_count: u32,
    // Fixed-point units per 1.0 of an attribute; chosen so that no sum can overflow.
    attribute_scale: f32,
    // Emission that counts as 1.0, W·m⁻²·sr⁻¹.
    emission_max: f32,
    // Words of the bitmask of all levels: those of columns follow, where there are any.
    bitmask_words: u32,
    padding: u32,
    // First word of each level in the occupancy bitmask, four levels a vector.
    level_words: array<vec4u, 4>,
}

var<uniform> grid: Grid;

fn to_voxel(position: vec3f) -> vec3f {
    return (position - grid.min) / grid.voxel_size;
}

fn from_voxel(p_voxel: vec3f) -> vec3f {
    return grid.min + p_voxel * grid.voxel_size;
}

// How far over a plane of this normal the cells that it touches reach, in voxels.
fn cell_height(normal: vec3f) -> f32 {
    return abs(normal.x) + abs(normal.y) + abs(normal.z);
}

fn longest_side() -> f32 {
    return f32(max(grid.size.x, max(grid.size.y, grid.size.z)));
}

// One level's run in the list of cells, and the workgroups of 64 that cover it.
struct LevelRun {
    groups: vec3u,
    first: u32,
    count: u32,
}

fn level_size(level: u32) -> vec3u {
    return grid.size >> vec3u(level);
}

fn brick_count(level: u32) -> vec3u {
    return (level_size(level) + vec3u(3, 3, 1)) / vec3u(4, 4, 2);
}

// The brick of a level's word number `index`.
fn brick_at(index: u32, level: u32) -> vec3u {
    let bricks = brick_count(level);
    return vec3u(index % bricks.x, index / bricks.x % bricks.y, index / (bricks.x * bricks.y));
}

fn level_first_word(level: u32) -> u32 {
    return grid.level_words[level / 4][level % 4];
}

// Cells along a brick's sides as powers of two, and how far apart their bits are.
const BRICK_SHIFT = vec3u(2, 2, 1);
const BRICK_BITS = vec3u(1, 4, 16);

// Words from a brick to the next along each axis.
fn brick_strides(level: u32) -> vec3u {
    let bricks = brick_count(level);
    return vec3u(1, bricks.x, bricks.x * bricks.y);
}

fn cell_word(cell: vec3u, level: u32) -> u32 {
    return level_first_word(level) + dot(cell >> BRICK_SHIFT, brick_strides(level));
}

fn cell_bit(cell: vec3u) -> u32 {
    return dot(cell & vec3u(3, 3, 1), BRICK_BITS);
}

fn bit_offset(bit: u32) -> vec3u {
    return vec3u(bit & 3, (bit >> 2) & 3, bit >> 4);
}

fn pack_cell(cell: vec3u) -> u32 {
    return cell.x | (cell.y << 10) | (cell.z << 20);
}

fn unpack_cell(packed_cell: u32) -> vec3u {
    return vec3u(packed_cell & 1023, (packed_cell >> 10) & 1023, packed_cell >> 20);
}
