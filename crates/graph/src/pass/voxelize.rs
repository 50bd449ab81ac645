//! Voxelization: occupancy, ranks, the list of cells, attributes.

use std::ops::Range;

use super::{ParamWords, PassKind, Port, VOXELS, Values};
use crate::expansion::{Expansion, LEVEL_RUN_BYTES, Over, Run, groups_for, step_params};
use crate::grid::Grid;
use crate::plan::{ResourceKind, Target, Vertices};

/// See [`PassKind::sentence`].
#[derive(Debug)]
pub(crate) struct Voxelize;

/// The word for the method of a pass that doesn't say.
pub const DEFAULT_METHOD: &str = "balanced";

/// Voxel² of projected area up to which `hybrid` has a thread walk a triangle.
const CUTOFF: f64 = 4.0;

/// Rows of the largest grid: a band has at least one.
const MOST_BANDS: u32 = *Grid::RESOLUTIONS.end();

/// Words of the bitmask that a thread of wgsl/pass/list.wgsl looks at.
const LISTED_WORDS: u32 = 16;

/// Words of the triangles that a voxel's sides show: see wgsl/common/front.wgsl.
const FRONT_STRIDE: u32 = 6 * 4 + 6;

/// Entries of 8 bytes for a voxel's sheets, the materials of its sides and, where voxels keep it, what they emit: see
/// wgsl/common/sheet.wgsl.
fn sheet_entries(emission: bool) -> u32 {
    6 + if emission { 6 } else { 3 }
}

/// Voxels. A triangle with shorter edges is less than 39.1 voxel² large and 11.5 voxels wide and high: together less than
/// 64 columns, the least for two bands in wgsl/common/bands.wgsl.
const EDGE_OF_TWO_BANDS: f64 = 9.5;

impl PassKind for Voxelize {
    fn name(&self) -> &str {
        "voxelize"
    }

    fn sentence(&self) -> &str {
        "finds the voxels that triangles overlap and sums their attributes"
    }

    fn writes(&self) -> &[Port] {
        const PORTS: &[Port] = &[VOXELS];
        PORTS
    }

    fn words(&self) -> &[ParamWords] {
        const WORDS: &[ParamWords] = &[
            ParamWords {
                name: "method",
                sentence: "who walks a triangle's voxels; the voxels are the same; `balanced` unless given",
                values: Values::Words(&["triangle", "fragment", "hybrid", "balanced"]),
            },
            ParamWords {
                name: "cutoff",
                sentence: "voxel² of projected area up to which `hybrid` has a thread walk a triangle; 4 unless given",
                values: Values::Number(0.0, 1e9),
            },
            ParamWords {
                name: "coverage",
                sentence: "opacity of a voxel: 1, or the area that triangles cover of its face; `binary` unless given",
                values: Values::Words(&["binary", "area"]),
            },
            ParamWords {
                name: "conflict",
                sentence: "a voxel's reflectance where triangles meet: their mean, the largest packed word, or a mean \
                           that depends on the order; `sum` unless given",
                values: Values::Words(&["sum", "max", "running_average"]),
            },
            ParamWords {
                name: "walk",
                sentence: "what rays walk through: cells, leaping over what is empty, coarser cells, or columns of bits along \
                           z (VGI §4); what they meet is the same; `leaps` unless given",
                values: Values::Words(&["leaps", "bricks", "columns"]),
            },
            ParamWords {
                name: "resolution",
                sentence: "voxels along the longest side of a grid of its own; the pipeline's grid unless given",
                values: Values::Whole(*Grid::RESOLUTIONS.start(), *Grid::RESOLUTIONS.end()),
            },
            ParamWords {
                name: "min",
                sentence: "lowest corner of a grid of its own, world units; with `resolution` and `max`",
                values: Values::Point,
            },
            ParamWords {
                name: "max",
                sentence: "highest corner of a grid of its own, world units",
                values: Values::Point,
            },
        ];
        WORDS
    }

