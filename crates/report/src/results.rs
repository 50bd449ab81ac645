//! What comparisons gave, version 1 of its JSON.

use serde::{Deserialize, Serialize};

use crate::metric::Errors;

/// The version of the JSON that is written and read.
pub const SCHEMA: u32 = 1;

/// All rows of a sweep on one device.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Results {
    /// [`SCHEMA`].
    pub schema: u32,
    /// What it ran on.
    pub device: Device,
    /// One for each scene, effect, format, encoding, tracer, resolution and scale.
    pub rows: Vec<Row>,
}

/// A device.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Device {
    /// Its own name.
    pub name: String,
    /// In words: `software device`, `discrete GPU` …
    #[serde(rename = "type")]
    pub kind: String,
    /// Name and version of its driver.
    pub driver: String,
}

/// One comparison.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Row {
    /// The scene's name.
    pub scene: String,
    /// The effect's name in its pipeline, or `final`.
    pub effect: String,
    /// Storage format.
    pub format: String,
    /// Texel encoding.
    pub encoding: String,
    /// Tracer; results from before there was a choice have none, and were traced by cones.
    #[serde(default = "cones")]
    pub tracer: String,
    /// Voxels along the grid's longest side.
    pub resolution: u32,
    /// What the screen's size was divided by where tracing effects gather; absent where the pipeline says it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub scale: Option<u32>,
    /// Width of the screen in pixels.
    pub width: u32,
    /// Height of the screen in pixels.
    pub height: u32,
    /// The setting whose image this one is held against, as [`Row::setting`] says it; absent for the reference.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub held_against: Option<String>,
    /// Figures, or why there are none.
    #[serde(flatten)]
    pub outcome: Outcome,
}

/// What a comparison gave.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum Outcome {
    /// It worked.
    Measured {
        /// In the order of execution: those that the effect needs.
        passes: Vec<Pass>,
        /// Median over the frames of the sum of all passes, milliseconds.
        total_ms: f64,
        /// Bytes of the storage format's 3D textures.
        volume_bytes: u64,
        /// What the encoding could not hold, if anything.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        out_of_range: Option<OutOfRange>,
        /// Against the reference.
        error: Errors,
    },
    /// It failed.
    Failed {
        /// Why.
        fault: String,
    },
}

/// Values that an encoding clamped.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct OutOfRange {
    /// Texels with such a value.
    pub texels: u32,
    /// The largest, without its sign.
    pub worst: f32,
}

impl Row {
    /// Format, encoding, resolution, tracer and scale.
    pub fn setting(&self) -> String {
        setting_words(&self.format, &self.encoding, &self.tracer, self.resolution, self.scale)
    }

    /// What to keep in mind about the figures; empty where there is nothing.
    pub fn note(&self) -> String {
        let Outcome::Measured { out_of_range, error, .. } = &self.outcome else { return String::new() };
        let against = self.held_against.as_ref().map(|setting| {
            let other = if *setting == self.setting() { "itself" } else { setting };
            format!("held against {other}")
        });
        let clamped = out_of_range
            .map(|OutOfRange { texels, worst }| format!("{texels} texels clamped (worst value {worst})"));
        let noise = error.note().map(|note| note.to_string());
        against.into_iter().chain(clamped).chain(noise).collect::<Vec<_>>().join("; ")
    }
}

/// A setting in words: `isotropic rgba16float 128³ rays 1/2`.
pub fn setting_words(
    format: &str,
    encoding: &str,
    tracer: &str,
    resolution: u32,
    scale: Option<u32>,
) -> String {
    let scale = scale.map(|scale| format!(" 1/{scale}")).unwrap_or_default();
    format!("{format} {encoding} {resolution}³ {tracer}{scale}")
}

fn cones() -> String {
    "cones".to_owned()
}

/// A pass's time over the frames.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Pass {
    /// Its name in the pipeline.
    pub name: String,
    /// Median, milliseconds.
    pub median_ms: f64,
    /// Interquartile range, milliseconds.
    pub spread_ms: f64,
    /// `gpu` for the device's timestamps, `wall` for the host's clock.
    pub clock: String,
}

