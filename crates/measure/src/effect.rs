//! Images that are compared, and what the reference computes for each.

use voxlume::{Emission, Fault, PassEntry, Pipeline, Plan, Reference, Scene, Shows, Value};
use voxlume_reference::{Gather, Panel, Quantity};

/// An image that is compared.
#[derive(Clone, Copy, Debug)]
pub struct Effect<'p> {
    /// The effect's name in the pipeline; for an image of another kind of pass, such as `final`, the image's.
    pub name: &'p str,
    /// The image in the pipeline.
    pub image: &'p str,
    /// What its values are.
    pub shows: Shows,
    /// What it is held against; `None` for the sweep's finest setting.
    pub reference: Option<Reference>,
    pub(crate) entry: &'p PassEntry,
}

impl<'p> Effect<'p> {
    /// A pipeline's effects, its output, and what else has a reference, in the order of the file, less those whose entries have
    /// `compare: false`.
    pub fn all(pipeline: &'p Pipeline) -> Vec<Effect<'p>> {
        let effect = |entry: &'p PassEntry| {
            let image = entry.writes.first()?.value.as_str();
            let output = image == pipeline.output.value;
            let compared = entry.is_effect() || entry.reference.is_some() || output;
            (compared && entry.compared).then(|| Effect {
                name: if entry.is_effect() { &entry.name } else { image },
                image,
                shows: entry.shows.as_ref().map_or(Shows::default(), |shows| shows.value),
                reference: entry.reference.as_ref().map(|reference| reference.value),
                entry,
            })
        };
        pipeline.passes.iter().filter_map(effect).collect()
    }

    /// What the reference computes for the image as this plan of the pipeline shows it, after so many bounces of indirect
    /// light; `None` for an effect without a reference.
    ///
    /// # Errors
    /// The scene has no light to cast a shadow; the entry has no `distance` or `falloff` of ambient occlusion.
    pub fn quantity(
        &self,
        pipeline: &Pipeline,
        plan: &Plan,
        scene: &Scene,
        bounces: u32,
    ) -> Result<Option<Quantity>, Fault> {
        // Area lights reach pixels directly, but mirrors show them; other emission is gathered from voxels.
        let gather = Gather { bounces, sky: true, emission: plan.emission != Emission::AreaLights };
        let Some(reference) = self.reference else { return Ok(None) };
        Ok(Some(match reference {
            Reference::SoftShadow => first_light(plan, scene)?,
            Reference::AmbientOcclusion => {
                let longest = plan.grid.size.into_iter().max().unwrap_or(0) as f32 * plan.grid.voxel_size;
                let given = number(self.entry, "distance").zip(number(self.entry, "falloff"));
                let missing = || {
                    let span = self.entry.reference.as_ref().and_then(|reference| reference.span.clone());
                    let message = format!("pass `{}` has no number `distance` or `falloff`", self.entry.name);
                    pipeline.fault(
                        &span,
                        message,
                        "accessibility is traced with both, from the entry's `params`",
                    )
                };
                let (distance, falloff) = given.ok_or_else(missing)?;
                Quantity::AmbientOcclusion {
                    distance: distance as f32 * longest,
                    falloff: falloff as f32 / longest,
                }
            }
            Reference::Diffuse => Quantity::Diffuse(gather),
            Reference::Specular => Quantity::Specular(Gather { emission: true, ..gather }),
            Reference::Final => Quantity::Final { bounces },
        }))
    }
}

fn number(entry: &PassEntry, param: &str) -> Option<f64> {
    match entry.params.iter().find(|given| given.name == param)?.value {
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
    let polygons =
        scene.emissive_polygons(origin, MOST_POLYGONS).filter(|_| plan.emission == Emission::AreaLights);
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
