//! What hard cases gave, version 1 of its JSON.

use serde::Serialize;

use crate::results::{Device, SCHEMA};

/// All figures of a run on one device.
#[derive(Clone, Debug, Serialize)]
pub struct Stability {
    schema: u32,
    /// What it ran on.
    pub device: Device,
    /// One for each figure.
    pub rows: Vec<StabilityRow>,
}

/// One figure of a hard case.
#[derive(Clone, Debug, Serialize)]
pub struct StabilityRow {
    /// The case's name.
    pub case: String,
    /// Storage format.
    pub format: String,
    /// Texel encoding.
    pub encoding: String,
    /// Tracer.
    pub tracer: String,
    /// Voxels along the grid's longest side.
    pub resolution: u32,
    /// What was measured.
    pub figure: String,
    /// What it gave; JSON has `null` for a NaN.
    pub value: f64,
    /// What its size may be at most; `None` where it is only measured.
    pub bound: Option<f64>,
    /// Whether it is within its bound.
    pub pass: bool,
    /// Why it is not, where that is known.
    #[serde(skip)]
    pub reason: Option<String>,
    /// The place in a sweep: what is swept, with its unit, and its value.
    #[serde(skip)]
    pub at: Option<(&'static str, f64)>,
}

impl Stability {
    /// No figures yet.
    pub fn new(device: Device) -> Stability {
        Stability { schema: SCHEMA, device, rows: Vec::new() }
    }

    /// The text of the JSON file.
    ///
    /// # Errors
    /// None that is known of: numbers that JSON can't hold become `null`.
    pub fn to_json(&self) -> Result<String, serde_json::Error> {
        Ok(serde_json::to_string_pretty(self)? + "\n")
    }
}

impl StabilityRow {
    /// The verdict in a word.
    pub fn verdict(&self) -> &'static str {
        match (self.pass, self.bound, &self.reason) {
            (true, None, _) => "measured",
            (true, Some(_), _) => "pass",
            (false, _, Some(_)) => "known miss",
            (false, _, None) => "FAIL",
        }
    }
}

#[cfg(test)]
pub(crate) mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    pub(crate) fn stability() -> Stability {
        let device =
            Device { name: "llvmpipe".into(), kind: "software device".into(), driver: "Mesa 22.3".into() };
        let row = |value: f64, bound: Option<f64>, at: f64| StabilityRow {
            case: "leak".into(),
            format: "six_face".into(),
            encoding: "rgba16float".into(),
            tracer: "rays".into(),
            resolution: 32,
            figure: format!("leak at {at} voxels"),
            value,
            bound,
            pass: bound.is_none_or(|bound| value <= bound),
            reason: None,
            at: Some(("wall, voxels", at)),
        };
        let mut stability = Stability::new(device);
        stability.rows =
            vec![row(0.0005, Some(0.001), 1.0), row(0.25, None, 0.5), row(f64::NAN, Some(0.1), 2.0)];
        stability
    }

    #[test]
    fn json_is_of_the_documented_form() {
        let row = |value: Option<f64>, bound: Option<f64>, figure: &str, pass: bool| {
            serde_json::json!({
                "case": "leak", "format": "six_face", "encoding": "rgba16float", "tracer": "rays", "resolution": 32,
                "figure": figure, "value": value, "bound": bound, "pass": pass
            })
        };
        let expected = serde_json::json!({
            "schema": 1,
            "device": {"name": "llvmpipe", "type": "software device", "driver": "Mesa 22.3"},
            "rows": [
                row(Some(0.0005), Some(0.001), "leak at 1 voxels", true),
                row(Some(0.25), None, "leak at 0.5 voxels", true),
                row(None, Some(0.1), "leak at 2 voxels", false),
            ]
        });
        let text = stability().to_json().unwrap();
        assert_eq!(serde_json::from_str::<serde_json::Value>(&text).unwrap(), expected);
    }

    #[test]
    fn verdicts() {
        let verdicts: Vec<_> = stability().rows.iter().map(StabilityRow::verdict).collect();
        assert_eq!(verdicts, ["pass", "measured", "FAIL"]);
    }
}
