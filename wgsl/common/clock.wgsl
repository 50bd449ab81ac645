// When a frame is. A pass that reads this runs in every frame.

struct Clock {
    // Seconds of the scene's own time.
    seconds: f32,
    // Frames since the images of the last frame were made or emptied: 0 where there is no last frame.
    frame: u32,
    padding: vec2u,
}

var<uniform> clock: Clock;
