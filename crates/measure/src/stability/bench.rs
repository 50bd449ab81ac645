//! Where cases are measured: a device, and one format, encoding and resolution.

use voxlume::{
    Faults, Gpu, Grid, Passes, Picture, RAYS, Renderer, Request, ResourceKind, Scene, SceneFacts, Value,
};

use crate::settings::Setting;
use crate::{Error, Settings};

/// A setting on a device.
pub struct Bench<'g> {
    pub settings: &'g Settings<'g>,
    pub setting: Setting,
    pub gpu: &'g Gpu,
}

/// A parameter of a pass: pass, name, value.
pub type Set = (&'static str, &'static str, Value);

impl Bench<'_> {
    /// Renders a frame up to an image, from the scene's first camera.
    pub fn render(&self, scene: &Scene, output: &str, set: &[Set]) -> Result<Renderer<'_>, Error> {
        self.render_at(self.setting.resolution, self.settings.size, scene, output, set)
    }

    /// As `render`, at another resolution and size.
    pub fn render_at(
        &self,
        resolution: u32,
        size: [u32; 2],
        scene: &Scene,
        output: &str,
        set: &[Set],
    ) -> Result<Renderer<'_>, Error> {
        let request = Request {
            resolution: Some(resolution),
            screen: size,
            output: Some(output.into()),
            set: set
                .iter()
                .map(|(pass, name, value)| ((*pass).into(), (*name).into(), value.clone()))
                .collect(),
            ..self.settings.request(&self.setting, self.gpu)
        };
        let Settings { registry, pipeline, .. } = self.settings;
        let plan = voxlume::plan(pipeline, &SceneFacts::of(scene)?, registry, &request)?;
        let mut renderer = Renderer::new(self.gpu, plan, scene)?;
        renderer.render(scene, &scene.cameras[0], Passes::All)?;
        Ok(renderer)
    }

    /// An image from the scene's first camera.
    pub fn image(&self, scene: &Scene, output: &str, set: &[Set]) -> Result<Picture, Error> {
        Ok(self.render(scene, output, set)?.picture(output)?)
    }

    /// The grid that a scene gets.
    pub fn grid(&self, scene: &Scene) -> Grid {
        Grid::fit(self.setting.resolution, scene.bounds())
    }

    /// Whether what is traced tells the sides of a surface apart: by its format, or as rays do.
    pub fn is_directional(&self) -> bool {
        self.setting.tracer == RAYS.name || !self.setting.format.starts_with("isotropic")
    }
}

/// Names of the images of a renderer's plan.
pub fn images(renderer: &Renderer<'_>) -> Vec<String> {
    named(renderer, |kind| matches!(kind, ResourceKind::Image { .. }))
}

/// A level of a volume: name, mip level, texels.
pub type Level = (String, u32, Vec<[f32; 4]>);

/// Every level of every volume.
pub fn volumes(renderer: &Renderer<'_>) -> Result<Vec<Level>, Error> {
    let mut levels = Vec::new();
    for name in named(renderer, |kind| matches!(kind, ResourceKind::Volume { .. })) {
        let texels = renderer.volume(&name)?;
        levels.extend(texels.into_iter().zip(0..).map(|(level, mip)| (name.clone(), mip, level.values)));
    }
    Ok(levels)
}

fn named(renderer: &Renderer<'_>, is: fn(&ResourceKind) -> bool) -> Vec<String> {
    let resources = renderer.plan().resources.iter();
    resources.filter(|resource| is(&resource.kind)).map(|resource| resource.name.clone()).collect()
}

/// Mean of each of the first three channels.
pub fn mean(picture: &Picture) -> [f64; 3] {
    let sum = |channel: usize| picture.pixels.iter().map(|pixel| f64::from(pixel[channel])).sum::<f64>();
    [0, 1, 2].map(|channel| sum(channel) / picture.pixels.len() as f64)
}

/// Mean of the three channels.
pub fn grey(picture: &Picture) -> f64 {
    mean(picture).iter().sum::<f64>() / 3.0
}

/// Mean difference of two images' values over the mean of the first.
pub fn difference(a: &Picture, b: &Picture) -> f64 {
    let values =
        |picture: &Picture| picture.pixels.iter().flat_map(|p| [p[0], p[1], p[2]]).collect::<Vec<_>>();
    let pairs = values(a).into_iter().zip(values(b));
    let sum: f64 = pairs.map(|(a, b)| f64::from(a - b).abs()).sum();
    sum / (3 * a.pixels.len()) as f64 / grey(a)
}

/// A scene of Voxlume's own.
pub fn scene((file, text): (&str, &str)) -> Result<Scene, Faults> {
    Scene::parse(&voxlume::Source::new(file, text))
}
