// The first two bands of the real spherical harmonics, in the order 1, x, y, z (RAU eq. 5.1 with the constant
// of its figure B.3). The four coefficients stand one above the other along z in one texture: RGB is radiance
// times mean opacity, and alpha the mean opacity, then the opacities seen along x, y and z.

const COEFFICIENTS = 4u;
// 1 / (2√π)
const SH0 = 0.28209479177387814;
// √3 / (2√π)
const SH1 = 0.4886025119029199;
// Coefficients of a one-sided Lambertian emitter of radiance 1 with normal n: √π, and √(3π)/2 · n.
const LOBE0 = 1.772453850905516;
const LOBE1 = 1.5349900619197328;
