// Separable gradient kernels, used as printed: G_x = DERIVATIVE along x, SMOOTHING along y; G_y the other way round.
// src/reference/reference.h has the same numbers; a test holds the two together.
#if KERNEL == KERNEL_SOBEL
// Equation 5.
const int RADIUS = 1;
const float SMOOTHING[3] = float[](1.0, 2.0, 1.0);
const float DERIVATIVE[3] = float[](-1.0, 0.0, 1.0);
#else
// Equation 8, after Farid and Simoncelli 1997. The paper's text lost the minus signs of d: it is antisymmetric.
const int RADIUS = 2;
const float SMOOTHING[5] = float[](0.036470, 0.248968, 0.429123, 0.248968, 0.036470);
const float DERIVATIVE[5] = float[](-0.108385, -0.280349, 0.0, 0.280349, 0.108385);
#endif
