//! `wgsl/common/seen_ahead.wgsl`.

use glam::{DVec3, DVec4};

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
}
