//! What planning builds up.

use std::collections::{BTreeMap, BTreeSet};

use glam::DVec3;
use voxlume_fault::Faults;
use voxlume_format::{Encodings, Formats, StorageFormat};
use voxlume_shader::{Binding, EFFECT, Library, Shader, TRACER, link};

use crate::bundle::Bundle;
use crate::entries::sorts;
use crate::expansion::LAST;
use crate::facts::{Emission, SceneFacts};
use crate::grid::{Extent, Grid};
use crate::pass::{Kinds, PassKind, Sort};
use crate::pipeline::{Located, PassEntry, Pipeline};
use crate::plan::{LeftOut, Life, Resource, ResourceKind};
use crate::storage::Storage;
use crate::tracer::{Tracer, Tracers};
use crate::variant;

/// What a plan is made of, apart from the pipeline and the scene.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Given<'a> {
    pub pipeline: &'a Pipeline,
    pub facts: &'a SceneFacts,
    pub kinds: &'a Kinds,
    pub formats: &'a Formats,
    pub encodings: &'a Encodings,
    pub tracers: &'a Tracers,
    pub library: &'a Library,
    pub screen: [u32; 2],
    pub filters_float32: bool,
}

/// Names that imports begin with, and the modules or folders that they mean.
pub(crate) type Mounts = Vec<(&'static str, String)>;

/// What planning builds up.
#[derive(Debug)]
pub(crate) struct Context<'a> {
    pub pipeline: &'a Pipeline,
    pub facts: &'a SceneFacts,
    pub kinds: &'a Kinds,
    formats: &'a Formats,
    encodings: &'a Encodings,
    pub tracers: &'a Tracers,
    library: &'a Library,
    pub screen: [u32; 2],
    filters_float32: bool,
    /// The pipeline's own.
    pub default_storage: Storage<'a>,
    /// The pipeline's own comes first; its centre is the scene's origin.
    pub grids: Vec<Grid>,
    pub emission: Emission,
    /// What sort of thing each name of the graph is.
    pub sorts: BTreeMap<String, Sort>,
    /// Names of the entries that are planned.
    pub live: BTreeSet<String>,
    /// What each name made so far stands for.
    pub bundles: BTreeMap<String, Bundle>,
    pub shaders: Vec<Shader>,
    linked: BTreeMap<(String, Mounts), usize>,
    pub resources: Vec<Resource>,
    pub levels: Vec<usize>,
    pub out_of_range: Vec<usize>,
    pub left_out: Vec<LeftOut>,
    pub faults: Faults,
}

