//! The book's errata page: each printed form, shown to be wrong where it can't be followed, and what is used instead.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use std::f64::consts::PI;

use glam::{DMat3, DVec3};

fn near(a: f64, b: f64) -> bool {
    // Sums of a few rounded terms.
    (a - b).abs() < 1e-6 * b.abs().max(1.0)
}

/// Mean over the sphere: Gauss and Legendre's two points in each of 400 rings, 400 steps around.
fn sphere_integral(f: impl Fn(DVec3) -> f64) -> f64 {
    const N: usize = 400;
    let mut sum = 0.0;
    for i in 0..N {
        for half in [-1.0, 1.0] {
            let z: f64 = -1.0 + (2.0 * i as f64 + 1.0 + half / 3f64.sqrt()) / N as f64;
            for j in 0..N {
                let (sin, cos) = (2.0 * PI * (j as f64 + 0.5) / N as f64).sin_cos();
                let r = (1.0 - z * z).sqrt();
                sum += f(DVec3::new(r * cos, r * sin, z)) * (1.0 / N as f64) * (2.0 * PI / N as f64);
            }
        }
    }
    sum
}

/// RAU 5.1 and 5.7: the first function. A basis gives constant radiance back only if its functions are of norm 1.
#[test]
fn the_first_harmonic_is_not_1() {
    let back = |y0: f64| y0 * sphere_integral(|_| 1.0 * y0);
    assert!(near(back(1.0), 4.0 * PI), "as printed: 12.6 times the radiance");
    assert!(near(back(1.0 / (2.0 * PI.sqrt())), 1.0));
}

/// The solid angle of a rectangle from the origin's perpendicular foot to (a, b), at distance d.
fn corner(a: f64, b: f64, d: f64) -> f64 {
    (a * b / (d * (a * a + b * b + d * d).sqrt())).atan()
}

/// Of a parent's face, 4 × 4, from a child's middle: it reaches 1 to one side and 3 to the other.
fn face(d: f64) -> f64 {
    corner(1.0, 1.0, d) + 2.0 * corner(1.0, 3.0, d) + corner(3.0, 3.0, d)
}

/// RAU 5.3: which face is which.
#[test]
fn the_far_face_is_the_narrow_one() {
    let (near_face, far_face) = (face(1.0), face(3.0));
    assert!(near(near_face, 3.113997196) && near(far_face, 1.074793009));
    assert!(near(3.0 * (near_face + far_face), 4.0 * PI));
    let printed_far = 3.113997196;
    assert!(
        !near(printed_far, far_face) && printed_far > near_face - 1e-6,
        "as printed, far is wider than near"
    );
}

/// RAU 5.9 for some of a parent's eight children with the same coefficients: 1, x, y, z.
fn projected(children: &[DVec3], value: [f64; 4]) -> [f64; 4] {
    let (y0, y1) = (1.0 / (2.0 * PI.sqrt()), 3f64.sqrt() / (2.0 * PI.sqrt()));
    let mut sum = [0.0; 4];
    for outwards in children {
        for axis in 0..3 {
            for (distance, sign) in [(1.0, 1.0), (3.0, -1.0)] {
                // From the child's middle to the face's: the near face lies outwards, the far one inwards.
                let mut d = -*outwards;
                d[axis] = outwards[axis] * distance * sign;
                let d = d.normalize();
                let seen = y0 * value[0] + y1 * (d.x * value[1] + d.y * value[2] + d.z * value[3]);
                let (lobe0, lobe1) = (PI.sqrt() / 2.0, (PI / 3.0).sqrt());
                let lobe = [lobe0, lobe1 * d.x, lobe1 * d.y, lobe1 * d.z];
                (0..4).for_each(|i| sum[i] += face(distance) * seen * lobe[i] / children.len() as f64);
            }
        }
    }
    sum
}

