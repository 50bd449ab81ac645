const PI = 3.14159265358979;
const TAU = 6.28318530717959;
// The golden ratio, less 1: its multiples modulo 1 are spread evenly however many they are.
const GOLDEN = 0.618033989;
