//! What is measured in: pipelines, formats, encodings, tracers, resolutions and scales, on a device.

use std::fmt;

use voxlume::{Fault, Faults, Gpu, Grid, Pipeline, Registry, Request, SCALES, check_variant, one_of};
use voxlume_report::setting_words;

use crate::words::words;

/// What is measured in: each format with each encoding, tracer, resolution and scale.
pub struct Settings<'a> {
    /// What pipelines can name.
    pub registry: &'a Registry,
    /// The pipeline that is measured.
    pub pipeline: &'a Pipeline,
    /// Storage formats, or `all`.
    pub formats: Vec<String>,
    /// Texel encodings, or `all`; the pipeline's if there are none.
    pub encodings: Vec<String>,
    /// Tracers of passes that name none, or `all`; the pipeline's if there are none.
    pub tracers: Vec<String>,
    /// Voxels along the grid's longest side.
    pub resolutions: Vec<u32>,
    /// What the screen's size is divided by where tracing effects gather; as the pipeline says if there are none.
    pub scales: Vec<u32>,
    /// Width and height of the screen in pixels.
    pub size: [u32; 2],
    /// Part of the name of the graphics device; any if `None`.
    pub adapter: Option<String>,
}

/// How voxels are stored and traced.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Setting {
    pub format: String,
    pub encoding: String,
    pub tracer: String,
    pub resolution: u32,
    /// `None` for the pipeline's own.
    pub scale: Option<u32>,
}

impl fmt::Display for Setting {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Setting { format, encoding, tracer, resolution, scale } = self;
        f.write_str(&setting_words(format, encoding, tracer, *resolution, *scale))
    }
}

impl Setting {
    /// Each of the settings with each resolution; those of one setting follow each other.
    pub fn each(settings: &[Setting], resolutions: &[u32]) -> Vec<Setting> {
        let of = |setting: &Setting| {
            let setting = setting.clone();
            resolutions.iter().map(move |resolution| Setting { resolution: *resolution, ..setting.clone() })
        };
        settings.iter().flat_map(of).collect()
    }
}

impl Settings<'_> {
    /// What a plan is asked for in a setting on this device.
    pub(crate) fn request(&self, setting: &Setting, gpu: &Gpu) -> Request {
        let [width, height] = self.size;
        Request {
            format: Some(setting.format.clone()),
            encoding: Some(setting.encoding.clone()),
            tracer: Some(setting.tracer.clone()),
            scale: setting.scale,
            resolution: Some(setting.resolution),
            filters_float32: gpu.filters_float32(),
            ..Request::image(width, height)
        }
    }

    /// Each format with each encoding, tracer and scale, at no resolution yet.
    pub(crate) fn variants(&self, faults: &mut Faults) -> Vec<Setting> {
        let names: Vec<&str> = self.registry.formats.iter().map(|format| format.name()).collect();
        let formats = words("storage format", &self.formats, &names, faults);
        let known: Vec<&str> = self.registry.encodings.iter().map(|encoding| encoding.name).collect();
        let encodings = if self.encodings.is_empty() {
            vec![self.pipeline.encoding.value.clone()]
        } else {
            words("encoding", &self.encodings, &known, faults)
        };
        if faults.is_empty() {
            for format in &formats {
                faults.gather(check_variant(self.pipeline, self.registry, format, known[0]));
            }
            for encoding in &encodings {
                faults.gather(check_variant(self.pipeline, self.registry, names[0], encoding));
            }
        }
        let known: Vec<&str> = self.registry.tracers.iter().map(|tracer| tracer.name).collect();
        let tracers = if self.tracers.is_empty() {
            vec![self.pipeline.tracer.value.clone()]
        } else {
            words("tracer", &self.tracers, &known, faults)
        };
        let scales = self.scales(faults);
        let mut settings = Vec::new();
        for format in &formats {
            for encoding in &encodings {
                for tracer in &tracers {
                    settings.extend(scales.iter().map(|scale| Setting {
                        format: format.clone(),
                        encoding: encoding.clone(),
                        tracer: tracer.clone(),
                        resolution: 0,
                        scale: *scale,
                    }));
                }
            }
        }
        settings
    }

    /// The scales, each once; the pipeline's own where none is given.
    fn scales(&self, faults: &mut Faults) -> Vec<Option<u32>> {
        let mut scales = Vec::new();
        for &scale in &self.scales {
            if !SCALES.contains(&scale) {
                let fault = Fault::new(format!("effects gathered at 1/{scale} of the screen"));
                faults.push(
                    fault.note(one_of(SCALES.map(|scale| scale.to_string()).iter().map(String::as_str))),
                );
            } else if !scales.contains(&Some(scale)) {
                scales.push(Some(scale));
            }
        }
        if scales.is_empty() { vec![None] } else { scales }
    }

    /// The resolutions, each once.
    pub(crate) fn resolutions(&self, faults: &mut Faults) -> Vec<u32> {
        let mut resolutions: Vec<u32> = Vec::new();
        for &resolution in &self.resolutions {
            if !Grid::RESOLUTIONS.contains(&resolution) {
                let fault =
                    Fault::new(format!("a grid of {resolution} × {resolution} × {resolution} voxels"));
                faults.push(fault.note(Grid::resolution_range()));
            } else if !resolutions.contains(&resolution) {
                resolutions.push(resolution);
            }
        }
        resolutions
    }
}