/// RAU 5.9: a level multiplies the mean by π. Over π it keeps the mean, and takes a third off the direction.
#[test]
fn projected_mips_are_too_bright_by_pi() {
    let all: Vec<DVec3> = (0..8)
        .map(|i| DVec3::new(f64::from(i & 1), f64::from(i >> 1 & 1), f64::from(i >> 2)) * 2.0 - 1.0)
        .collect();
    let printed = projected(&all, [1.0, 0.0, 0.0, 0.0]);
    assert!(near(printed[0], PI), "{printed:?}");
    for axis in 0..3 {
        let mut value = [0.0; 4];
        value[axis + 1] = 1.0;
        let corrected = projected(&all, value).map(|c| c / PI);
        let expected: [f64; 4] = std::array::from_fn(|i| if i == axis + 1 { 2.0 / 3.0 } else { 0.0 });
        assert!(corrected.iter().zip(expected).all(|(a, b)| near(*a, b)), "{corrected:?}");
    }
    // One child alone: what has no direction gets one.
    let alone = projected(&all[7..], [1.0, 0.0, 0.0, 0.0]).map(|c| c / PI);
    assert!(near(alone[0], 1.0) && alone[1].abs() > 0.1, "{alone:?}");
}

/// RAU 6.2: where cones begin. `f_max/f_min` is over 1, so that as printed the second case is always true.
#[test]
fn every_cone_would_begin_at_the_farthest() {
    let (least, most) = (1.0, 4.0);
    let printed = |cosine: f64| match cosine {
        c if c > 1.0 => least,
        c if c < most / least => most,
        c => least / c,
    };
    let clamped = |cosine: f64| if cosine > 0.0 { (least / cosine).clamp(least, most) } else { most };
    for cosine in [1.0, 0.5, 0.1, 0.0, -0.5] {
        assert_eq!(printed(cosine), most);
    }
    assert_eq!([1.0, 0.5, 0.1, 0.0, -0.5].map(clamped), [1.0, 2.0, 4.0, 4.0, 4.0]);
}

/// RAU 6.14: with ρ/π outside, weights that sum to 2π reflect twice what arrives.
#[test]
fn diffuse_weights_sum_to_pi() {
    let cosine = sphere_integral(|d| d.z.max(0.0));
    // The quadrature's ring at the horizon costs 1e-5.
    assert!((cosine - PI).abs() < 1e-4);
    let (axis, around) = (PI / 4.0, 3.0 * PI / 20.0);
    assert!(near(axis + 5.0 * around, PI));
    let reflected = |sum: f64| 1.0 / PI * sum;
    assert!(near(reflected(PI), 1.0) && near(reflected(2.0 * PI), 2.0), "a white furnace of radiance 1");
}

/// RAU 7.2: how much ambient occlusion darkens.
#[test]
fn no_occlusion_must_leave_the_shadow_alone() {
    let printed = |s: f64, o: f64, c: f64| o * (1.0 - c) + s * o * c;
    let used = |s: f64, o: f64, c: f64| s * (1.0 + c * (o - 1.0));
    // In full shadow, c = 0 lights what is open.
    assert_eq!(printed(0.0, 1.0, 0.0), 1.0);
    assert_eq!(used(0.0, 1.0, 0.0), 0.0);
    for (s, o) in [(0.3, 0.6), (1.0, 0.2)] {
        assert!(near(used(s, o, 0.0), s) && near(used(s, o, 1.0), s * o));
    }
}

/// RAU B.1: one colour's running average in 8 bits, with the count in 8 bits beside it.
fn running_average(values: impl IntoIterator<Item = f64>) -> f64 {
    let (mut average, mut count) = (0u8, 0u8);
    for value in values {
        let stored = f64::from(average) / 255.0;
        let next = (stored * f64::from(count) + value) / (f64::from(count) + 1.0);
        average = (next * 255.0) as u8;
        count = count.wrapping_add(1);
    }
    f64::from(average) / 255.0
}

/// RAU B.1: the result depends on the order, and after 255 writes on the last few alone.
#[test]
fn a_running_average_in_8_bits_depends_on_order_and_wraps() {
    let (black, white) = (std::iter::repeat_n(0.0, 100), std::iter::repeat_n(1.0, 100));
    let rising = running_average(black.clone().chain(white.clone()));
    let falling = running_average(white.chain(black));
    assert!((rising - falling).abs() > 0.04, "{rising} and {falling} should be 0.5 both");
    let wrapped = running_average(std::iter::repeat_n(1.0, 256).chain([0.0]));
    assert_eq!(wrapped, 0.0, "256 whites and a black");
    // Sums in integers: the same in any order, and nothing wraps (`tests/tests/substrate.rs`).
    let sum = |values: Vec<u32>| values.iter().sum::<u32>();
    assert_eq!(sum((0..300).collect()), sum((0..300).rev().collect()));
}

