// Linear in space and between levels, clamped at the borders.

var volume_sampler: sampler;