impl<'a> Context<'a> {
    pub fn new(given: Given<'a>, storage: Storage<'a>, grid: Grid, emission: Emission) -> Context<'a> {
        let Given { pipeline, facts, kinds, formats, encodings, tracers, library, screen, filters_float32 } =
            given;
        Context {
            pipeline,
            facts,
            kinds,
            formats,
            encodings,
            tracers,
            library,
            screen,
            filters_float32,
            default_storage: storage,
            grids: vec![grid],
            emission,
            sorts: sorts(pipeline, kinds),
            live: BTreeSet::new(),
            bundles: BTreeMap::new(),
            shaders: Vec::new(),
            linked: BTreeMap::new(),
            resources: Vec::new(),
            levels: Vec::new(),
            out_of_range: Vec::new(),
            left_out: Vec::new(),
            faults: Faults::default(),
        }
    }

    /// The resource called `name`, made as `kind` at its first use.
    pub fn resource(&mut self, name: &str, kind: ResourceKind) -> usize {
        let known = self.known(name);
        known.unwrap_or_else(|| {
            self.resources.push(Resource { name: name.to_owned(), kind, life: Life::Frame });
            self.resources.len() - 1
        })
    }

    pub fn known(&self, name: &str) -> Option<usize> {
        self.resources.iter().position(|resource| resource.name == name)
    }

    /// The name that an entry reads for a port of its kind: the one that it calls so, or the only one of the port's sort.
    pub fn read_of<'e>(&self, entry: &'e PassEntry, kind: &dyn PassKind, port: &str) -> Option<&'e str> {
        read_of(&self.sorts, entry, kind, port)
    }

    /// Whether an effect's own file asks the storage format itself.
    pub fn uses_format(&self, entry: &PassEntry) -> bool {
        let module = self.library.get(entry.run.value.trim_end_matches(".wgsl"));
        module.is_some_and(|source| source.text.contains("package::format"))
    }

    pub fn is_live(&self, entry: &PassEntry) -> bool {
        self.live.contains(&entry.name)
    }

    /// What in the graph has a shader's variable, for a pass that doesn't read it.
    pub fn owner_of(&self, variable: &str) -> Option<&str> {
        let made = self.bundles.iter().find(|(_, bundle)| bundle.part(variable).is_some());
        let of_sort = |sort: &Sort| {
            let volume = || self.default_storage.volumes().iter().any(|volume| volume.name == variable);
            sort.images.contains(&variable) || (*sort == Sort::VOLUME && volume())
        };
        let later = || self.sorts.iter().find(|(_, sort)| of_sort(sort)).map(|(name, _)| name.as_str());
        made.map(|(name, _)| name.as_str()).or_else(later)
    }

    /// A format and an encoding by their words; where neither is given, the pipeline's.
    pub fn storage(
        &mut self,
        format: Option<Located<String>>,
        encoding: Option<Located<String>>,
    ) -> Option<Storage<'a>> {
        if format.is_none() && encoding.is_none() {
            return Some(self.default_storage.clone());
        }
        let format = format.unwrap_or_else(|| self.pipeline.format.clone());
        let encoding = encoding.unwrap_or_else(|| self.pipeline.encoding.clone());
        let mut faults = Faults::default();
        let chosen = variant::format(self.pipeline, &format, self.formats, &mut faults);
        let encoding = variant::encoding(self.pipeline, &encoding, self.encodings, &mut faults);
        // Each pass that uses the volume asks.
        let known: Vec<String> = self.faults.iter().map(ToString::to_string).collect();
        self.faults.extend(faults.into_iter().filter(|fault| !known.contains(&fault.to_string())));
        let (format, choices) = chosen?;
        Some(Storage::new(format, choices, encoding?, self.filters_float32))
    }

    /// Modules that imports mean unless a pass says otherwise.
    pub fn default_mounts(&self) -> Mounts {
        let usual = [
            ("texel", "texel/rgba16float"),
            ("seen", "seen/pixel"),
            ("walk", "walk/leaps"),
            ("meet", "meet/sheets"),
            ("lamps", "lamps/none"),
            (
                "emitters",
                if self.emission == Emission::Sampled { "emitters/sampled" } else { "emitters/none" },
            ),
        ];
        let usual = usual.map(|(name, module)| (name, module.to_owned()));
        self.default_storage.mounts().into_iter().chain(usual).collect()
    }

    /// Whether a variable belongs to a storage format's module and, with the options chosen, to none of its volumes.
    pub fn is_idle_volume(&self, binding: &Binding) -> bool {
        let is_in =
            |folder: &str| binding.module.strip_prefix(folder).is_some_and(|rest| rest.starts_with('/'));
        let of_format = self.formats.iter().map(StorageFormat::modules).any(is_in);
        (of_format || is_in(self.default_storage.modules()))
            && !self.default_storage.volumes().iter().any(|volume| volume.name == binding.name)
    }

    /// The grid that a voxelization describes: the pipeline's if it says nothing.
    ///
    /// # Errors
    /// The parameter that is missing or wrong.
    pub fn own_grid(
        &mut self,
        resolution: Option<u32>,
        corners: (Option<[f64; 3]>, Option<[f64; 3]>),
    ) -> Result<usize, &'static str> {
        let extent = match corners.0.zip(corners.1) {
            Some((low, high)) => {
                let (low, high) = (DVec3::from_array(low), DVec3::from_array(high));
                if !low.cmplt(high).all() {
                    return Err("max");
                }
                Extent::Box(low, high)
            }
            None if corners.0.is_some() => return Err("min"),
            None if corners.1.is_some() => return Err("max"),
            None => self.pipeline.extent,
        };
        let resolution = match resolution {
            Some(resolution) => resolution,
            None if corners.0.is_some() => return Err("min"),
            None => return Ok(0),
        };
        self.grids.push(Grid::new(resolution, extent, self.facts.bounds));
        Ok(self.grids.len() - 1)
    }

    /// The uniform with a grid's values: `Grid` in wgsl/common/grid.wgsl.
    pub fn grid_resource(&mut self, index: usize) -> usize {
        let name = if index == 0 { "grid".to_owned() } else { format!("grid_{index}") };
        let origin = self.grids[0].centre;
        let bytes = self.grids[index].uniform(origin, self.facts.triangles, self.facts.emission_max);
        self.resource(&name, ResourceKind::Uniform(bytes))
    }

    /// Links and checks a module, once for each set of mounts.
    pub fn shader(&mut self, entry: &str, mounts: &[(&'static str, String)]) -> Option<usize> {
        let key = (entry.to_owned(), mounts.to_vec());
        if let Some(shader) = self.linked.get(&key) {
            return Some(*shader);
        }
        let named: Vec<(&str, &str)> = mounts.iter().map(|(name, folder)| (*name, folder.as_str())).collect();
        let checked = link(self.library, entry, &named).and_then(voxlume_shader::Linked::check);
        let shader = self.faults.gather(checked)?;
        self.shaders.push(shader);
        self.linked.insert(key, self.shaders.len() - 1);
        Some(self.shaders.len() - 1)
    }

    /// Checks an effect's module by itself, so that faults point into it.
    pub fn effect(&mut self, module: &str, mounts: &[(&'static str, String)]) -> Option<Shader> {
        let named: Vec<(&str, &str)> = mounts.iter().map(|(name, folder)| (*name, folder.as_str())).collect();
        let checked = link(self.library, module, &named).and_then(voxlume_shader::Linked::check);
        let shader = self.faults.gather(checked)?;
        self.faults.gather(shader.fulfils(&EFFECT, module))?;
        Some(shader)
    }

    /// Names of what tracers let a pass choose, whichever it has.
    pub fn trace_params(&self) -> Vec<String> {
        let fields = self.tracers.iter().flat_map(|tracer| {
            let shader = self.tracer(tracer).ok();
            shader
                .and_then(|shader| shader.struct_layout("TraceParams"))
                .map_or(Vec::new(), |layout| layout.fields)
        });
        fields.map(|field| field.name).collect()
    }

    /// A tracer's module by itself.
    fn tracer(&self, tracer: &Tracer) -> Result<Shader, Faults> {
        let mut mounts = self.default_mounts();
        mounts.push(("tracer", tracer.modules.to_owned()));
        let named: Vec<(&str, &str)> = mounts.iter().map(|(name, folder)| (*name, folder.as_str())).collect();
        let module = format!("{}/trace", tracer.modules);
        link(self.library, &module, &named).and_then(voxlume_shader::Linked::check)
    }

    /// Checks the tracers of planned passes by themselves, so that what is missing is said once, by its signature.
    pub fn check_tracers(&mut self) {
        let live = self.pipeline.passes.iter().filter(|entry| self.is_live(entry));
        let traces = live.filter(|entry| self.kinds.of(entry).traces());
        let mut tracers: Vec<&Tracer> = traces.map(|entry| self.tracers.of(self.pipeline, entry)).collect();
        tracers.sort_by_key(|tracer| tracer.name);
        tracers.dedup();
        let faults: Vec<Faults> = tracers
            .into_iter()
            .filter_map(|tracer| {
                let module = format!("{}/trace", tracer.modules);
                self.tracer(tracer).and_then(|shader| shader.fulfils(&TRACER, &module)).err()
            })
            .collect();
        faults.into_iter().for_each(|faults| self.faults.extend(faults));
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
            ("TEXTURE_SIZE", f64::from(facts.texture_size)),
            ("HAS_DIRECTIONAL", flag(facts.directional > 0)),
            ("HAS_POINT", flag(facts.point > 0)),
            ("HAS_SPOT", flag(facts.spot > 0)),
            ("HAS_AREA", flag(self.emission != Emission::Gathered)),
            ("CONSERVATIVE", flag(self.pipeline.separability.value == "conservative")),
        ]
    }

    /// Whether voxels hold emission.
    pub fn voxel_emission(&self) -> bool {
        self.facts.emissive && self.emission != Emission::AreaLights
    }

    /// Lights of all kinds.
    pub fn light_count(&self) -> u32 {
        let area_lights = self.emission == Emission::AreaLights;
        self.facts.punctual() + if area_lights { self.facts.polygons.unwrap_or(0) } else { 0 }
    }
}

/// See [`Context::read_of`].
pub(crate) fn read_of<'e>(
    sorts: &BTreeMap<String, Sort>,
    entry: &'e PassEntry,
    kind: &dyn PassKind,
    port: &str,
) -> Option<&'e str> {
    let ports = kind.reads();
    let sort = ports.iter().find(|known| known.name == port)?.sort;
    let alone = ports.iter().filter(|known| known.sort == sort).count() == 1;
    let called = entry.reads.iter().find(|read| entry.alias(&read.value) == port);
    let of_sort = || {
        let is = |name: &str| sorts.get(name.trim_end_matches(LAST)) == Some(&sort);
        entry.reads.iter().filter(|_| alone).find(|read| is(&read.value))
    };
    called.or_else(of_sort).map(|read| read.value.as_str())
}
