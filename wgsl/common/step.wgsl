// Which of its repetitions a pass is in.

struct Step {
    level: u32,
}

var<uniform> step_params: Step;
