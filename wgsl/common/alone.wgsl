// Pixels of an interleaved effect that traced all directions of their own, and get no mean over their neighbours: their alpha,
// else in [0, 1], is below 0.

fn stands_alone(value: vec4f) -> vec4f {
    return value - vec4f(0.0, 0.0, 0.0, 2.0);
}

fn with_others(value: vec4f) -> vec4f {
    return value + vec4f(0.0, 0.0, 0.0, 2.0);
}

fn is_alone(value: vec4f) -> bool {
    return value.a < 0.0;
}
