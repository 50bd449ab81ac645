//! Voxels as models of MagicaVoxel's (file version 150, with a scene graph).

use std::collections::{BTreeMap, HashMap};

use color_quant::NeuQuant;
use dot_vox::{Color, Dict, DotVoxData, Frame, Model, SceneNode, ShapeModel, Size, Voxel};

use super::cells::Cells;
use crate::failure::Failure;

/// Side of a model at most.
const MODEL: u32 = 256;
/// Colours of a palette; an index of 0 is no voxel.
const COLORS: usize = 255;

/// The whole file, of cells in a grid of `grid` voxels. MagicaVoxel's z points up, so that (x, y, z) is (x, −z, y) there.
pub fn encode(cells: &Cells, grid: [u32; 3]) -> Result<Vec<u8>, Failure> {
    let sides = grid.map(|n| (n >> cells.level).max(1));
    let (palette, index) = palette(cells);
    let mut models: BTreeMap<[u32; 3], Vec<Voxel>> = BTreeMap::new();
    for cell in &cells.list {
        let model = cell.place.map(|c| c / MODEL);
        let [x, y, z] = cell.place.map(|c| c % MODEL);
        let z = side(sides[2], model[2]) - 1 - z;
        let voxel = Voxel { x: x as u8, y: z as u8, z: y as u8, i: index[&cell.color] };
        models.entry(model).or_default().push(voxel);
    }
    let root = |child| transform(Dict::default(), child);
    // The root transform, a group, then a transform and a shape for each model.
    let children = (0..models.len() as u32).map(|i| 2 + 2 * i).collect();
    let mut scenes = vec![root(1), SceneNode::Group { attributes: Dict::default(), children }];
    for (id, model) in models.keys().enumerate() {
        let size: [u32; 3] = std::array::from_fn(|i| side(sides[i], model[i]));
        let low = model.map(|c| (c * MODEL) as i32);
        let [width, height, depth] = size.map(|n| n as i32);
        // A model is placed by its middle, rounded down.
        let middle = format!("{} {} {}", low[0] + width / 2, depth / 2 - low[2] - depth, low[1] + height / 2);
        let child = scenes.len() as u32 + 1;
        scenes.push(transform(Dict::from_iter([("_t".to_owned(), middle)]), child));
        let models = vec![ShapeModel { model_id: id as u32, attributes: Dict::default() }];
        scenes.push(SceneNode::Shape { attributes: Dict::default(), models });
    }
    let models = models.into_iter().map(|([x, y, z], voxels)| {
        let size = Size { x: side(sides[0], x), y: side(sides[2], z), z: side(sides[1], y) };
        Model { size, voxels }
    });
    let data = DotVoxData {
        version: 150,
        index_map: Vec::new(),
        models: models.collect(),
        palette,
        materials: Vec::new(),
        scenes,
        layers: Vec::new(),
    };
    let mut bytes = Vec::new();
    data.write_vox(&mut bytes)
        .map_err(|error| Failure::work(format!("cannot encode the voxels: {error}")))?;
    Ok(bytes)
}

/// Side of the model number `model` along an axis with `cells` cells.
fn side(cells: u32, model: u32) -> u32 {
    (cells - model * MODEL).min(MODEL)
}

fn transform(frame: Dict, child: u32) -> SceneNode {
    SceneNode::Transform { attributes: Dict::default(), frames: vec![Frame::new(frame)], child, layer_id: 0 }
}

/// At most 255 colours, and which of them stands for each that there is.
fn palette(cells: &Cells) -> (Vec<Color>, HashMap<[u8; 3], u8>) {
    let mut distinct: Vec<[u8; 3]> = cells.list.iter().map(|cell| cell.color).collect();
    distinct.sort_unstable();
    distinct.dedup();
    let color = |[r, g, b]: [u8; 3]| Color { r, g, b, a: 255 };
    if distinct.len() <= COLORS {
        let index = distinct.iter().enumerate().map(|(i, color)| (*color, i as u8)).collect();
        return (distinct.into_iter().map(color).collect(), index);
    }
    let rgba: Vec<u8> = distinct.iter().flat_map(|[r, g, b]| [*r, *g, *b, 255]).collect();
    let network = NeuQuant::new(1, COLORS, &rgba);
    let index = distinct.iter().map(|c| (*c, network.index_of(&[c[0], c[1], c[2], 255]) as u8)).collect();
    (network.color_map_rgb().chunks_exact(3).map(|c| color([c[0], c[1], c[2]])).collect(), index)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, clippy::panic)]
    use super::*;
    use crate::voxelize::cells::Cell;

    fn cells(list: &[([u32; 3], [u8; 3])]) -> Cells {
        let cell =
            |(place, color): &([u32; 3], [u8; 3])| Cell { place: *place, color: *color, normal: [0.0; 3] };
        Cells { level: 0, list: list.iter().map(cell).collect() }
    }

    /// Where each voxel lies in MagicaVoxel's world, and its colour.
    fn world(bytes: &[u8]) -> Vec<([i32; 3], [u8; 3])> {
        let data = dot_vox::load_bytes(bytes).unwrap();
        let placed = data.scenes[2..].chunks_exact(2).flat_map(|pair| {
            let [SceneNode::Transform { frames, .. }, SceneNode::Shape { models, .. }] = pair else {
                panic!()
            };
            let at = frames[0].position().unwrap();
            let model = &data.models[models[0].model_id as usize];
            let [x, y, z] = [model.size.x, model.size.y, model.size.z].map(|n| (n / 2) as i32);
            let low = [at.x - x, at.y - y, at.z - z];
            let palette = &data.palette;
            model.voxels.iter().map(move |v| {
                let color = palette[v.i as usize];
                let place = [low[0] + i32::from(v.x), low[1] + i32::from(v.y), low[2] + i32::from(v.z)];
                (place, [color.r, color.g, color.b])
            })
        });
        let mut placed: Vec<_> = placed.collect();
        placed.sort_unstable();
        placed
    }

    #[test]
    fn models_lie_where_their_voxels_belong() {
        let (red, blue) = ([255, 0, 0], [0, 0, 255]);
        let list = [([0, 0, 0], red), ([1, 2, 3], blue), ([300, 511, 256], red), ([0, 255, 300], blue)];
        let expected = |[x, y, z]: [u32; 3]| [x as i32, -1 - z as i32, y as i32];
        let mut placed: Vec<_> = list.iter().map(|(place, color)| (expected(*place), *color)).collect();
        placed.sort_unstable();
        assert_eq!(world(&encode(&cells(&list), [512; 3]).unwrap()), placed);
        // And in a grid whose last models are smaller, of an odd size.
        assert_eq!(world(&encode(&cells(&list), [301, 512, 301]).unwrap()), placed);
    }

    #[test]
    fn many_colours_become_255_that_are_near() {
        let list: Vec<_> =
            (0..1000).map(|i| ([i % 256, i / 256, 0], [(i / 4) as u8, 40, 200 - (i / 8) as u8])).collect();
        let found = world(&encode(&cells(&list), [256; 3]).unwrap());
        assert_eq!(found.len(), 1000);
        let expected: HashMap<_, _> =
            list.iter().map(|([x, y, z], c)| ([*x as i32, -1 - *z as i32, *y as i32], *c)).collect();
        for (place, color) in found {
            let off = color.iter().zip(expected[&place]).map(|(a, b)| a.abs_diff(b)).max();
            assert!(off.is_some_and(|off| off <= 8), "{color:?} for {:?}", expected[&place]);
        }
    }
}
