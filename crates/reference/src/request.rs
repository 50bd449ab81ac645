//! What is to be computed.

use glam::DVec3;
use voxlume_scene::Camera;

use crate::Error;

/// The largest picture, in pixels: its buffers take 24 bytes a pixel.
pub const MAX_PIXELS: u64 = 1 << 26;

/// One picture: a quantity, seen by a camera, to a precision.
#[derive(Clone, Debug, PartialEq)]
pub struct Request {
    /// The eye. Its aspect is that of the picture.
    pub camera: Camera,
    /// Width in pixels, at least 1.
    pub width: u32,
    /// Height in pixels, at least 1; at most [`MAX_PIXELS`] in all.
    pub height: u32,
    /// Independent samples of each pixel, at least 2.
    pub samples: u32,
    /// Another seed gives other noise.
    pub seed: u64,
    /// Where in the pixel the camera looks.
    pub sampling: PixelSampling,
    /// What each pixel holds.
    pub quantity: Quantity,
    /// How surfaces reflect.
    pub reflection: Reflection,
}

/// Where in a pixel the camera's rays go.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PixelSampling {
    /// Through its centre, as a renderer that shades once a pixel does.
    Centre,
    /// Evenly over its area: a box filter.
    Area,
}

/// How the scene's surfaces reflect light.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reflection {
    /// glTF 2.0 appendix B: with `α = max(roughness², 10⁻⁴)`, `c_diff = base·(1 − metallic)`,
    /// `F₀ = mix(0.04, base, metallic)` and Schlick's `F`, the BRDF is
    /// `(1 − F)·c_diff/π + F·D·G/(4·cosθₒ·cosθᵢ)`, GGX with height-correlated Smith masking. As
    /// specified, `F` is taken at the half vector, so that a bright smooth dielectric can reflect more
    /// than it receives towards a grazing eye.
    Gltf,
    /// `c_diff/π` alone: what voxels that store one radiance for all directions can model.
    Lambert,
}

/// What a gathered ray counts besides the light that surfaces reflect.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Gather {
    /// How many surfaces the light may have been reflected by on its way: 1 is light that came from a
    /// light source to one surface and from there here. 0 leaves sky and emission only.
    pub bounces: u32,
    /// Whether the sky counts where it is seen directly. Reflected sky light always counts.
    pub sky: bool,
    /// Whether emissive surfaces count where they are seen directly. Reflected emission always counts.
    pub emission: bool,
}

/// A flat convex quadrilateral that emits evenly, such as the scene's
/// [`EmissivePolygon`](voxlume_scene::EmissivePolygon)s are; a triangle repeats its last corner.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Panel {
    /// World space, counter-clockwise from the front.
    pub corners: [DVec3; 4],
    /// Whether its back emits too.
    pub double_sided: bool,
}

/// What a pixel holds.
///
/// Throughout, `x` is the surface that the camera sees in the pixel (single-sided triangles seen from
/// behind are looked through), `n` its shading normal — interpolated, normal-mapped, turned to the eye —
/// and `dω` ranges over the directions above both `n`'s and the triangle's own horizon. A scalar is
/// written to all three channels. `L(x, ω)` is the radiance that arrives at `x` from direction `ω`:
///
/// `L = emission·Lₑ + sky·Lₛ + reflected light after 1 … bounces reflections`
///
/// where `emission` and `sky` are [`Gather`]'s switches, and the light sources of the reflected part
/// are all of the scene's: lights, emissive surfaces and the sky. Directional, point and spot lights
/// are not themselves part of `L`: they light surfaces, but no gathered ray and no eye sees their disc.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Quantity {
    /// The share of the irradiance that a light would give `x` if nothing were in between, in \[0,1\]:
    /// `∫ V cosθ dω / ∫ cosθ dω` over the directions towards its disc, as far as they lie above `n`'s horizon. `V` is 0 below the
    /// triangle's own horizon. A light without size is one direction. 0 where the light gives nothing anyway, such as outside a
    /// spot's cone; 1 within a light's sphere and where the camera sees no surface.
    SoftShadow {
        /// Index in [`voxlume_scene::Scene::lights`].
        light: usize,
    },
    /// As [`Quantity::SoftShadow`] for a surface that emits evenly.
    PanelShadow(Panel),
    /// Accessibility: `1 − (1/π) ∫ f(d(ω)) cosθ dω`, in \[0,1\], where `d` is the distance to the first
    /// surface and `f(d) = 1/(1 + falloff·d)` below `distance`, else 0. Directions above `n`'s horizon
    /// but below the triangle's own are blocked at distance 0. 1 where the camera sees no surface.
    AmbientOcclusion {
        /// Reach, world units, above 0; infinity for no limit.
        distance: f32,
        /// λ, per world unit, at least 0.
        falloff: f32,
    },
    /// Indirect irradiance `∫ L(x, ω) cosθ dω`, W·m⁻². 0 where the camera sees no surface.
    Diffuse(Gather),
    /// Mean radiance over the specular lobe, `∫ L(x, ω) p(ω) dω`, W·m⁻²·sr⁻¹. `p` is the density of the
    /// mirror directions about GGX's visible normals, `G₁(ωₒ)·D(h)/(4·cosθₒ)`, restricted to the
    /// directions above the surface and normalised to 1: constant `L` gives `L`. No Fresnel factor.
    /// 0 where the camera sees no surface.
    Specular(Gather),
    /// The radiance that reaches the camera, W·m⁻²·sr⁻¹: what `x` emits, all light that it reflects
    /// directly from lights, emissive surfaces and the sky, and light reflected up to `bounces` times
    /// before. The sky where the camera sees no surface.
    Final {
        /// 0 is direct light only; 1 adds one indirect bounce.
        bounces: u32,
    },
}

impl Request {
    /// Checks everything but the light's index, which needs the scene.
    pub(crate) fn check(&self) -> Result<(), Error> {
        check_view(&self.camera, self.width, self.height)?;
        if self.samples < 2 {
            return Err(Error::Samples(self.samples));
        }
        match self.quantity {
            Quantity::AmbientOcclusion { distance, falloff }
                if distance.is_nan() || distance <= 0.0 || !falloff.is_finite() || falloff < 0.0 =>
            {
                Err(Error::AmbientOcclusion { distance, falloff })
            }
            _ => Ok(()),
        }
    }
}

/// Checks what makes a view.
pub(crate) fn check_view(camera: &Camera, width: u32, height: u32) -> Result<(), Error> {
    if width == 0 || height == 0 || u64::from(width) * u64::from(height) > MAX_PIXELS {
        return Err(Error::Size { width, height });
    }
    match camera_fault(camera) {
        Some(fault) => Err(Error::Camera { name: camera.name.clone(), fault }),
        None => Ok(()),
    }
}

fn camera_fault(camera: &Camera) -> Option<&'static str> {
    let Camera { name: _, eye, forward, up, vertical_fov } = camera;
    if !eye.is_finite() {
        Some("eye must be finite")
    } else if !forward.is_normalized() || !up.is_normalized() || forward.dot(*up).abs() > 1e-3 {
        Some("forward and up must be of unit length and at right angles")
    } else if !(*vertical_fov > 0.0 && *vertical_fov < std::f32::consts::PI) {
        Some("vertical_fov must be above 0 and below π")
    } else {
        None
    }
}
