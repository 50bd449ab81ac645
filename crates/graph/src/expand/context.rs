//! What planning builds up.

use std::collections::{BTreeMap, BTreeSet};

use voxlume_fault::Faults;
use voxlume_format::{Choices, Encoding, StorageFormat, Volume};
use voxlume_shader::{EFFECT, Library, Shader, link};

use crate::facts::SceneFacts;
use crate::grid::Grid;
use crate::pipeline::Pipeline;
use crate::plan::{LeftOut, Resource, ResourceKind};
use crate::tracer::{Tracer, Tracers};

/// A storage format with all that is chosen about it.
pub(crate) struct Storage<'a> {
    format: &'a dyn StorageFormat,
    choices: Choices,
    pub encoding: Encoding,
    filters_float32: bool,
}

impl<'a> Storage<'a> {
    pub fn new(
        format: &'a dyn StorageFormat,
        choices: Choices,
        encoding: Encoding,
        filters_float32: bool,
    ) -> Storage<'a> {
        Storage { format, choices, encoding, filters_float32 }
    }

    pub fn volumes(&self) -> Vec<Volume> {
        self.format.volumes(&self.choices)
    }

    /// `sh2:mip=projected`
    pub fn word(&self) -> String {
        format!("{}{}", self.format.name(), self.choices)
    }

    fn mounts(&self) -> Vec<(&str, &str)> {
        let filter = self.encoding.texel.filter(self.filters_float32);
        vec![("format", self.format.modules()), ("encoding", self.encoding.module), ("filter", filter)]
    }

    /// The word chosen for the option whose `override` has this name.
    pub fn word_of(&self, name: &str) -> Option<&'static str> {
        let option = self.format.options().iter().find(|option| option.name.to_uppercase() == name)?;
        Some(self.choices.word(option))
    }
}

/// What planning builds up.
pub(crate) struct Context<'a> {
    pub pipeline: &'a Pipeline,
    pub facts: &'a SceneFacts,
    pub storage: Storage<'a>,
    pub grid: Grid,
    pub screen: [u32; 2],
    pub library: Library,
    pub tracers: &'a Tracers,
    pub area_lights: bool,
    /// How voxels join the reflectances of triangles.
    pub conflict: &'static str,
    /// Names in the graph that some planned pass makes.
    pub available: BTreeSet<String>,
    /// Images of `surface` that some planned pass, or the output, uses.
    pub surface_images: BTreeSet<&'static str>,
    pub shaders: Vec<Shader>,
    linked: BTreeMap<(String, String, &'static str), usize>,
    pub resources: Vec<Resource>,
    pub left_out: Vec<LeftOut>,
    pub faults: Faults,
    /// Whether voxels are as opaque as the area that triangles cover in them.
    pub coverage: bool,
    /// The buffer with every voxel's light that stays from bounce to bounce.
    pub radiance: usize,
    /// The buffer with what the volume holds first: the same, or with what is gathered of emission.
    pub first: usize,
}

