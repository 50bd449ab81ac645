//! What is measured in: pipelines, formats, encodings and resolutions, on a device.

use std::fmt;

use voxlume::{Fault, Faults, Gpu, Grid, Pipeline, Registry, Request, check_variant};

use crate::words::words;

/// What is measured in: each format with each encoding and each resolution.
pub struct Settings<'a> {
    /// What pipelines can name.
    pub registry: &'a Registry,
    /// The pipeline that is measured.
    pub pipeline: &'a Pipeline,
    /// Storage formats, or `all`.
    pub formats: Vec<String>,
    /// Texel encodings, or `all`; the pipeline's if there are none.
    pub encodings: Vec<String>,
    /// Tracer of passes that name none; the pipeline's if `None`.
    pub tracer: Option<String>,
    /// Voxels along the grid's longest side.
    pub resolutions: Vec<u32>,
    /// Width and height of the screen in pixels.
    pub size: [u32; 2],
    /// Part of the name of the graphics device; any if `None`.
    pub adapter: Option<String>,
}

/// How voxels are stored.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Setting {
    pub format: String,
    pub encoding: String,
    pub resolution: u32,
}

impl fmt::Display for Setting {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {} {}³", self.format, self.encoding, self.resolution)
    }
}

impl Setting {
    /// Each format and encoding with each resolution; those of one format and encoding follow each other.
    pub fn each(variants: &[(String, String)], resolutions: &[u32]) -> Vec<Setting> {
        let setting = |(format, encoding): &(String, String), resolution: u32| Setting {
            format: format.clone(),
            encoding: encoding.clone(),
            resolution,
        };
        let of = |variant| resolutions.iter().map(move |resolution| setting(variant, *resolution));
        variants.iter().flat_map(of).collect()
    }
}

impl Settings<'_> {
    /// What a plan is asked for in a setting on this device.
    pub(crate) fn request(&self, setting: &Setting, gpu: &Gpu) -> Request {
        let [width, height] = self.size;
        Request {
            format: Some(setting.format.clone()),
            encoding: Some(setting.encoding.clone()),
            tracer: self.tracer.clone(),
            resolution: Some(setting.resolution),
            filters_float32: gpu.filters_float32(),
            ..Request::image(width, height)
        }
    }

    /// The tracer of passes that name none.
    pub(crate) fn tracer_word(&self) -> &str {
        self.tracer.as_deref().unwrap_or(&self.pipeline.tracer.value)
    }

    /// Each format with each encoding.
    pub(crate) fn variants(&self, faults: &mut Faults) -> Vec<(String, String)> {
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
        let with =
            |format| encodings.iter().map(move |encoding: &String| (String::clone(format), encoding.clone()));
        formats.iter().flat_map(with).collect()
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
