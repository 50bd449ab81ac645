// What shines on the scene as a whole.

struct Environment {
    // Radiance from outside the scene, W·m⁻²·sr⁻¹.
    sky: vec3f,
    light_count: u32,
}

var<uniform> environment: Environment;