    fn expand(&self, pass: &mut Expansion<'_, '_>) {
        let coverage = pass.word_or("coverage", "binary") == Some("area");
        let conflict = pass.word_or("conflict", "sum").unwrap_or_default();
        if pass.begin_grid().is_none() {
            return;
        }
        let Some(method) = method(pass) else { return };
        let walk = match pass.word_or("walk", "leaps") {
            Some("columns") => Walk::Columns,
            Some("bricks") => Walk::Bricks,
            _ => Walk::Leaps,
        };
        let voxels = Voxels::new(pass, coverage, conflict, walk);
        voxels.steps(pass, method);
        if !pass.voxel_emission() {
            let why = match pass.facts().emissive {
                true => "what emits is lit as area lights",
                false => "no material emits",
            };
            pass.leaves_out("emission in voxels (12 bytes each)", why, 0);
        }
        let facts = pass.facts();
        let still = facts.triangles - facts.moving_triangles;
        match facts.moving_triangles {
            0 => pass.leaves_out("voxelizing every frame", "nothing moves", 0),
            _ if still > 0 => {
                pass.leaves_out(&format!("voxelizing {still} triangles every frame"), "they never move", 0);
            }
            _ => {}
        }
    }
}

/// Which thread walks which voxels: RAU §4.1.1 to §4.1.3, and bands of rows of columns as everybody's work.
#[derive(Clone, Copy, PartialEq)]
enum Method {
    /// A thread a triangle.
    Triangle,
    /// A fragment a column.
    Fragment,
    /// A thread a triangle up to so many voxel² of projected area, fragments for the rest.
    Hybrid(f64),
    /// A thread a triangle of one band, a thread a band for the rest.
    Balanced,
}

fn method(pass: &mut Expansion<'_, '_>) -> Option<Method> {
    let word = pass.word_or("method", DEFAULT_METHOD);
    let cutoff = pass.number_or("cutoff", CUTOFF)?;
    Some(match word? {
        "triangle" => Method::Triangle,
        "fragment" => Method::Fragment,
        "hybrid" => Method::Hybrid(cutoff),
        _ if is_fine(pass) => Method::Triangle,
        _ => Method::Balanced,
    })
}

/// Whether no triangle has two bands.
fn is_fine(pass: &mut Expansion<'_, '_>) -> bool {
    let longest = pass.facts().longest_edge / f64::from(pass.grid().voxel_size);
    let fine = longest < EDGE_OF_TWO_BANDS;
    if fine {
        let bytes = u64::from(pass.facts().triangles + 1) * 4;
        let why = format!("no edge is longer than {longest:.1} voxels");
        pass.leaves_out("bands of large triangles", &why, bytes);
    }
    fine
}

/// A buffer of so many words.
fn words(count: u32) -> ResourceKind {
    ResourceKind::Buffer(u64::from(count) * 4)
}

/// What rays walk through, as far as it is more than the bitmask: it follows the bitmask in its buffer.
#[derive(Clone, Copy)]
enum Walk {
    /// How far blocks of cells are from occupied ones, and what an axis before the last finds.
    Leaps,
    /// Nothing.
    Bricks,
    /// Columns of bits.
    Columns,
}

impl Walk {
    fn module(self) -> &'static str {
        match self {
            Walk::Leaps => "walk/leaps",
            Walk::Bricks => "walk/bricks",
            Walk::Columns => "walk/columns",
        }
    }

    fn steps(self, pass: &mut Expansion<'_, '_>, grid: &Grid) {
        match self {
            Walk::Leaps => {
                for axis in ["along_x", "along_y", "along_z"] {
                    let groups = groups_for(grid.leap_words(), 64);
                    pass.run("pass/leaps").entry(axis).over(Over::Groups(groups));
                }
            }
            Walk::Bricks => {}
            Walk::Columns => {
                for (level, words) in (0..).zip(grid.column_words()) {
                    pass.run("pass/columns")
                        .reads("step_params", step_params(level))
                        .over(Over::Groups(groups_for(words, 64)));
                }
            }
        }
    }
}

/// The buffers that voxels are.
#[derive(Clone, Copy)]
struct Voxels {
    occupancy: usize,
    ranks: usize,
    attributes: usize,
    /// Which triangles a voxel's sides show.
    fronts: usize,
    /// Words of a voxel's attributes.
    stride: u32,
    /// Words of the bitmask of all levels.
    all: u32,
    walk: Walk,
}

