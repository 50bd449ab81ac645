// Exclusive prefix sum, in place or of the bits set in each word of the bitmask, in three dispatches. First: the sum of
// each run of RUN values.

import package::common::dispatch::dispatch_index;

const RUN = 64u;

var<storage, read_write> scan_values: array<u32>;
var<storage, read> occupancy: array<u32>;
var<storage, read_write> scan_runs: array<u32>;

override COUNTS_BITS: bool = false;

// One value past the bitmask's end, the total takes its place.
fn value_at(index: u32) -> u32 {
    if (!COUNTS_BITS) {
        return scan_values[index];
    }
    return select(0u, countOneBits(occupancy[index]), index + 1 < arrayLength(&scan_values));
}

@compute @workgroup_size(64)
fn reduce(@builtin(global_invocation_id) id: vec3u) {
    let index = dispatch_index(id, 64);
    let count = arrayLength(&scan_values);
    if (index * RUN >= count) {
        return;
    }
    var sum = 0u;
    for (var i = index * RUN; i < min((index + 1) * RUN, count); i++) {
        sum += value_at(i);
    }
    scan_runs[index] = sum;
}

// Second: an exclusive prefix sum over the runs, by one workgroup.
const LANES = 256u;
var<workgroup> lane_sums: array<u32, LANES>;

@compute @workgroup_size(LANES)
fn runs(@builtin(local_invocation_index) lane: u32) {
    let count = (arrayLength(&scan_values) + RUN - 1) / RUN;
    let share = (count + LANES - 1) / LANES;
    let first = min(lane * share, count);
    let last = min(first + share, count);
    var sum = 0u;
    for (var i = first; i < last; i++) {
        sum += scan_runs[i];
    }
    lane_sums[lane] = sum;
    workgroupBarrier();
    if (lane == 0) {
        var total = 0u;
        for (var i = 0u; i < LANES; i++) {
            let value = lane_sums[i];
            lane_sums[i] = total;
            total += value;
        }
    }
    workgroupBarrier();
    var prefix = lane_sums[lane];
    for (var i = first; i < last; i++) {
        let value = scan_runs[i];
        scan_runs[i] = prefix;
        prefix += value;
    }
}

// Third: each value becomes the sum of all before it.
@compute @workgroup_size(64)
fn apply(@builtin(global_invocation_id) id: vec3u) {
    let index = dispatch_index(id, 64);
    let count = arrayLength(&scan_values);
    if (index * RUN >= count) {
        return;
    }
    var prefix = scan_runs[index];
    for (var i = index * RUN; i < min((index + 1) * RUN, count); i++) {
        let value = value_at(i);
        scan_values[i] = prefix;
        prefix += value;
    }
}
