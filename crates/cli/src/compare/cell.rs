//! The cells of a sweep.

use std::path::{Path, PathBuf};

use voxlume::{Camera, Fault, Faults, Grid, Pipeline, Request, Scene, SceneFacts, check_variant, one_of};
use voxlume_reference::cache::SceneDigest;

use super::Args;
use crate::Registry;
use crate::effect::Effect;
use crate::failure::Failure;
use crate::render::camera;
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
}

/// One comparison.
#[derive(Clone, Debug)]
pub struct Cell {
    /// In the list of subjects.
    pub subject: usize,
    pub effect: Effect,
    pub format: String,
    pub encoding: String,
    pub resolution: u32,
}

impl Cell {
    /// The stem of its files.
    pub fn stem(&self, subjects: &[Subject]) -> String {
        let Cell { subject, effect, format, encoding, resolution } = self;
        let label = &subjects[*subject].label;
        // Options have characters that files' names can't have everywhere.
        let [format, encoding] = [format, encoding].map(|word| word.replace(':', "+"));
        format!("{label}-{}-{format}-{encoding}-{resolution}", effect.name())
    }
}

/// Loads the scenes, and finds out which cells there are.
pub fn cells(
    args: &Args,
    registry: &Registry,
    pipeline: &Pipeline,
) -> Result<(Vec<Subject>, Vec<Cell>), Failure> {
    let mut faults = Faults::default();
    let known = &registry.formats;
    let names: Vec<&str> = known.iter().map(|format| format.name()).collect();
    let formats = words("storage format", &args.formats, &names, &mut faults);
    let known_encodings: Vec<&str> = registry.encodings.iter().map(|encoding| encoding.name).collect();
    let encodings = if args.encodings.is_empty() {
        vec![pipeline.encoding.value.clone()]
    } else {
        words("encoding", &args.encodings, &known_encodings, &mut faults)
    };
    if faults.is_empty() {
        for format in &formats {
            faults.gather(check_variant(pipeline, registry, format, known_encodings[0]));
        }
        for encoding in &encodings {
            faults.gather(check_variant(pipeline, registry, names[0], encoding));
        }
    }
    let all_effects = Effect::ALL.map(Effect::name);
    let effects = words("effect", &args.effects, &all_effects, &mut faults);
    let effects: Vec<Effect> =
        Effect::ALL.into_iter().filter(|effect| effects.iter().any(|word| word == effect.name())).collect();
    let mut resolutions: Vec<u32> = Vec::new();
    for &resolution in &args.resolutions {
        if Grid::RESOLUTIONS.contains(&resolution) {
            if !resolutions.contains(&resolution) {
                resolutions.push(resolution);
            }
            continue;
        }
        let fault = Fault::new(format!("a grid of {resolution} × {resolution} × {resolution} voxels"));
        faults.push(fault.note(Grid::resolution_range()));
    }
    let subjects = subjects(args, &mut faults);
    let [width, height] = args.size;
    for subject in &subjects {
        // What is wrong with the pipeline or the size is so in every cell.
        let request = Request { tracer: args.tracer.clone(), ..Request::image(width, height) };
        faults.gather(voxlume::plan(pipeline, &subject.facts, registry, &request));
    }
    if !faults.is_empty() {
        return Err(faults.into());
    }

    let mut cells = Vec::new();
    for (subject, Subject { facts, .. }) in subjects.iter().enumerate() {
        for &effect in &effects {
            if !effect.applies(facts) || effect.image(pipeline).is_none() {
                continue;
            }
            for format in &formats {
                for encoding in &encodings {
                    cells.extend(resolutions.iter().map(|&resolution| Cell {
                        subject,
                        effect,
                        format: format.clone(),
                        encoding: encoding.clone(),
                        resolution,
                    }));
                }
            }
        }
    }
    if cells.is_empty() {
        let fault = Fault::new("nothing to compare: no scene and the pipeline have one of these effects");
        return Err(fault.note(one_of(effects.iter().map(|effect| effect.name()))).into());
    }
    Ok((subjects, cells))
}

fn subjects(args: &Args, faults: &mut Faults) -> Vec<Subject> {
    let mut subjects: Vec<Subject> = Vec::new();
    for (path, label) in args.scenes.iter().zip(labels(&args.scenes)) {
        if subjects.iter().any(|subject| subject.label == label) {
            faults.push(Fault::new(format!("scene `{}` is given twice", path.display())));
            continue;
        }
        let Some(scene) = faults.gather(Scene::load(path)) else { continue };
        let Some(camera) = faults.gather(camera(&scene, args.camera.as_deref()).cloned()) else { continue };
        let Some(facts) = faults.gather(SceneFacts::of(&scene)) else { continue };
        let digest = SceneDigest::of(&scene);
        subjects.push(Subject { label, scene, digest, facts, camera });
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
