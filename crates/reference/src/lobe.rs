//! How a surface point scatters light, in its local frame (normal +z).

use glam::Vec3;

use std::f32::consts::FRAC_1_PI;

use crate::ggx;
use crate::rng::Rng;
use crate::sampling::{cosine_hemisphere, luminance};

/// A scattering function over the hemisphere above the surface.
#[derive(Clone, Copy)]
pub(crate) enum Lobe {
    /// Lambert: `albedo / π`.
    Lambert(Vec3),
    /// glTF 2.0 appendix B: Lambert under GGX, joined by Fresnel.
    Gltf {
        /// `c_diff`
        diffuse: Vec3,
        f0: Vec3,
        alpha: f32,
    },
    /// The density of the mirror directions about GGX's visible normals, restricted to those above
    /// the surface and normalised to 1.
    MirrorDirections {
        alpha: f32,
        /// How many mirror directions it took to find one above the surface. Its mean over many lobes is
        /// the reciprocal of the share above, so that it normalises without bias.
        tries: f32,
    },
}

/// A sampled direction.
pub(crate) struct Scattered {
    pub(crate) direction: Vec3,
    /// Scattering function × cosine / density.
    pub(crate) weight: Vec3,
    /// Per solid angle; that of mirror directions before they are restricted.
    pub(crate) pdf: f32,
}

/// Most tries at a mirror direction above the surface, of which at least about half succeed.
const MIRROR_TRIES: u32 = 64;

impl Lobe {
    /// The lobe of mirror directions around `out`'s.
    pub(crate) fn mirror_directions(out: Vec3, alpha: f32, rng: &mut Rng) -> Self {
        let (tries, _) = mirror_above(out, alpha, rng);
        Lobe::MirrorDirections { alpha, tries }
    }

    /// Scattering function × cosine, and the density of [`Scattered::pdf`] at `into`.
    pub(crate) fn evaluate(&self, out: Vec3, into: Vec3) -> (Vec3, f32) {
        if into.z <= 0.0 {
            return (Vec3::ZERO, 0.0);
        }
        let lambert = into.z * FRAC_1_PI;
        match *self {
            Lobe::Lambert(albedo) => (albedo * lambert, lambert),
            Lobe::Gltf { diffuse, f0, alpha } => {
                let half = (out + into).normalize_or(Vec3::Z);
                let fresnel = ggx::schlick(f0, into.dot(half).abs());
                let base = (Vec3::ONE - fresnel) * diffuse * lambert;
                let chance = specular_chance(diffuse, f0, out);
                if out.z <= 0.0 {
                    return (base, (1.0 - chance) * lambert);
                }
                let specular = ggx::distribution(half, alpha) * ggx::visibility(out.z, into.z, alpha);
                let pdf = chance * ggx::mirror_pdf(out.z, half, alpha) + (1.0 - chance) * lambert;
                (base + fresnel * specular * into.z, pdf)
            }
            Lobe::MirrorDirections { alpha, tries } => {
                let out = raised(out);
                let pdf = ggx::mirror_pdf(out.z, (out + into).normalize_or(Vec3::Z), alpha);
                (Vec3::splat(pdf * tries), pdf)
            }
        }
    }

    /// A direction with density near the scattering function × cosine; none if it leaves the hemisphere.
    pub(crate) fn sample(&self, out: Vec3, rng: &mut Rng) -> Option<Scattered> {
        match *self {
            Lobe::Lambert(albedo) => {
                let direction = cosine_hemisphere(rng.square());
                let pdf = direction.z * FRAC_1_PI;
                (pdf > 0.0).then_some(Scattered { direction, weight: albedo, pdf })
            }
            Lobe::Gltf { diffuse, f0, alpha } => {
                let direction = if rng.uniform() < specular_chance(diffuse, f0, out) {
                    ggx::sample_mirror(out, alpha, rng.square())
                } else {
                    cosine_hemisphere(rng.square())
                };
                let (value, pdf) = self.evaluate(out, direction);
                (pdf > 0.0).then(|| Scattered { direction, weight: value / pdf, pdf })
            }
            Lobe::MirrorDirections { alpha, .. } => {
                let (_, direction) = mirror_above(out, alpha, rng);
                let (_, pdf) = self.evaluate(out, direction);
                (pdf > 0.0).then_some(Scattered { direction, weight: Vec3::ONE, pdf })
            }
        }
    }
}

