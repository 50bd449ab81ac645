// Columns of bits along z, behind the bitmask's words (VGI §4.1): at each level half as many along x and y, each the OR of its
// children, and always all of z. Columns run x, y within a level; levels follow each other, the finest first.

import package::common::grid::grid;

// Columns along x and y of a level.
fn column_count(level: u32) -> vec2u {
    return (grid.size.xy + (1u << level) - 1) >> vec2u(level);
}

// Words of a column.
fn column_words() -> u32 {
    return (grid.size.z + 31) / 32;
}

fn column_level_words(level: u32) -> u32 {
    let count = column_count(level);
    return count.x * count.y * column_words();
}

// The first word of a level.
fn column_level_first(level: u32) -> u32 {
    var first = grid.bitmask_words;
    for (var i = 0u; i < level; i++) {
        first += column_level_words(i);
    }
    return first;
}
