//! Random numbers that depend on the pixel and the sample alone, never on the order of work.

/// Uniform numbers for one sample of one pixel: PCG-XSH-RR 64/32 (O'Neill 2014, "PCG: A Family of
/// Simple Fast Space-Efficient Statistically Good Algorithms"), its state and stream being hashes
/// of the seed, the pixel and the sample.
pub(crate) struct Rng {
    state: u64,
    increment: u64,
}

impl Rng {
    pub(crate) fn new(seed: u64, pixel: u64, sample: u64) -> Self {
        let state = mix(mix(mix(seed) ^ pixel) ^ sample);
        Rng { state, increment: mix(state) | 1 }
    }

    /// Uniform over all 32-bit words.
    pub(crate) fn word(&mut self) -> u32 {
        let old = self.state;
        self.state = old.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(self.increment);
        let shifted = (((old >> 18) ^ old) >> 27) as u32;
        shifted.rotate_right((old >> 59) as u32)
    }

    /// Uniform in [0,1), a multiple of 2⁻²⁴.
    pub(crate) fn uniform(&mut self) -> f32 {
        (self.word() >> 8) as f32 * (1.0 / 16_777_216.0)
    }

    /// Uniform in [0,1)².
    pub(crate) fn square(&mut self) -> [f32; 2] {
        [self.uniform(), self.uniform()]
    }
}

/// SplitMix64 (Steele, Lea and Flood 2014).
fn mix(x: u64) -> u64 {
    let x = x.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    x ^ (x >> 31)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn neighbouring_pixels_samples_and_seeds_are_uncorrelated() {
        let first = |seed, pixel, sample| f64::from(Rng::new(seed, pixel, sample).uniform()) - 0.5;
        let n = 20_000u64;
        // The correlation of two independent uniform sequences of n numbers has deviation 1/sqrt(n).
        let limit = 4.0 / (n as f64).sqrt();
        let correlation =
            |f: &dyn Fn(u64) -> (f64, f64)| (0..n).map(f).map(|(a, b)| 12.0 * a * b).sum::<f64>() / n as f64;
        assert!(correlation(&|i| (first(1, i, 0), first(1, i + 1, 0))).abs() < limit);
        assert!(correlation(&|i| (first(1, i, 0), first(1, i, 1))).abs() < limit);
        assert!(correlation(&|i| (first(1, i, 0), first(2, i, 0))).abs() < limit);
        assert!(correlation(&|i| (first(1, 0, i), first(1, 0, i + 1))).abs() < limit);
        let mean = (0..n).map(|i| first(7, i, 3)).sum::<f64>() / n as f64;
        assert!(mean.abs() < limit);
    }
}
