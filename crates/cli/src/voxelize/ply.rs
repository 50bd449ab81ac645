//! Voxels as points: the Stanford polygon format, binary little endian.

use voxlume::Grid;

use super::cells::Cells;

/// The whole file: cells' centres in the world, normals, colours.
pub fn encode(cells: &Cells, grid: &Grid) -> Vec<u8> {
    let size = f64::from(grid.voxel_size) * f64::from(1u32 << cells.level);
    // Coordinates in f64, as a scene may lie far from the world's origin.
    let head = format!(
        "ply\nformat binary_little_endian 1.0\n\
         comment voxels of level {}, each {size} wide\n\
         element vertex {}\n\
         property double x\nproperty double y\nproperty double z\n\
         property float nx\nproperty float ny\nproperty float nz\n\
         property uchar red\nproperty uchar green\nproperty uchar blue\n\
         end_header\n",
        cells.level,
        cells.list.len()
    );
    let mut bytes = head.into_bytes();
    let low = grid.centre + grid.min().as_dvec3();
    for cell in &cells.list {
        for (place, low) in cell.place.into_iter().zip(low.to_array()) {
            bytes.extend((low + (f64::from(place) + 0.5) * size).to_le_bytes());
        }
        cell.normal.iter().for_each(|n| bytes.extend(n.to_le_bytes()));
        bytes.extend(cell.color);
    }
    bytes
}
