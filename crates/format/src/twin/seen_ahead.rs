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

    /// [`Volumes::sample_over_base`] of what a cone sees: level 0, the first volume, is known.
    pub fn over_base(self, volumes: &Volumes, uvw: DVec3, level: f64) -> SeenAhead {
        let value = volumes.sample_over_base(0, uvw, level, self.value);
        let unknown = level.clamp(0.0, 1.0) * (self.value.w - self.known);
        SeenAhead { value, known: value.w - unknown, ..self }
    }
}

/// The directions along x, y and z in which a cone travels, 1 or −1.
pub fn ahead_along(direction: DVec3) -> DVec3 {
    direction.map(|d| if d > 0.0 { 1.0 } else { -1.0 })
}

/// A sample of a cone, and places 1.5 cells ahead of the cone's apex and behind it.
pub(crate) struct Beside {
    pub(crate) uvw: DVec3,
    pub(crate) apex: DVec3,
    /// Of [`ahead_along`].
    pub(crate) side: DVec3,
    /// Of the grid, in cells.
    pub(crate) size: DVec3,
}

impl Beside {
    /// The sample's place with one axis' coordinate moved so many cells ahead of the apex, and how far that is inside the grid, beyond
    /// which nothing is.
    fn place(&self, axis: usize, cells: f64) -> (DVec3, f64) {
        let mut place = self.uvw;
        place[axis] = self.apex[axis] + cells * self.side[axis] / self.size[axis];
        (place, (0.5 + self.size[axis] * (0.5 - (place[axis] - 0.5).abs())).clamp(0.0, 1.0))
    }

    /// What lies behind the apex, of which earlier samples found so much `before`, and how far it hides each axis. `opacity` is what an
    /// axis has at a place.
    pub(crate) fn hidden(&self, before: DVec3, opacity: impl Fn(usize, DVec3) -> f64) -> (DVec3, DVec3) {
        let (mut behind, mut hidden) = (before, DVec3::ZERO);
        for axis in 0..3 {
            let (place, inside) = self.place(axis, -1.5);
            behind[axis] = before[axis].max((inside * opacity(axis, place) / 0.25).clamp(0.0, 1.0));
            // The sample's cells may reach there.
            if (self.uvw[axis] - self.apex[axis]) * self.side[axis] * self.size[axis] < 1.5 {
                hidden[axis] = behind[axis];
            }
        }
        (behind, hidden)
    }

    /// Of what is `seen` along each axis known is all, or where it is hidden what cells ahead have of the same.
    pub(crate) fn see(
        &self,
        hidden: DVec3,
        behind: DVec3,
        direction: DVec3,
        seen: impl Fn(usize, DVec3) -> DVec4,
    ) -> SeenAhead {
        let (mut known, mut opacity) = (DVec4::ZERO, 0.0);
        for axis in 0..3 {
            let (place, inside) = self.place(axis, 1.5);
            let (found, ahead) = (seen(axis, self.uvw), inside * seen(axis, place));
            let same = ahead * (found.w / ahead.w.max(1e-6)).min(1.0);
            known += direction[axis].abs() * found.lerp(same, hidden[axis]);
            opacity += direction[axis].abs() * found.w;
        }
        let scale = 1.0 / opacity.max(1.0);
        SeenAhead { value: known.with_w(opacity) * scale, known: known.w * scale, behind }
    }
}