/// DVS §4: front-to-back compositing of premultiplied layers of radiance 1.
#[test]
fn what_a_cone_has_gathered_must_not_fade() {
    let layers = [0.5, 0.5, 0.0, 1.0];
    let (mut printed, mut used, mut alpha) = (0.0, 0.0, 0.0);
    for layer in layers {
        printed = alpha * printed + (1.0 - alpha) * layer * 1.0;
        used += (1.0 - alpha) * (layer * 1.0);
        alpha += (1.0 - alpha) * layer;
    }
    assert!(near(alpha, 1.0) && near(used, 1.0), "an opaque stack of radiance 1 is 1");
    assert!(printed < 0.7, "as printed: {printed}");
}

/// All texts: opacity taken as it is for any step makes a wall's opacity depend on the step.
#[test]
fn opacity_belongs_to_a_length() {
    let through = |step: f64, corrected: bool| {
        let alpha: f64 = 0.3;
        let each = if corrected { 1.0 - (1.0 - alpha).powf(step) } else { alpha };
        1.0 - (1.0 - each).powf(4.0 / step)
    };
    assert!(near(through(1.0, true), through(0.25, true)) && near(through(2.0, true), through(0.25, true)));
    assert!((through(1.0, false) - through(0.25, false)).abs() > 0.2);
}

/// RAU 5.2.2 and B.2: weights of the three faces. A closed wall of normal n covers |nᵢ|·|n|₁ of its cells' faces; the
/// squares of a slanting ray's direction let it through.
#[test]
fn squares_of_the_direction_let_slanting_rays_through() {
    let normal = DVec3::new(1.0, 1.0, 0.0).normalize();
    let covered = (normal.abs() * normal.abs().element_sum()).min(DVec3::ONE);
    let direction = DVec3::new(1.0, 0.0, 1.0).normalize();
    let (squares, linear) = ((direction * direction).dot(covered), direction.abs().dot(covered));
    // It crosses |d|₁ cells' worth of the wall's cells, of which the slab along x alone is closed.
    assert!(squares < 0.51 && linear > 0.7, "{squares} {linear}");
    assert!(near(direction.abs().dot(DVec3::ONE).min(1.0), 1.0));
}

/// RAU 5.3.1: the mean of eight opacities halves a wall one voxel thick at every level; compositing keeps it.
#[test]
fn a_mean_of_opacities_opens_a_wall() {
    let wall: [f64; 8] = std::array::from_fn(|i| f64::from(u8::from(i & 1 == 0)));
    let mean = wall.iter().sum::<f64>() / 8.0;
    assert_eq!(mean, 0.5);
    let covered = voxlume::twin::composite_coverage(&wall.map(DVec3::splat));
    assert_eq!(covered.x, 1.0);
}

/// DVS §4.2: falloff belongs to the occluder. Weighting what is left of the ray lets what lies behind an opaque near
/// occluder count.
#[test]
fn falloff_weighs_the_occluder_alone() {
    let layers = [(1.0, 0.5), (1.0, 0.25)];
    let (mut printed, mut used, mut transmittance) = (0.0, 0.0, 1.0);
    for (alpha, falloff) in layers {
        printed += (1.0 - printed) * alpha * falloff;
        used += transmittance * alpha * falloff;
        transmittance *= 1.0 - alpha;
    }
    assert_eq!(used, 0.5);
    assert!(printed > 0.6, "the second wall is hidden, and still counts");
}

/// RAU figure 4.5: cells from ⌊z⌋ to ⌈z⌉ are two wherever z isn't whole: a plane would be two cells thick.
#[test]
fn a_thin_column_is_one_cell() {
    let printed = |z: f64| z.ceil() as i32 - z.floor() as i32 + 1;
    assert_eq!(printed(3.5), 2);
    let rotated = DMat3::from_rotation_x(0.3) * DVec3::Z;
    let depth = |y: f64| 8.0 - rotated.y / rotated.z * y;
    assert!((0..8).all(|y| printed(depth(f64::from(y) + 0.5)) == 2));
}
