//! Effects, their images in a pipeline, and what the reference computes for each.

use voxlume::{Fault, Pipeline, Plan, Scene, SceneFacts, Value};
use voxlume_reference::{Gather, Panel, Quantity};

/// What is compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Effect {
    /// Visibility of the first light.
    SoftShadow,
    /// Accessibility, with the pass's own reach and falloff.
    AmbientOcclusion,
    /// Irradiance that surfaces and the sky send.
    Diffuse,
    /// Radiance along the glossy lobe.
    Specular,
    /// The whole image.
    Final,
}

impl Effect {
    /// All of them.
    pub const ALL: [Effect; 5] =
        [Effect::SoftShadow, Effect::AmbientOcclusion, Effect::Diffuse, Effect::Specular, Effect::Final];

    /// The word for it: the stem of its WGSL file, or `final`.
    pub fn name(self) -> &'static str {
        match self {
            Effect::SoftShadow => "soft_shadow",
            Effect::AmbientOcclusion => "ambient_occlusion",
            Effect::Diffuse => "diffuse",
            Effect::Specular => "specular",
            Effect::Final => "final",
        }
    }

    /// Whether its values are shares, shown as they are, and only the first channel is the effect's.
    pub fn is_share(self) -> bool {
        matches!(self, Effect::SoftShadow | Effect::AmbientOcclusion)
    }

    /// The image of [`crate::picture`]'s kinds that it is shown as.
    pub fn shown_as(self) -> &'static str {
        if self.is_share() { "ao" } else { "final" }
    }

    /// Whether a scene has anything of it.
    pub fn applies(self, facts: &SceneFacts) -> bool {
        match self {
            Effect::SoftShadow => facts.punctual() > 0 || facts.polygons.is_some_and(|count| count > 0),
            Effect::Specular => facts.glossy,
            _ => true,
        }
    }

    /// The image that the pipeline's pass of that effect writes.
    pub fn image(self, pipeline: &Pipeline) -> Option<&str> {
        let run = match self {
            Effect::Final => "composite".to_owned(),
            _ => format!("effect/{}", self.name()),
        };
        let pass = pipeline.passes.iter().find(|pass| pass.run.value == run)?;
        pass.writes.first().map(|image| image.value.as_str())
    }

    /// What the reference computes for the effect as this plan of the pipeline shows it, after so many bounces of
    /// indirect light.
    ///
    /// # Errors
    /// The scene has no light to cast a shadow; the pipeline has no pass for ambient occlusion.
    pub fn quantity(
        self,
        pipeline: &Pipeline,
        plan: &Plan,
        scene: &Scene,
        bounces: u32,
    ) -> Result<Quantity, Fault> {
        // Area lights reach pixels directly; other emission is gathered from voxels.
        let gather = Gather { bounces, sky: true, emission: !plan.area_lights };
        Ok(match self {
            Effect::SoftShadow => first_light(plan, scene)?,
            Effect::AmbientOcclusion => {
                let longest = plan.grid.size.into_iter().max().unwrap_or(0) as f32 * plan.grid.voxel_size;
                let number = |name| number(pipeline, "effect/ambient_occlusion", name);
                let missing = || {
                    Fault::new("the pipeline has no `effect/ambient_occlusion` with `distance` and `falloff`")
                };
                let (distance, falloff) = number("distance").zip(number("falloff")).ok_or_else(missing)?;
                Quantity::AmbientOcclusion {
                    distance: distance as f32 * longest,
                    falloff: falloff as f32 / longest,
                }
            }
            Effect::Diffuse => Quantity::Diffuse(gather),
            Effect::Specular => Quantity::Specular(gather),
            Effect::Final => Quantity::Final { bounces },
        })
    }
}

/// Bounces of indirect light that a pipeline shows: one by gathering, and those of its `bounce` passes.
pub fn bounces(pipeline: &Pipeline) -> u32 {
    1 + number(pipeline, "bounce", "bounces").unwrap_or(0.0) as u32
}

fn number(pipeline: &Pipeline, run: &str, param: &str) -> Option<f64> {
    let pass = pipeline.passes.iter().find(|pass| pass.run.value == run)?;
    match pass.params.iter().find(|given| given.name == param)?.value {
        Value::Number(number) => Some(number),
        _ => None,
    }
}

/// Lights come in the scene's order, area lights after all others.
fn first_light(plan: &Plan, scene: &Scene) -> Result<Quantity, Fault> {
    if !scene.lights.is_empty() {
        return Ok(Quantity::SoftShadow { light: 0 });
    }
    let origin = plan.grid.centre;
    let polygons = scene.emissive_polygons(origin, MOST_POLYGONS).filter(|_| plan.area_lights);
    let polygon = polygons.and_then(|polygons| polygons.into_iter().next());
    let polygon = polygon.ok_or_else(|| Fault::new("the scene has no light to cast a shadow"))?;
    let corner = |index: usize| {
        let last = polygon.corners.len() - 1;
        origin + polygon.corners[index.min(last)].as_dvec3()
    };
    let corners = [corner(0), corner(1), corner(2), corner(3)];
    Ok(Quantity::PanelShadow(Panel { corners, double_sided: polygon.double_sided }))
}

/// More than any plan takes as area lights.
const MOST_POLYGONS: usize = 1 << 16;