/// A mirror direction above the surface, and the number of tries that it took.
fn mirror_above(out: Vec3, alpha: f32, rng: &mut Rng) -> (f32, Vec3) {
    let out = raised(out);
    for tries in 1..MIRROR_TRIES {
        let direction = ggx::sample_mirror(out, alpha, rng.square());
        if direction.z > 0.0 {
            return (tries as f32, direction);
        }
    }
    (MIRROR_TRIES as f32, Vec3::new(-out.x, -out.y, out.z))
}

/// An interpolated normal may lean away from the eye; its lobe is then that of grazing light.
fn raised(out: Vec3) -> Vec3 {
    Vec3 { z: out.z.max(1e-4), ..out }.normalize()
}

/// How often the specular part is sampled: its share of the reflected light for a mirror at `out`.
fn specular_chance(diffuse: Vec3, f0: Vec3, out: Vec3) -> f32 {
    if out.z <= 0.0 {
        return 0.0;
    }
    let fresnel = ggx::schlick(f0, out.z);
    let specular = luminance(fresnel);
    let base = luminance((Vec3::ONE - fresnel) * diffuse);
    if base <= 0.0 { 1.0 } else { (specular / (specular + base)).clamp(0.1, 0.9) }
}

#[cfg(test)]
mod tests {
    use super::*;

    const OUT: Vec3 = Vec3::new(0.8, 0.0, 0.6);

    fn glossy() -> Lobe {
        Lobe::Gltf { diffuse: Vec3::new(0.8, 0.4, 0.2), f0: Vec3::splat(0.04), alpha: 0.3 }
    }

    #[test]
    fn light_goes_both_ways_alike() {
        let into = Vec3::new(-0.48, 0.6, 0.64);
        let there = glossy().evaluate(OUT, into).0 / into.z;
        let back = glossy().evaluate(into, OUT).0 / OUT.z;
        assert!((there - back).abs().max_element() < 1e-5);
    }

    /// The mean weight must be the same integral as uniform sampling of the hemisphere gives.
    #[test]
    fn sampling_agrees_with_evaluation() {
        let mut rng = Rng::new(11, 0, 0);
        let n = 200_000;
        for lobe in [glossy(), Lobe::Lambert(Vec3::new(0.5, 0.6, 0.7))] {
            let sampled: Vec3 =
                (0..n).filter_map(|_| lobe.sample(OUT, &mut rng)).map(|s| s.weight).sum::<Vec3>() / n as f32;
            let uniform: Vec3 = (0..n)
                .map(|_| {
                    let [u, v] = rng.square();
                    let (sin, cos) = (std::f32::consts::TAU * v).sin_cos();
                    let radius = (1.0 - u * u).sqrt();
                    lobe.evaluate(OUT, Vec3::new(radius * cos, radius * sin, u)).0 * std::f32::consts::TAU
                })
                .sum::<Vec3>()
                / n as f32;
            assert!((sampled - uniform).abs().max_element() < 0.01, "{sampled} {uniform}");
        }
    }

    /// Below the horizon lies up to half of a rough lobe, which the tries make up for.
    #[test]
    fn tries_normalise_the_mirror_directions() {
        let mut rng = Rng::new(13, 0, 0);
        let n = 200_000;
        for alpha in [0.3, 1.0] {
            let total: f32 = (0..n)
                .map(|_| {
                    let lobe = Lobe::mirror_directions(OUT, alpha, &mut rng);
                    let [u, v] = rng.square();
                    let (sin, cos) = (std::f32::consts::TAU * v).sin_cos();
                    let radius = (1.0 - u * u).sqrt();
                    lobe.evaluate(OUT, Vec3::new(radius * cos, radius * sin, u)).0.x * std::f32::consts::TAU
                })
                .sum();
            assert!((total / n as f32 - 1.0).abs() < 0.02, "{alpha}: {}", total / n as f32);
        }
    }

    #[test]
    fn a_sample_carries_its_own_density() {
        let mut rng = Rng::new(12, 0, 0);
        for _ in 0..1000 {
            let Some(sample) = glossy().sample(OUT, &mut rng) else { continue };
            let (value, pdf) = glossy().evaluate(OUT, sample.direction);
            assert_eq!((value / pdf, pdf), (sample.weight, sample.pdf));
        }
    }
}
