//! Textures: bilinear, repeating, sRGB decoded before filtering.

use glam::{Vec2, Vec4};
use voxlume_scene::Texture;

/// A scene's textures, ready to be sampled.
pub(crate) struct Textures {
    textures: Vec<Texture>,
    srgb: [f32; 256],
}

impl Textures {
    pub(crate) fn new(textures: &[Texture]) -> Self {
        let srgb = std::array::from_fn(|byte| srgb_to_linear(byte as f32 / 255.0));
        Textures { textures: textures.to_vec(), srgb }
    }

    /// The filtered texel at `uv`, linear; texel (0,0)'s centre is at half a texel from the corner.
    pub(crate) fn sample(&self, texture: usize, uv: Vec2) -> Vec4 {
        let texture = &self.textures[texture];
        let size = Vec2::new(texture.width as f32, texture.height as f32);
        // Repeats are taken off first, so that large coordinates keep the texels' precision.
        let position = (uv - uv.floor()) * size - 0.5;
        let corner = position.floor();
        let blend = position - corner;
        let texel = |dx: i64, dy: i64| {
            let x = (corner.x as i64 + dx).rem_euclid(i64::from(texture.width));
            let y = (corner.y as i64 + dy).rem_euclid(i64::from(texture.height));
            self.texel(texture, (y * i64::from(texture.width) + x) as usize)
        };
        let top = texel(0, 0).lerp(texel(1, 0), blend.x);
        let bottom = texel(0, 1).lerp(texel(1, 1), blend.x);
        top.lerp(bottom, blend.y)
    }

    fn texel(&self, texture: &Texture, index: usize) -> Vec4 {
        let [r, g, b, a] = std::array::from_fn(|channel| texture.rgba[index * 4 + channel]);
        let linear = |byte: u8| f32::from(byte) / 255.0;
        if texture.srgb {
            let decoded = |byte: u8| self.srgb[usize::from(byte)];
            Vec4::new(decoded(r), decoded(g), decoded(b), linear(a))
        } else {
            Vec4::new(linear(r), linear(g), linear(b), linear(a))
        }
    }
}

/// IEC 61966-2-1.
fn srgb_to_linear(value: f32) -> f32 {
    if value <= 0.04045 { value / 12.92 } else { ((value + 0.055) / 1.055).powf(2.4) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn textures(srgb: bool) -> Textures {
        let rgba = vec![0, 0, 0, 255, 255, 0, 0, 255, 0, 255, 0, 0, 128, 128, 128, 0];
        Textures::new(&[Texture { name: "t".into(), width: 2, height: 2, rgba, srgb }])
    }

    #[test]
    fn texel_centres_midpoints_and_repeats() {
        let t = textures(false);
        assert_eq!(t.sample(0, Vec2::new(0.75, 0.25)), Vec4::new(1.0, 0.0, 0.0, 1.0));
        assert_eq!(t.sample(0, Vec2::new(0.25, 0.75)), Vec4::new(0.0, 1.0, 0.0, 0.0));
        assert_eq!(t.sample(0, Vec2::new(0.5, 0.25)), Vec4::new(0.5, 0.0, 0.0, 1.0));
        // The left border blends with the right column.
        assert_eq!(t.sample(0, Vec2::new(0.0, 0.25)), Vec4::new(0.5, 0.0, 0.0, 1.0));
        assert_eq!(t.sample(0, Vec2::new(-6.25, 3.25)), Vec4::new(1.0, 0.0, 0.0, 1.0));
    }

    #[test]
    fn srgb_is_decoded_before_filtering_and_alpha_is_linear() {
        let grey = textures(true).sample(0, Vec2::new(0.75, 0.75));
        // sRGB 128/255 is 21.586 % linear.
        assert!((grey.x - 0.21586).abs() < 1e-5);
        assert_eq!(textures(true).sample(0, Vec2::new(0.5, 0.25)).x, 0.5);
        assert_eq!(textures(true).sample(0, Vec2::new(0.25, 0.5)).w, 0.5);
    }
}