impl Voxels {
    fn new(pass: &mut Expansion<'_, '_>, coverage: bool, conflict: &'static str, walk: Walk) -> Voxels {
        let triangles = pass.facts().triangles;
        let (_, all) = pass.grid().word_offsets();
        let level_bytes = u64::from(pass.grid().levels()) * LEVEL_RUN_BYTES;
        let stride = attribute_stride(pass.voxel_emission(), coverage);
        let entries = sheet_entries(pass.voxel_emission());
        let walk_words = match walk {
            Walk::Leaps => 2 * pass.grid().leap_words(),
            Walk::Bricks => 0,
            Walk::Columns => pass.grid().column_words().iter().sum(),
        };
        let mut bundle = pass.grid_bundle();
        bundle.mount("walk", walk.module());
        let mut part = |name: &str, kind| {
            let resource = pass.part("voxels", name, kind);
            bundle.add(name, Target::Resource(resource));
            resource
        };
        let occupancy = part("occupancy", words(all + walk_words));
        let ranks = part("ranks", words(all + 1));
        let levels = part("levels", ResourceKind::Buffer(level_bytes));
        part("scan_runs", words((all + 1).max(triangles + 1).div_ceil(64)));
        part("cells", ResourceKind::PerCell(4));
        let attributes = part("attributes", ResourceKind::PerVoxel(u64::from(stride) * 4));
        let fronts = part("fronts", ResourceKind::PerVoxel(u64::from(FRONT_STRIDE) * 4));
        part("sheets", ResourceKind::PerVoxel(u64::from(entries) * 8));
        bundle.with("ATTRIBUTE_STRIDE", f64::from(stride));
        bundle.with("HAS_COVERAGE", f64::from(u8::from(coverage)));
        bundle.with("SHEET_ENTRIES", f64::from(entries));
        bundle.with("TRIANGLE_BITS", f64::from(triangle_bits(triangles)));
        bundle.with_word("CONFLICT", conflict);
        pass.makes(bundle);
        pass.counts_cells(levels);
        Voxels { occupancy, ranks, attributes, fronts, stride, all, walk }
    }

    fn steps(&self, pass: &mut Expansion<'_, '_>, method: Method) {
        let Voxels { occupancy, ranks, all, .. } = *self;
        let (triangles, moving) = (pass.facts().triangles, pass.facts().moving_triangles);
        let still = triangles - moving;
        let divided = moving > 0 && still > 0;
        let fixed = divided.then(|| self.still(pass, method));
        match fixed {
            Some(fixed) => pass.copy(fixed.occupancy, occupancy),
            None => pass.clear(occupancy),
        }
        let first = if divided { still } else { 0 };
        let part = Part { method, triangles: first..triangles, targets: Vec::new() };
        visit(pass, &part, "visitor/occupancy", true);
        let grid = pass.grid().clone();
        for level in 1..grid.levels() {
            pass.run("pass/hierarchy")
                .reads("step_params", step_params(level))
                .over(Over::Groups(groups_for(grid.level_words(level), 64)));
        }
        self.walk.steps(pass, &grid);
        scan(pass, &[], ranks, all + 1, true);
        pass.run("pass/level_runs").over(Over::Groups([1, 1, 1]));
        pass.counted();
        pass.run("pass/list")
            .with("WORDS", LISTED_WORDS)
            .over(Over::Groups(groups_for(all, 64 * LISTED_WORDS)));
        for (index, (sums, stride)) in self.sums().into_iter().enumerate() {
            match &fixed {
                Some(fixed) => pass
                    .run("pass/static_sums")
                    .reads("static_occupancy", Target::Resource(fixed.occupancy))
                    .reads("static_ranks", Target::Resource(fixed.ranks))
                    .reads("static_sums", Target::Resource(fixed.sums()[index].0))
                    .writes("sums", Target::Resource(sums))
                    .with("STRIDE", stride)
                    .over(Over::Cells(0)),
                None => pass.clear(sums),
            }
        }
        visit(pass, &part, "visitor/attributes", false);
        pass.run("pass/sheets")
            .reads("triangle_range", triangle_range(&(0..triangles), 0))
            .over(Over::Cells(0));
    }

