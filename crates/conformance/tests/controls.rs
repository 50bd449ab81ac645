//! A suite that can't fail would prove nothing: break formats and twins on purpose and see it.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use std::sync::{Arc, OnceLock};

use glam::{DVec3, DVec4, UVec3};
use voxlume::twin::{Twin, Volumes};
use voxlume::{Choices, Encoding, Formats, Gpu, Library, Property, Source, StorageFormat};
use voxlume_conformance::{Bench, Content, SIDE, against_twin, are_bytes, run};

fn gpu() -> &'static Gpu {
    static GPU: OnceLock<Gpu> = OnceLock::new();
    GPU.get_or_init(|| Gpu::open(None).unwrap())
}

/// One of a twin's functions, a little wrong.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Break {
    Nothing,
    Store,
    Mipmap,
    Sample,
}

struct Broken<'t> {
    twin: &'t dyn Twin,
    part: Break,
    /// What a sample is multiplied by.
    sample: f64,
}

/// Three units in the last place of a half float.
const LITTLE: f64 = 1.0 + 3.0 / 1024.0;

/// A sample's, where bytes are filtered in bytes, three times: 6.1 steps.
const LITTLE_OF_BYTES: f64 = 1.0 + 3.0 * 6.1 / 255.0;

impl Twin for Broken<'_> {
    fn voxel_store(&self, volumes: &mut Volumes, cell: UVec3, radiance: DVec3, normal: DVec3, opacity: f64) {
        let radiance = if self.part == Break::Store { radiance * LITTLE } else { radiance };
        self.twin.voxel_store(volumes, cell, radiance, normal, opacity);
    }

    fn voxel_mipmap(&self, volumes: &mut Volumes, cell: UVec3, level: u32) {
        self.twin.voxel_mipmap(volumes, cell, level);
        if self.part == Break::Mipmap {
            for (volume, _) in volumes.volumes.clone().iter().enumerate().map(|(i, v)| (i, v.1.len())) {
                if volumes.volumes[volume].0.has_level(level, [SIDE; 3]) {
                    let value = volumes.level(volume, level).load(cell);
                    volumes.level_mut(volume, level).store(cell, value * LITTLE);
                }
            }
        }
    }

    fn voxel_sample(&self, volumes: &Volumes, uvw: DVec3, level: f64, direction: DVec3) -> DVec4 {
        let value = self.twin.voxel_sample(volumes, uvw, level, direction);
        if self.part == Break::Sample { value * self.sample } else { value }
    }
}

#[test]
fn a_broken_twin_is_noticed_where_it_is_broken() {
    for format in Formats::builtin().iter() {
        let (choices, library) = (Choices::default(), Library::builtin());
        let twin = format.twin(&choices).unwrap();
        let mut bench = Bench::new(gpu(), format, &choices, &library, Encoding::RGBA16FLOAT, SIDE).unwrap();
        let content = Content::random(SIDE, 5, 1.0);
        for (broken, part) in [
            (Break::Nothing, None),
            (Break::Store, Some("store")),
            (Break::Mipmap, Some("mipmap")),
            (Break::Sample, Some("sample")),
        ] {
            let has_bytes = bench.numbers().any(|numbers| are_bytes(bench.encoding, numbers));
            let sample = if has_bytes { LITTLE_OF_BYTES } else { LITTLE };
            let twin = Broken { twin: twin.as_ref(), part: broken, sample };
            let checks = against_twin(&mut bench, &twin, "random", &content).unwrap();
            for check in checks {
                let part_here = part.is_some_and(|part| check.at.contains(part));
                assert_eq!(check.figure > check.bound, part_here, "{}: {broken:?}: {check:?}", format.name());
            }
        }
    }
}

/// The format with one place of its WGSL changed.
fn edited(module: &str, from: &str, to: &str) -> Library {
    let mut library = Library::builtin();
    let source = Arc::clone(library.get(module).unwrap());
    assert!(source.text.contains(from), "{module} has no `{from}`");
    library.insert(module, Source::new(module, source.text.replacen(from, to, 1)));
    library
}

/// The property that fails first where a format's WGSL is changed.
fn fails(format: &str, library: &Library, property: Property) {
    let formats = Formats::builtin();
    let report = run(gpu(), formats.get(format).unwrap(), library, Encoding::RGBA16FLOAT).unwrap();
    let failed: Vec<_> = report.failures().map(|check| check.property).collect();
    assert!(failed.contains(&property), "{property:?} holds:\n{report}");
}

#[test]
fn each_property_can_fail() {
    let mipmap = "format/isotropic/mipmap";
    // RAU §5.3.1 as printed: the mean of the children's opacities lets light through a wall.
    fails(
        "isotropic",
        &edited(mipmap, "vec4f(sum.rgb * (most / max(sum.a, 1e-6)), most)", "sum / 8.0"),
        Property::Opaque,
    );
    let sample = "format/isotropic/sample";
    let value = "sample_volume(base, uvw, level)";
    let with = |change: &str| edited(sample, value, change);
    fails("isotropic", &with(&format!("{value} * 1.01")), Property::Constant);
    fails(
        "isotropic",
        &with(&format!("{value} * select(1.0, 0.0 / (uvw.x - uvw.x), uvw.x > 0.9)")),
        Property::Finite,
    );
    fails("isotropic", &with(&format!("pow({value}, vec4f(2.0))")), Property::Linear);
    fails("isotropic", &with(&format!("{value} * (1.0 + 0.1 * direction.x)")), Property::Symmetric);
    fails("isotropic", &with(&format!("{value} * (1.0 + 0.1 * level)")), Property::Energy);
    let faces = "format/six_face/faces";
    fails("six_face", &edited(faces, "select(0u, 1u, negative)", "select(1u, 0u, negative)"), Property::Twin);
    let child = "select(surface.front, surface.back, vec3<bool>(side == 1))[axis]";
    fails("six_face", &edited("format/six_face/mipmap", child, "1.0"), Property::Twin);
}

/// A format that says it misses what it holds.
#[derive(Debug)]
struct Modest;

impl StorageFormat for Modest {
    fn name(&self) -> &str {
        "modest"
    }
    fn summary(&self) -> &str {
        "isotropic"
    }
    fn modules(&self) -> &str {
        "format/isotropic"
    }
    fn volumes(&self, choices: &voxlume::Choices) -> Vec<voxlume::Volume> {
        voxlume::Isotropic.volumes(choices)
    }
    fn misses(&self) -> &[voxlume::Miss] {
        &[
            voxlume::Miss { property: Property::Sides, at: "", size: 0.5, why: "one radiance" },
            voxlume::Miss { property: Property::Opaque, at: "level 3", size: 0.2, why: "modesty" },
        ]
    }
}

#[test]
fn a_miss_declared_in_vain_fails() {
    let report = run(gpu(), &Modest, &Library::builtin(), Encoding::RGBA16FLOAT).unwrap();
    assert_eq!(report.failures().count(), 0, "{report}");
    assert!(!report.passes(), "{report}");
    assert!(report.to_string().contains("opaque is declared to miss by 0.2 and doesn't"), "{report}");
}
