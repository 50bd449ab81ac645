//! The cells of a sweep.

use std::path::{Path, PathBuf};

use voxlume::{Camera, Emission, Fault, Faults, Request, Scene, SceneFacts, one_of};
use voxlume_reference::cache::SceneDigest;

use super::Sweep;
use crate::Error;
use crate::effect::Effect;
use crate::settings::{Setting, Settings};
use crate::words::words;

/// A scene of the sweep.
pub struct Subject {
    /// Its name in the results and in files' names; unique.
    pub label: String,
    /// The scene.
    pub scene: Scene,
    /// Its content's hash.
    pub digest: SceneDigest,
    /// What a plan needs of it.
    pub facts: SceneFacts,
    /// The eye.
    pub camera: Camera,
    /// Whether emissive polygons are lights of their own.
    emission: Emission,
}

/// One comparison.
#[derive(Clone, Debug)]
pub struct Cell<'p> {
    /// In the list of subjects.
    pub subject: usize,
    pub effect: Effect<'p>,
    pub setting: Setting,
}

/// All comparisons.
pub struct Cells<'p> {
    pub subjects: Vec<Subject>,
    pub cells: Vec<Cell<'p>>,
    /// What effects without a reference are held against: the first format, encoding, tracer and scale at the finest
    /// resolution.
    pub finest: Setting,
}

impl Cell<'_> {
    /// The stem of its files.
    pub fn stem(&self, subjects: &[Subject]) -> String {
        let Setting { format, encoding, tracer, resolution, scale } = &self.setting;
        let label = &subjects[self.subject].label;
        let scale = scale.map(|scale| format!("-scale{scale}")).unwrap_or_default();
        // Options have characters that files' names can't have everywhere.
        let [format, encoding] = [format, encoding].map(|word| word.replace(':', "+"));
        format!("{label}-{}-{format}-{encoding}-{tracer}-{resolution}{scale}", self.effect.name)
    }
}

/// Loads the scenes, and finds out which cells there are.
pub fn cells<'p>(sweep: &Sweep<'p>) -> Result<Cells<'p>, Error> {
    let mut faults = Faults::default();
    let variants = sweep.settings.variants(&mut faults);
    let effects = effects(sweep, &mut faults);
    let resolutions = sweep.settings.resolutions(&mut faults);
    let subjects = subjects(sweep, &mut faults);
    if !faults.is_empty() {
        return Err(faults.into());
    }
    let settings = Setting::each(&variants, &resolutions);
    let Some((first, resolution)) = settings.first().zip(resolutions.iter().max()) else {
        return Err(Fault::new("nothing to compare: no format, encoding or resolution").into());
    };
    let finest = Setting { resolution: *resolution, ..first.clone() };
    let mut cells = Vec::new();
    for (subject, Subject { facts, emission, .. }) in subjects.iter().enumerate() {
        let there = |effect: &&Effect<'_>| {
            effect.entry.when.as_ref().is_none_or(|when| facts.meets(&when.value, *emission))
        };
        for &effect in effects.iter().filter(there) {
            cells.extend(settings.iter().map(|setting| Cell { subject, effect, setting: setting.clone() }));
        }
    }
    if cells.is_empty() {
        let fault = Fault::new("nothing to compare: no scene and the pipeline have one of these effects");
        return Err(fault.note(one_of(effects.iter().map(|effect| effect.name))).into());
    }
    Ok(Cells { subjects, cells, finest })
}

/// The effects asked for, in the order of the pipeline's file.
fn effects<'p>(sweep: &Sweep<'p>, faults: &mut Faults) -> Vec<Effect<'p>> {
    let all = Effect::all(sweep.settings.pipeline);
    let names: Vec<&str> = all.iter().map(|effect| effect.name).collect();
    for (index, effect) in all.iter().enumerate().filter(|(i, effect)| names[..*i].contains(&effect.name)) {
        let message = format!("two images would be compared as `{}`", names[index]);
        faults.push(sweep.settings.pipeline.fault(
            &effect.entry.run.span,
            message,
            "the second; give the effect another `name`",
        ));
    }
    let asked = words("effect", &sweep.effects, &names, faults);
    all.into_iter().filter(|effect| asked.iter().any(|word| word == effect.name)).collect()
}

fn subjects(sweep: &Sweep<'_>, faults: &mut Faults) -> Vec<Subject> {
    let Settings { registry, pipeline, size: [width, height], .. } = sweep.settings;
    let mut subjects: Vec<Subject> = Vec::new();
    for (path, label) in sweep.scenes.iter().zip(labels(&sweep.scenes)) {
        if subjects.iter().any(|subject| subject.label == label) {
            faults.push(Fault::new(format!("scene `{}` is given twice", path.display())));
            continue;
        }
        let Some(scene) = faults.gather(Scene::load(path)) else { continue };
        let Some(camera) = faults.gather(scene.camera(sweep.camera.as_deref()).cloned()) else { continue };
        let Some(facts) = faults.gather(SceneFacts::of(&scene)) else { continue };
        // What is wrong with the pipeline or the size is so in every cell.
        let plan = faults.gather(voxlume::plan(pipeline, &facts, registry, &Request::image(width, height)));
        let emission = plan.map_or(Emission::Gathered, |plan| plan.emission);
        let digest = SceneDigest::of(&scene);
        subjects.push(Subject { label, scene, digest, facts, camera, emission });
    }
    subjects
}

/// Names of scenes for files: their stems, or where two are the same their paths.
fn labels(paths: &[PathBuf]) -> Vec<String> {
    let plain = |text: &str| -> String {
        text.chars().map(|c| if c.is_alphanumeric() || ".-_".contains(c) { c } else { '_' }).collect()
    };
    let stem = |path: &Path| plain(&path.file_stem().unwrap_or_default().to_string_lossy());
    let alone = |path: &Path| paths.iter().filter(|other| stem(other) == stem(path)).count() == 1;
    let label = |path: &PathBuf| if alone(path) { stem(path) } else { plain(&path.to_string_lossy()) };
    paths.iter().map(label).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scenes_of_one_name_are_told_apart_by_their_paths() {
        let labels = |paths: &[&str]| labels(&paths.iter().map(PathBuf::from).collect::<Vec<_>>());
        assert_eq!(labels(&["a/box.ron", "b/my room.glb"]), ["box", "my_room"]);
        assert_eq!(labels(&["a/box.ron", "b/box.glb"]), ["a_box.ron", "b_box.glb"]);
    }
}
