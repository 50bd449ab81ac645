//! Results as CSV (RFC 4180), one line a row.

use crate::results::{Outcome, Results};

const HEAD: &str = "scene,effect,format,encoding,tracer,resolution,scale,width,height,total_ms,volume_bytes,rmse,rel_mse,bias,\
                    bias_rel,p99,flip,reference_se,note,fault";

/// `results.csv`. Figures that there are not stay empty; passes are left to the JSON.
pub fn csv(results: &Results) -> String {
    let mut text = HEAD.to_owned() + "\r\n";
    for row in &results.rows {
        let mut fields = vec![
            field(&row.scene),
            field(&row.effect),
            field(&row.format),
            field(&row.encoding),
            field(&row.tracer),
            row.resolution.to_string(),
            row.scale.map(|scale| scale.to_string()).unwrap_or_default(),
            row.width.to_string(),
            row.height.to_string(),
        ];
        match &row.outcome {
            Outcome::Measured { passes: _, total_ms, volume_bytes, error, .. } => {
                let optional = |value: Option<f64>| value.map(|v| v.to_string()).unwrap_or_default();
                fields.extend([
                    total_ms.to_string(),
                    volume_bytes.to_string(),
                    error.rmse.to_string(),
                    optional(error.rel_mse),
                    error.bias.to_string(),
                    optional(error.bias_rel),
                    error.p99.to_string(),
                    error.flip.to_string(),
                    error.reference_se.to_string(),
                    field(&row.note()),
                    String::new(),
                ]);
            }
            Outcome::Failed { fault } => {
                fields.extend(std::iter::repeat_n(String::new(), 10));
                fields.push(field(fault));
            }
        }
        text += &(fields.join(",") + "\r\n");
    }
    text
}

fn field(text: &str) -> String {
    if text.contains([',', '"', '\n', '\r']) {
        format!("\"{}\"", text.replace('"', "\"\""))
    } else {
        text.to_owned()
    }
}

#[cfg(test)]
mod tests {
    use crate::results::tests::results;

    #[test]
    fn lines() {
        let text = super::csv(&results());
        let lines: Vec<&str> = text.split("\r\n").collect();
        assert_eq!(
            lines[1],
            "cornell,diffuse,isotropic,rgba16float,rays,64,,32,16,2,4096,1,0.5,-0.25,,2,0.125,0.0625,,"
        );
        assert_eq!(
            lines[2],
            "cornell,diffuse,sh2,rgba16float,rays,64,,32,16,,,,,,,,,,,\"too <large>, \"\"so\"\"\""
        );
        assert!(lines.iter().take(2).all(|line| line.matches(',').count() == 19));
        assert_eq!(lines[3], "");
    }
}
