// Which of its repetitions a pass is in.

struct Step {
    level: u32,
}

@group(3) @binding(15) var<uniform> step_params: Step;
