//! Frames that are timed.

use std::fmt;

use voxlume::{
    Error, Frame, Gpu, PassTime, Passes, Pipeline, Plan, Registry, Renderer, Request, ResourceKind, Scene,
    SceneFacts, plan,
};
use voxlume_benches::table::digits;
use voxlume_measure::Frames;

use crate::arguments::Change;
use crate::scenes::{Room, move_lamp, move_object};

/// Median and interquartile range over some frames, milliseconds.
#[derive(Clone, Copy, Debug)]
pub struct Time {
    pub median: f64,
    pub spread: f64,
}

impl fmt::Display for Time {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.spread > 0.0 {
            true => write!(f, "{} ± {}", digits(self.median), digits(self.spread / 2.0)),
            false => f.write_str(&digits(self.median)),
        }
    }
}

/// How a scene is rendered.
#[derive(Clone, Copy, Debug)]
pub struct Setting<'a> {
    pub format: &'a str,
    pub tracer: &'a str,
    pub resolution: u32,
    pub size: [u32; 2],
}

/// What frames are timed with.
#[derive(Debug)]
pub struct Timer {
    pub gpu: Gpu,
    pub pipeline: Pipeline,
    pub registry: Registry,
    pub repeat: u32,
}

/// The heads of the columns that [`Timer::row`] fills.
pub fn heads(changes: &[Change]) -> Vec<String> {
    let heads = changes.iter().flat_map(|change| match change {
        Change::Everything => &["everything", "all but voxelization"][..],
        Change::Object => &["an object moves"],
        Change::Lamp => &["a lamp moves"],
        Change::Camera => &["the camera moves"],
        Change::Nothing => &["nothing moves"],
    });
    heads.map(|head| (*head).to_owned()).collect()
}

impl Timer {
    /// What a plan is asked for.
    pub fn request(&self, setting: &Setting<'_>) -> Request {
        let Setting { format, tracer, resolution, size: [width, height] } = *setting;
        Request {
            format: Some(format.to_owned()),
            tracer: Some(tracer.to_owned()),
            resolution: Some(resolution),
            filters_float32: self.gpu.filters_float32(),
            ..Request::image(width, height)
        }
    }

    /// Whether the format changes anything: tracers that read voxels alone leave its volumes out.
    pub fn reads_format(&self, scene: &Scene, setting: &Setting<'_>) -> Result<bool, String> {
        let plan = self.plan(scene, &self.request(setting))?;
        Ok(plan.resources.iter().any(|resource| matches!(resource.kind, ResourceKind::Volume { .. })))
    }

    /// The time of all passes that a frame runs, after each of the changes.
    pub fn row(&self, scene: &Scene, request: &Request, changes: &[Change]) -> Result<Vec<Time>, String> {
        let mut times = Vec::new();
        let mut still = None;
        for change in changes {
            let add_object = |room: &Room, scene: &mut Scene| room.add_object(scene, [25, 20], true);
            let add_lamp = |room: &Room, scene: &mut Scene| room.add_lamps(scene, 1);
            let frames = match change {
                Change::Object => self.moving(scene, request, add_object, move_object)?,
                Change::Lamp => self.moving(scene, request, add_lamp, move_lamp)?,
                Change::Everything | Change::Camera | Change::Nothing => {
                    let renderer = match &mut still {
                        Some(renderer) => renderer,
                        none => none.insert(self.renderer(scene, request)?),
                    };
                    self.still(renderer, scene, *change)?
                }
            };
            times.push(time(&frames, |_| true));
            if *change == Change::Everything {
                times.push(time(&frames, |pass| pass.name != "voxelize"));
            }
        }
        Ok(times)
    }

    /// Frames of a scene in which nothing but the camera moves.
    fn still(&self, renderer: &mut Renderer<'_>, scene: &Scene, change: Change) -> Result<Passed, String> {
        let mut camera = scene.cameras[0].clone();
        let step = Room::of(scene)?.step();
        self.frames(|| {
            if change == Change::Camera {
                camera.eye.x += step;
            }
            let passes = if change == Change::Everything { Passes::All } else { Passes::Changed };
            renderer.frame(&Frame { passes, ..Frame::of(&camera) })
        })
    }

    /// Frames of a scene to which something is added that then moves.
    fn moving(
        &self,
        scene: &Scene,
        request: &Request,
        add: impl Fn(&Room, &mut Scene),
        shift: impl Fn(&mut Scene, f64),
    ) -> Result<Passed, String> {
        let room = Room::of(scene)?;
        let mut scene = scene.clone();
        add(&room, &mut scene);
        let camera = scene.cameras[0].clone();
        let mut renderer = self.renderer(&scene, request)?;
        self.frames(|| {
            shift(&mut scene, room.step());
            renderer.render(&scene, &camera, Passes::Changed)
        })
    }

    fn frames(&self, mut frame: impl FnMut() -> Result<Vec<PassTime>, Error>) -> Result<Passed, String> {
        // The first warms up.
        frame().map_err(|error| error.to_string())?;
        (0..self.repeat).map(|_| frame().map_err(|error| error.to_string())).collect()
    }

    fn renderer(&self, scene: &Scene, request: &Request) -> Result<Renderer<'_>, String> {
        Renderer::new(&self.gpu, self.plan(scene, request)?, scene).map_err(|error| error.to_string())
    }

    fn plan(&self, scene: &Scene, request: &Request) -> Result<Plan, String> {
        let facts = SceneFacts::of(scene).map_err(|faults| faults.to_string())?;
        plan(&self.pipeline, &facts, &self.registry, request).map_err(|faults| faults.to_string())
    }
}

/// Of each frame, the passes that ran.
type Passed = Vec<Vec<PassTime>>;

/// Of the passes that count.
fn time(frames: &Passed, counts: impl Fn(&PassTime) -> bool) -> Time {
    let mut counted = Frames::default();
    for frame in frames {
        counted.push(frame.iter().filter(|pass| counts(pass)).cloned().collect(), 0.0);
    }
    let (median, spread) = counted.total();
    Time { median, spread }
}
