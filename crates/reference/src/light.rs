//! Directional, point and spot lights at their true sizes.

use glam::{DVec3, Vec3};
use voxlume_scene::{Light, LightKind};

use std::f32::consts::{FRAC_PI_2, PI};

use crate::rng::Rng;
use crate::sampling::Cone;

/// A light, relative to the geometry's origin.
pub(crate) struct Lamp {
    shape: Shape,
    /// As [`Light::intensity`].
    intensity: Vec3,
}

enum Shape {
    Disc {
        /// Towards the light, unit.
        toward: Vec3,
        /// Squared sine of the angular radius.
        sin2: f32,
    },
    Sphere {
        centre: Vec3,
        radius: f32,
        shade: Option<Shade>,
    },
}

/// glTF's angular falloff of a spot.
struct Shade {
    axis: Vec3,
    cos_outer: f32,
    scale: f32,
}

/// A light as one point sees it.
pub(crate) struct Seen {
    /// What it covers; without width for a light without size.
    cone: Cone,
    /// Radiance, or the irradiance at normal incidence of a light without size.
    pub(crate) light: Vec3,
    /// Distance of the sphere's centre, infinite for a disc.
    distance: f32,
    radius: f32,
}

/// A direction towards a light.
pub(crate) struct LampSample {
    /// Unit.
    pub(crate) direction: Vec3,
    /// Where the light begins along it.
    pub(crate) distance: f32,
    /// Radiance over density; for a light without size, irradiance at normal incidence.
    pub(crate) irradiance: Vec3,
    /// Per solid angle; infinite for a light without size.
    pub(crate) pdf: f32,
}

impl Lamp {
    pub(crate) fn new(light: &Light, origin: DVec3) -> Self {
        let place = |position: DVec3| (position - origin).as_vec3();
        let shape = match light.kind {
            LightKind::Directional { direction, angular_diameter } => Shape::Disc {
                toward: -direction,
                sin2: (angular_diameter / 2.0).clamp(0.0, FRAC_PI_2).sin().powi(2),
            },
            LightKind::Point { position, radius } => {
                Shape::Sphere { centre: place(position), radius, shade: None }
            }
            LightKind::Spot { position, direction, radius, inner, outer } => {
                // KHR_lights_punctual, "Inner and Outer Cone Angles".
                let scale = 1.0 / (inner.cos() - outer.cos()).max(0.001);
                let shade = Shade { axis: direction, cos_outer: outer.cos(), scale };
                Shape::Sphere { centre: place(position), radius, shade: Some(shade) }
            }
        };
        Lamp { shape, intensity: light.intensity }
    }

    /// The light as `point` sees it; none from within a light's sphere, which shines outwards.
    pub(crate) fn seen_from(&self, point: Vec3) -> Option<Seen> {
        match &self.shape {
            Shape::Disc { toward, sin2 } => {
                let area = if *sin2 > 0.0 { PI * sin2 } else { 1.0 };
                let cone = Cone { axis: *toward, sin2: *sin2 };
                Some(Seen { cone, light: self.intensity / area, distance: f32::INFINITY, radius: 0.0 })
            }
            Shape::Sphere { centre, radius, shade } => {
                let to = *centre - point;
                let distance = to.length();
                let axis = to.try_normalize().filter(|_| distance > *radius)?;
                let sin2 = (radius / distance).powi(2);
                let area = if sin2 > 0.0 { PI * radius * radius } else { distance * distance };
                let falloff = shade.as_ref().map_or(1.0, |shade| {
                    (((-axis).dot(shade.axis) - shade.cos_outer) * shade.scale).clamp(0.0, 1.0).powi(2)
                });
                let light = self.intensity * falloff / area;
                Some(Seen { cone: Cone { axis, sin2 }, light, distance, radius: *radius })
            }
        }
    }
}

impl Seen {
    /// A direction uniform over the light.
    pub(crate) fn sample(&self, rng: &mut Rng) -> LampSample {
        if self.cone.sin2 > 0.0 {
            let direction = self.cone.sample(rng.square());
            let pdf = self.cone.pdf();
            let distance = self.near(direction);
            LampSample { direction, distance, irradiance: self.light / pdf, pdf }
        } else {
            LampSample {
                direction: self.cone.axis,
                distance: self.distance,
                irradiance: self.light,
                pdf: f32::INFINITY,
            }
        }
    }

    /// Radiance, density of [`Seen::sample`] and distance of the light along `direction`, if it is there.
    /// A light without size is met by no direction.
    pub(crate) fn along(&self, direction: Vec3) -> Option<(Vec3, f32, f32)> {
        (self.cone.sin2 > 0.0 && self.cone.contains(direction))
            .then(|| (self.light, self.cone.pdf(), self.near(direction)))
    }

    /// Distance of the sphere's near side.
    fn near(&self, direction: Vec3) -> f32 {
        if self.distance.is_infinite() {
            return self.distance;
        }
        let centre = self.cone.axis * self.distance;
        let across = centre.cross(direction).length_squared();
        centre.dot(direction) - (self.radius * self.radius - across).max(0.0).sqrt()
    }
}
