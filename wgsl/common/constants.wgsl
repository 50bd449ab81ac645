const PI = 3.14159265358979;
const TAU = 6.28318530717959;
// The golden ratio, less 1: its multiples modulo 1 are spread evenly however many they are.
const GOLDEN = 0.618033989;
// The same, as a turn: points at multiples of it about a middle are spread evenly over a disc (Vogel 1979).
const GOLDEN_ANGLE = 2.39996323;
