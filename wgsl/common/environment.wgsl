// What shines on the scene as a whole.

struct Environment {
    // Radiance from outside the scene, W·m⁻²·sr⁻¹.
    sky: vec3f,
    light_count: u32,
}

@group(0) @binding(17) var<uniform> environment: Environment;