    /// What triangles leave in each voxel, with the words of each.
    fn sums(&self) -> [(usize, u32); 2] {
        [(self.attributes, self.stride), (self.fronts, FRONT_STRIDE)]
    }

    /// Voxelizes what never moves by itself, once (DVS §1.2). Sums are integers: adding what moves to these gives the
    /// same bits as adding everything anew.
    fn still(&self, pass: &mut Expansion<'_, '_>, method: Method) -> Voxels {
        let finest = pass.grid().level_words(0);
        let occupancy = pass.part("voxels", "static_occupancy", words(finest));
        let ranks = pass.part("voxels", "static_ranks", words(finest + 1));
        // At most as many voxels as there are in all.
        let kind = ResourceKind::PerVoxel(u64::from(self.stride) * 4);
        let attributes = pass.part("voxels", "static_attributes", kind);
        let kind = ResourceKind::PerVoxel(u64::from(FRONT_STRIDE) * 4);
        let fronts = pass.part("voxels", "static_fronts", kind);
        let fixed = Voxels {
            occupancy,
            ranks,
            attributes,
            fronts,
            stride: self.stride,
            all: finest,
            walk: Walk::Bricks,
        };
        let targets =
            [("occupancy", occupancy), ("ranks", ranks), ("attributes", attributes), ("fronts", fronts)];
        let targets = targets.map(|(name, resource)| (name.to_owned(), Target::Resource(resource))).to_vec();
        let still = pass.facts().triangles - pass.facts().moving_triangles;
        let part = Part { method, triangles: 0..still, targets };
        pass.clear(occupancy);
        visit(pass, &part, "visitor/occupancy", true);
        scan(pass, &part.targets, ranks, finest + 1, true);
        pass.counted();
        fixed.sums().into_iter().for_each(|(sums, _)| pass.clear(sums));
        visit(pass, &part, "visitor/attributes", false);
        pass.once();
        fixed
    }
}

/// Words of a voxel's attributes: two weights, reflectance, two of normals, emission if there is any, and the area covered
/// if it counts.
pub(crate) fn attribute_stride(emission: bool, coverage: bool) -> u32 {
    11 + if emission { 3 } else { 0 } + u32::from(coverage)
}

/// Triangles, and how and into what they are voxelized.
struct Part {
    method: Method,
    triangles: Range<u32>,
    /// What stands for `occupancy`, `ranks` and `attributes`, where it isn't the scene's own.
    targets: Vec<(String, Target)>,
}

/// Triangles of a part, with an alpha mask or without.
struct Class {
    method: Method,
    triangles: Range<u32>,
    /// Buffer that says how much its triangles leave to others.
    items: usize,
    targets: Vec<(String, Target)>,
    masked: bool,
    /// Whether what triangles leave to others is counted.
    counts: bool,
}

/// Shows every overlapped voxel to a visitor; `first` counts what triangles leave to others. Triangles with an alpha mask
/// come last, and apart, so that the others need not look for one.
fn visit(pass: &mut Expansion<'_, '_>, part: &Part, visitor: &str, first: bool) {
    let Range { start, end } = part.triangles;
    let split = end - pass.facts().masked_in(&part.triangles);
    let deferred = matches!(part.method, Method::Hybrid(_) | Method::Balanced);
    // As many as either the triangles that never move or those that may.
    let all = pass.facts().triangles;
    let ranks = deferred.then(|| pass.part("voxels", "item_ranks", words(all + 1)));
    let classes: Vec<Class> =
        [(start..split, false, "item_groups"), (split..end, true, "masked_item_groups")]
            .into_iter()
            .filter(|(triangles, ..)| !triangles.is_empty())
            .map(|(triangles, masked, groups)| {
                let items = pass.part("voxels", groups, ResourceKind::Buffer(16));
                let ranks = ranks.map_or(Target::Nothing, Target::Resource);
                let range = triangle_range(&triangles, triangles.start - start);
                let named = [
                    ("item_ranks", ranks.clone()),
                    ("item_counts", ranks),
                    ("item_groups", Target::Resource(items)),
                    ("triangle_range", range),
                ];
                let named = named.map(|(name, target)| (name.to_owned(), target));
                let targets = part.targets.iter().cloned().chain(named).collect();
                Class { method: part.method, triangles, items, targets, masked, counts: first }
            })
            .collect();
    if part.method != Method::Fragment {
        for class in &classes {
            let groups = groups_for(class.triangles.end - class.triangles.start + 1, 64);
            class.run(pass, "pass/voxelize_triangles").mount("visitor", visitor).over(Over::Groups(groups));
        }
    }
    if let (true, Some(ranks)) = (first, ranks) {
        scan(pass, &[], ranks, end - start + 1, false);
        for class in &classes {
            class.run(pass, "pass/item_dispatch").over(Over::Groups([1, 1, 1]));
        }
    }
    for class in &classes {
        let (resource, offset) = (class.items, 0);
        match part.method {
            Method::Triangle => {}
            Method::Balanced => class
                .run(pass, "pass/voxelize_bands")
                .mount("visitor", visitor)
                .over(Over::Indirect { resource, offset }),
            Method::Hybrid(_) => class.draw(pass, visitor, Vertices::Indirect { resource, offset }),
            Method::Fragment => {
                let count = class.triangles.end - class.triangles.start;
                class.draw(pass, visitor, Vertices::Fixed(3 * count));
            }
        }
    }
}

