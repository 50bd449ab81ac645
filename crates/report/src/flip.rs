//! FLIP (Andersson et al. 2020), by NVIDIA's implementation.

use crate::comparison::Shown;

/// Mean over the counted pixels, of which there is at least one. Sizes have been checked.
pub(crate) fn flip(width: u32, height: u32, counted: &[bool], shown: &Shown<'_>) -> f64 {
    let mut image = shown.image.to_vec();
    for (index, counts) in counted.iter().enumerate() {
        if !counts {
            image[3 * index..3 * index + 3].copy_from_slice(&shown.reference[3 * index..3 * index + 3]);
        }
    }
    let reference = nv_flip::FlipImageRgb8::with_data(width, height, shown.reference);
    let image = nv_flip::FlipImageRgb8::with_data(width, height, &image);
    let map = nv_flip::flip(reference, image, nv_flip::DEFAULT_PIXELS_PER_DEGREE).to_vec();
    let values = map.iter().zip(counted).filter(|(_, counts)| **counts).map(|(value, _)| f64::from(*value));
    let count = counted.iter().filter(|counts| **counts).count();
    values.sum::<f64>() / count as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(image: [u8; 3], reference: [u8; 3], counted: &[bool; 256]) -> f64 {
        flip(16, 16, counted, &Shown { image: &image.repeat(256), reference: &reference.repeat(256) })
    }

    #[test]
    fn equal_is_zero_and_white_on_black_is_one() {
        assert_eq!(of([80, 120, 9], [80, 120, 9], &[true; 256]), 0.0);
        let far = of([255; 3], [0; 3], &[true; 256]);
        assert!((0.9..=1.0).contains(&far), "{far}");
        let near = of([128; 3], [120; 3], &[true; 256]);
        assert!(near > 0.01 && near < 0.2, "{near}");
    }

    #[test]
    fn what_does_not_count_takes_the_references_colour() {
        let mut image = [120; 768];
        image[3..].fill(9);
        let mut counted = [false; 256];
        counted[0] = true;
        assert_eq!(flip(16, 16, &counted, &Shown { image: &image, reference: &[120; 768] }), 0.0);
        assert!(flip(16, 16, &[true; 256], &Shown { image: &image, reference: &[120; 768] }) > 0.1);
    }
}
