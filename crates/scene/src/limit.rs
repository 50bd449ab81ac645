//! What a scene may take, checked before it is allocated.

use std::fs::File;
use std::io::{ErrorKind, Read};
use std::path::Path;

use voxlume_fault::Fault;

/// Bytes that a scene's triangles (instanced) and decoded images may take together, 4 GiB; also the
/// largest file that is read.
pub const MEMORY_LIMIT: u64 = 4 << 30;

/// Bytes of a vertex: position, normal, tangent, texture coordinate, material.
pub(crate) const VERTEX_BYTES: u64 = 52;
/// Bytes of a triangle's indices.
pub(crate) const TRIANGLE_BYTES: u64 = 12;

/// What is left of [`MEMORY_LIMIT`].
pub(crate) struct Budget(u64);

impl Budget {
    pub(crate) fn new() -> Budget {
        Budget(MEMORY_LIMIT)
    }

    /// Takes `count` items of `bytes` each.
    pub(crate) fn take(&mut self, count: u64, bytes: u64) -> Result<(), Fault> {
        let left = count.checked_mul(bytes).and_then(|total| self.0.checked_sub(total));
        let over = || Fault::new(format!("the scene would take more than {} GiB", MEMORY_LIMIT >> 30));
        self.0 = left.ok_or_else(over)?;
        Ok(())
    }
}

/// Reads a whole file of at most [`MEMORY_LIMIT`].
pub(crate) fn read_file(path: &Path) -> Result<Vec<u8>, String> {
    let cannot = |e: std::io::Error| match e.kind() {
        ErrorKind::NotFound => format!("cannot read `{}`: no such file", path.display()),
        _ => format!("cannot read `{}`: {e}", path.display()),
    };
    let file = File::open(path).map_err(cannot)?;
    let mut bytes = Vec::with_capacity(file.metadata().map_err(cannot)?.len().min(MEMORY_LIMIT) as usize);
    file.take(MEMORY_LIMIT + 1).read_to_end(&mut bytes).map_err(cannot)?;
    if bytes.len() as u64 > MEMORY_LIMIT {
        return Err(format!("cannot read `{}`: larger than {} GiB", path.display(), MEMORY_LIMIT >> 30));
    }
    Ok(bytes)
}