/// Why a text is no results.
#[derive(Debug, thiserror::Error)]
pub enum ResultsError {
    /// Of another version.
    #[error("results of schema {0}: this program reads schema {SCHEMA}")]
    Schema(u64),
    /// Not of the form.
    #[error("no results: {0}")]
    Form(#[from] serde_json::Error),
}

impl Results {
    /// Reads `results.json`.
    ///
    /// # Errors
    /// Another schema version, or anything else that is not of the form.
    pub fn parse(text: &str) -> Result<Results, ResultsError> {
        #[derive(Deserialize)]
        struct Version {
            schema: u64,
        }
        // Alone first, as another version may differ in everything else.
        let version: Version = serde_json::from_str(text)?;
        if version.schema != u64::from(SCHEMA) {
            return Err(ResultsError::Schema(version.schema));
        }
        Ok(serde_json::from_str(text)?)
    }

    /// How many comparisons failed.
    pub fn failed(&self) -> usize {
        self.rows.iter().filter(|row| matches!(row.outcome, Outcome::Failed { .. })).count()
    }

    /// The text of `results.json`.
    ///
    /// # Errors
    /// A figure that JSON can't hold.
    pub fn to_json(&self) -> Result<String, ResultsError> {
        Ok(serde_json::to_string_pretty(self)? + "\n")
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
pub(crate) mod tests {
    use super::*;

    pub(crate) fn row(format: &str, total_ms: f64, rmse: f64) -> Row {
        Row {
            scene: "cornell".into(),
            effect: "diffuse".into(),
            format: format.into(),
            encoding: "rgba16float".into(),
            tracer: "rays".into(),
            resolution: 64,
            scale: None,
            width: 32,
            height: 16,
            held_against: None,
            outcome: Outcome::Measured {
                passes: vec![Pass {
                    name: "voxelize".into(),
                    median_ms: 1.5,
                    spread_ms: 0.25,
                    clock: "gpu".into(),
                }],
                total_ms,
                volume_bytes: 4096,
                out_of_range: None,
                error: Errors {
                    rmse,
                    rel_mse: Some(0.5),
                    bias: -0.25,
                    bias_rel: None,
                    p99: 2.0,
                    flip: 0.125,
                    reference_se: 0.0625,
                },
            },
        }
    }

    pub(crate) fn results() -> Results {
        let failed =
            Row { outcome: Outcome::Failed { fault: "too <large>, \"so\"".into() }, ..row("sh2", 0.0, 0.0) };
        let device =
            Device { name: "llvmpipe".into(), kind: "software device".into(), driver: "Mesa 22.3".into() };
        Results { schema: SCHEMA, device, rows: vec![row("isotropic", 2.0, 1.0), failed] }
    }

    #[test]
    fn json_is_of_the_documented_form() {
        let expected = serde_json::json!({
            "schema": 1,
            "device": {"name": "llvmpipe", "type": "software device", "driver": "Mesa 22.3"},
            "rows": [
                {
                    "scene": "cornell", "effect": "diffuse", "format": "isotropic", "encoding": "rgba16float",
                    "tracer": "rays", "resolution": 64, "width": 32, "height": 16,
                    "passes": [{"name": "voxelize", "median_ms": 1.5, "spread_ms": 0.25, "clock": "gpu"}],
                    "total_ms": 2.0, "volume_bytes": 4096,
                    "error": {
                        "rmse": 1.0, "rel_mse": 0.5, "bias": -0.25, "bias_rel": null, "p99": 2.0, "flip": 0.125,
                        "reference_se": 0.0625
                    }
                },
                {
                    "scene": "cornell", "effect": "diffuse", "format": "sh2", "encoding": "rgba16float",
                    "tracer": "rays", "resolution": 64, "width": 32, "height": 16, "fault": "too <large>, \"so\""
                }
            ]
        });
        let text = results().to_json().unwrap();
        assert_eq!(serde_json::from_str::<serde_json::Value>(&text).unwrap(), expected);
        assert_eq!(Results::parse(&text).unwrap(), results());
    }

    #[test]
    fn results_without_a_tracer_are_of_cones() {
        let text = results().to_json().unwrap().replace("\"tracer\": \"rays\",", "");
        assert_eq!(Results::parse(&text).unwrap().rows[0].tracer, "cones");
    }

    #[test]
    fn another_schema_is_refused_by_name() {
        let message = |text| Results::parse(text).unwrap_err().to_string();
        assert_eq!(
            message(r#"{"schema": 2, "everything": "else"}"#),
            "results of schema 2: this program reads schema 1"
        );
        assert_eq!(message("{}"), "no results: missing field `schema` at line 1 column 2");
    }
}
