// Linear in space and between levels, clamped at the borders.

@group(2) @binding(0) var volume_sampler: sampler;
