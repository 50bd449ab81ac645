//! The occupied cells of a level, read back from the device.

use voxlume::Renderer;

use voxlume_measure::channel_shows;
use voxlume_measure::picture::visible;

use crate::failure::Failure;

/// An occupied cell.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cell {
    /// Along x, y, z from the grid's lowest corner, in cells of its level.
    pub place: [u32; 3],
    /// For the eye.
    pub color: [u8; 3],
    /// Unit, or zero where opposite surfaces cancel.
    pub normal: [f32; 3],
}

/// The occupied cells of a level.
#[derive(Debug)]
pub struct Cells {
    /// The level.
    pub level: u32,
    /// In the order of the device's list.
    pub list: Vec<Cell>,
}

impl Cells {
    /// Reads what the last frame showed. `scale` multiplies light.
    pub fn read(renderer: &Renderer<'_>, level: u32, channel: &str, scale: f32) -> Result<Cells, Failure> {
        // `struct LevelRun` in wgsl/common/grid.wgsl takes eight words, `struct ShownVoxel` four.
        let levels = words(renderer, "levels")?;
        let at = level as usize * 8 + 3;
        let (first, count) = (levels[at] as usize, levels[at + 1] as usize);
        let cells = words(renderer, "cells")?;
        let shown = words(renderer, "shown_voxels")?;
        let run = first..first + count;
        let list = cells[run.clone()].iter().zip(shown[run.start * 4..run.end * 4].chunks_exact(4));
        let list = list.map(|(cell, shown)| Cell {
            place: [cell & 1023, cell >> 10 & 1023, cell >> 20],
            color: visible(channel_shows(channel), [0, 1, 2].map(|i| f32::from_bits(shown[i])), scale),
            normal: normal(shown[3]),
        });
        Ok(Cells { level, list: list.collect() })
    }
}

/// A buffer of the plan.
pub fn bytes(renderer: &Renderer<'_>, name: &str) -> Result<Vec<u8>, Failure> {
    renderer.buffer(name)?.ok_or_else(|| Failure::work(format!("the plan has no `{name}`")))
}

pub fn words(renderer: &Renderer<'_>, name: &str) -> Result<Vec<u32>, Failure> {
    Ok(bytes(renderer, name)?.chunks_exact(4).map(|b| u32::from_le_bytes([b[0], b[1], b[2], b[3]])).collect())
}

/// The inverse of `pack_shown_normal` in wgsl/pass/shown_voxel.wgsl.
fn normal(bits: u32) -> [f32; 3] {
    if bits == 0x8000_8000 {
        return [0.0; 3];
    }
    let [x, y] = [bits as u16 as i16, (bits >> 16) as u16 as i16].map(|v| (f32::from(v) / 32767.0).max(-1.0));
    let v = glam::Vec3::new(x, y, 1.0 - x.abs() - y.abs());
    let t = (-v.z).max(0.0);
    let fold = |c: f32| if c >= 0.0 { c - t } else { c + t };
    glam::Vec3::new(fold(v.x), fold(v.y), v.z).normalize().to_array()
}
