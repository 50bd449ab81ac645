//! What both kinds of files check about lights.

/// A spot light's inner and outer half-angles in radians, checked and made to differ.
pub(crate) fn cone(inner: f32, outer: f32) -> Result<(f32, f32), String> {
    let right = std::f32::consts::FRAC_PI_2;
    // An angle given in degrees may round to just above a right angle.
    if !(outer > 0.0 && outer <= right * (1.0 + 1e-6)) {
        return Err("the outer angle must be above 0° and at most 90°".into());
    }
    if !(0.0..=outer).contains(&inner) {
        return Err("the inner angle must be from 0° to the outer angle".into());
    }
    let outer = outer.min(right);
    // The falloff divides by the difference of their cosines.
    Ok((inner.min(outer * 0.999), outer))
}
