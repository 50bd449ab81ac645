//! Files that must be refused.

use super::{Figure, Figures};
use crate::stability::bench::scene;

/// 1 if the file is accepted, or refused without the place.
pub fn refused(file: (&str, &str)) -> Figures {
    let told = scene(file).err().is_some_and(|faults| faults.to_string().contains(&format!("{}:", file.0)));
    Ok(vec![Figure::at_most("accepted", f64::from(u8::from(!told)), 0.0)])
}