impl Class {
    fn run<'e, 'c, 'a>(&self, pass: &'e mut Expansion<'c, 'a>, module: &str) -> Run<'e, 'c, 'a> {
        let (defer, cutoff) = match self.method {
            Method::Triangle | Method::Fragment => (0.0, CUTOFF),
            Method::Balanced => (1.0, CUTOFF),
            Method::Hybrid(cutoff) => (2.0, cutoff),
        };
        let triangles = pass.facts().triangles;
        pass.run(module)
            .writes_all(&self.targets)
            .with("HAS_ALPHA_MASK", self.masked)
            .with("MOST_BANDS", most_bands(triangles))
            .with("DEFER", defer)
            .with("CUTOFF", cutoff)
            .with("COUNTS", self.counts)
            .with("DRAWN", self.method != Method::Balanced)
            .with("DEFERRED", defer != 0.0)
    }

    fn draw(&self, pass: &mut Expansion<'_, '_>, visitor: &str, vertices: Vertices) {
        let side = pass.grid().size.into_iter().max().unwrap_or(1);
        let target = pass.part("voxels", "columns", ResourceKind::Raster { side });
        self.run(pass, "pass/voxelize_fragments").mount("visitor", visitor).rasters(target, vertices);
    }
}

/// `TriangleRange` in wgsl/common/mesh.wgsl.
fn triangle_range(triangles: &Range<u32>, item_first: u32) -> Target {
    let words = [triangles.start, triangles.end - triangles.start, item_first, 0];
    Target::Uniform(words.iter().flat_map(|word| word.to_le_bytes()).collect())
}

/// So few bands of a triangle that those of all triangles can be counted in 32 bits.
fn most_bands(triangles: u32) -> u32 {
    (u32::MAX / triangles.max(1)).clamp(1, MOST_BANDS)
}

/// Bits of a triangle's number: so many that all have one, and so few that heights are packed in an `f32`'s precision.
fn triangle_bits(triangles: u32) -> u32 {
    (u32::BITS - triangles.leading_zeros()).max(8)
}

/// Exclusive prefix sum over so many values in place, or of the bitmask's words.
fn scan(pass: &mut Expansion<'_, '_>, targets: &[(String, Target)], values: usize, count: u32, bits: bool) {
    let runs = groups_for(count.div_ceil(64), 64);
    for (entry, groups) in [("reduce", runs), ("runs", [1, 1, 1]), ("apply", runs)] {
        let mut step = pass.run("pass/scan").entry(entry).writes("scan_values", Target::Resource(values));
        if !bits {
            step = step.reads("occupancy", Target::Nothing);
        }
        step.writes_all(targets).with("COUNTS_BITS", bits).over(Over::Groups(groups));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_count_of_bands_overflows() {
        assert_eq!(most_bands(262_267), MOST_BANDS);
        for triangles in [1, 1_048_575, 8_388_608, 11_000_000, u32::MAX] {
            assert!(
                u64::from(most_bands(triangles)) * u64::from(triangles) <= u64::from(u32::MAX),
                "{triangles}"
            );
        }
    }
}