impl<'a> Context<'a> {
    pub fn new(
        pipeline: &'a Pipeline,
        facts: &'a SceneFacts,
        storage: Storage<'a>,
        grid: Grid,
        screen: [u32; 2],
        library: Library,
        tracers: &'a Tracers,
    ) -> Context<'a> {
        Context {
            pipeline,
            facts,
            storage,
            grid,
            screen,
            library,
            tracers,
            area_lights: false,
            conflict: "sum",
            available: BTreeSet::new(),
            surface_images: BTreeSet::new(),
            shaders: Vec::new(),
            linked: BTreeMap::new(),
            resources: Vec::new(),
            left_out: Vec::new(),
            faults: Faults::default(),
            coverage: false,
            radiance: 0,
            first: 0,
        }
    }

    /// The resource called `name`, made as `kind` at its first use.
    pub fn resource(&mut self, name: &str, kind: ResourceKind) -> usize {
        let known = self.resources.iter().position(|resource| resource.name == name);
        known.unwrap_or_else(|| {
            self.resources.push(Resource { name: name.to_owned(), kind });
            self.resources.len() - 1
        })
    }

    pub fn known(&self, name: &str) -> Option<usize> {
        self.resources.iter().position(|resource| resource.name == name)
    }

    /// Links and checks a module, once for each mount and tracer.
    pub fn shader(&mut self, entry: &str, mount: Option<(&str, &str)>, tracer: &Tracer) -> Option<usize> {
        let target = mount.map(|(_, target)| target).unwrap_or_default();
        let key = (entry.to_owned(), target.to_owned(), tracer.modules);
        if let Some(shader) = self.linked.get(&key) {
            return Some(*shader);
        }
        let checked = self.checked(entry, mount, tracer);
        let shader = self.faults.gather(checked)?;
        self.shaders.push(shader);
        self.linked.insert(key, self.shaders.len() - 1);
        Some(self.shaders.len() - 1)
    }

    /// Checks an effect's module by itself, so that faults point into it.
    pub fn effect(&mut self, module: &str, tracer: &Tracer) -> Option<()> {
        let checked = self.checked(module, None, tracer);
        let shader = self.faults.gather(checked)?;
        self.faults.gather(shader.fulfils(&EFFECT, module))
    }

    /// Names of what a tracer lets a pass choose.
    pub fn trace_params(&self, tracer: &Tracer) -> Vec<String> {
        let shader = self.checked(&format!("{}/trace", tracer.modules), None, tracer);
        let layout = shader.ok().and_then(|shader| shader.struct_layout("TraceParams"));
        layout.map_or_else(Vec::new, |layout| layout.fields.into_iter().map(|field| field.name).collect())
    }

    fn checked(&self, entry: &str, mount: Option<(&str, &str)>, tracer: &Tracer) -> Result<Shader, Faults> {
        let mut mounts = self.storage.mounts();
        mounts.push(("tracer", tracer.modules));
        mounts.extend(mount);
        link(&self.library, entry, &mounts).and_then(voxlume_shader::Linked::check)
    }

    /// Values for the scene-wide `override`s.
    pub fn constants(&self) -> Vec<(&'static str, f64)> {
        let facts = self.facts;
        let flag = |on: bool| f64::from(u8::from(on));
        vec![
            ("HAS_TEXTURES", flag(facts.textured)),
            ("HAS_ALPHA_MASK", flag(facts.masked)),
            ("HAS_EMISSION", flag(self.voxel_emission())),
            ("HAS_VOXEL_EMISSION", flag(self.voxel_emission())),
            ("HAS_COVERAGE", flag(self.coverage)),
            ("HAS_DIRECTIONAL", flag(facts.directional > 0)),
            ("HAS_POINT", flag(facts.point > 0)),
            ("HAS_SPOT", flag(facts.spot > 0)),
            ("HAS_AREA", flag(self.area_lights)),
            ("CONSERVATIVE", flag(self.pipeline.separability.value == "conservative")),
            ("ATTRIBUTE_STRIDE", f64::from(self.attribute_stride())),
            ("ENCODING_RANGE", f64::from(self.storage.encoding.range)),
        ]
    }

    /// Whether voxels hold emission.
    pub fn voxel_emission(&self) -> bool {
        self.facts.emissive && !self.area_lights
    }

    /// Words of a voxel's attributes: two weights, reflectance, two of normals, emission if there is any, and the
    /// area covered if it counts.
    pub fn attribute_stride(&self) -> u32 {
        11 + if self.voxel_emission() { 3 } else { 0 } + u32::from(self.coverage)
    }

    /// Lights of all kinds.
    pub fn light_count(&self) -> u32 {
        let polygons = if self.area_lights { self.facts.polygons.unwrap_or(0) } else { 0 };
        self.facts.punctual() + polygons
    }
}
