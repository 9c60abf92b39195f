// Sums of separable kernels. Every sum is taken in one order, and `precise` keeps drivers from changing the order, so
// that two forms of a pass agree to the last bit.
#define KERNEL_SOBEL 0
#define KERNEL_FARID 1

#include "shared/kernels.glsl"

const int TAPS = 2 * RADIUS + 1;

#define SUMS_OF(T)                                                                                                     \
    T smoothed(T s[TAPS]) {                                                                                            \
        precise T sum = SMOOTHING[RADIUS] * s[RADIUS];                                                                 \
        for (int i = 1; i <= RADIUS; ++i) sum += SMOOTHING[RADIUS + i] * (s[RADIUS - i] + s[RADIUS + i]);              \
        return sum;                                                                                                    \
    }                                                                                                                  \
    T differentiated(T s[TAPS]) {                                                                                      \
        precise T sum = DERIVATIVE[RADIUS + 1] * (s[RADIUS + 1] - s[RADIUS - 1]);                                      \
        for (int i = 2; i <= RADIUS; ++i) sum += DERIVATIVE[RADIUS + i] * (s[RADIUS + i] - s[RADIUS - i]);             \
        return sum;                                                                                                    \
    }
