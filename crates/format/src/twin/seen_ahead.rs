//! `wgsl/common/seen_ahead.wgsl`.

use glam::{DVec3, DVec4};

use super::Volumes;

/// What a sample of the volume shows to a cone, which must not see what lies behind its apex.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SeenAhead {
    /// Premultiplied radiance of what is known to lie ahead, and opacity of all that is found.
    pub value: DVec4,
    /// Opacity of that which the radiance is of; the rest's is unknown.
    pub known: f64,
    /// For the cone's next sample: how opaque is what faces the cone behind its apex, along each axis, `[0, 1]`.
    pub behind: DVec3,
}

impl SeenAhead {
    /// Of a format that can't tell: all lies ahead.
    pub fn all(value: DVec4) -> SeenAhead {
        SeenAhead { value, known: value.w, behind: DVec3::ZERO }
    }

    /// [`Volumes::sample_over_base`] of what a cone sees of level 1: level 0, the first volume, is known.
    pub fn over_base(self, volumes: &Volumes, uvw: DVec3, level: f64) -> SeenAhead {
        let value = volumes.sample_over_base(0, uvw, level, self.value);
        let unknown = level.max(0.0) * (self.value.w - self.known);
        SeenAhead { value, known: value.w - unknown, ..self }
    }
}

/// The directions along x, y and z in which a cone travels, 1 or −1.
pub fn ahead_along(direction: DVec3) -> DVec3 {
    direction.map(|d| if d > 0.0 { 1.0 } else { -1.0 })
}

/// What is seen along each axis 1.5 cells ahead of a cone's apex and 1.5 behind it.
pub(crate) struct Beside {
    ahead: [DVec4; 3],
    back: [DVec4; 3],
    /// Whether a sample's cells may reach behind the apex.
    near: [bool; 3],
}

impl Beside {
    /// `seen` gives what an axis shows at a place; `side` is of [`ahead_along`], `size` in cells.
    pub(crate) fn new(
        uvw: DVec3,
        apex: DVec3,
        side: DVec3,
        size: DVec3,
        seen: impl Fn(usize, DVec3) -> DVec4,
    ) -> Beside {
        let at = |axis: usize, cells: f64| {
            let mut place = uvw;
            place[axis] = apex[axis] + cells * side[axis] / size[axis];
            // Beyond the grid is nothing.
            let inside = (0.5 + size[axis] * (0.5 - (place[axis] - 0.5).abs())).clamp(0.0, 1.0);
            inside * seen(axis, place)
        };
        Beside {
            ahead: std::array::from_fn(|axis| at(axis, 1.5)),
            back: std::array::from_fn(|axis| at(axis, -1.5)),
            near: std::array::from_fn(|axis| (uvw[axis] - apex[axis]) * side[axis] * size[axis] < 1.5),
        }
    }

    /// What lies behind the apex, of which earlier samples found so much `before`, and how far it hides each axis.
    pub(crate) fn hidden(&self, before: DVec3) -> (DVec3, DVec3) {
        let opacity = DVec3::from_array(self.back.map(|back| back.w));
        let behind = before.max((opacity / 0.25).clamp(DVec3::ZERO, DVec3::ONE));
        (
            behind,
            DVec3::from_array(std::array::from_fn(|axis| if self.near[axis] { behind[axis] } else { 0.0 })),
        )
    }

    /// `found` along each axis, of which known is all, or where it is hidden what cells ahead have of the same.
    pub(crate) fn see(
        &self,
        found: &[DVec4; 3],
        hidden: DVec3,
        behind: DVec3,
        direction: DVec3,
    ) -> SeenAhead {
        let (mut known, mut opacity) = (DVec4::ZERO, 0.0);
        for axis in 0..3 {
            let (found, ahead) = (found[axis], self.ahead[axis]);
            let same = ahead * (found.w / ahead.w.max(1e-6)).min(1.0);
            known += direction[axis].abs() * found.lerp(same, hidden[axis]);
            opacity += direction[axis].abs() * found.w;
        }
        let scale = 1.0 / opacity.max(1.0);
        SeenAhead { value: known.with_w(opacity) * scale, known: known.w * scale, behind }
    }
}
