// What the two forms of the edge pass share, so that they agree to the last bit: every sum is taken in one order, and
// `precise` keeps drivers from another.
#include "shared/depth.glsl"

#define KERNEL_SOBEL 0
#define KERNEL_FARID 1

#include "shared/kernels.glsl"

const int TAPS = 2 * RADIUS + 1;

layout(binding = 0) uniform sampler2D surfaces;  // rgb: normal, a: eye-space depth; beyond the border it repeats it

layout(location = 0) uniform Depths depths;
layout(location = 3) uniform bool windowDepth;  // find depth edges in window depth instead of linear depth

// The four channels that edges are found in.
vec4 channels(vec4 surface) { return vec4(surface.rgb, scaledDepth(surface.a, windowDepth, depths)); }

vec4 smoothed(vec4 s[TAPS]) {
    precise vec4 sum = SMOOTHING[RADIUS] * s[RADIUS];
    for (int i = 1; i <= RADIUS; ++i) sum += SMOOTHING[RADIUS + i] * (s[RADIUS - i] + s[RADIUS + i]);
    return sum;
}

vec4 differentiated(vec4 s[TAPS]) {
    precise vec4 sum = DERIVATIVE[RADIUS + 1] * (s[RADIUS + 1] - s[RADIUS - 1]);
    for (int i = 2; i <= RADIUS; ++i) sum += DERIVATIVE[RADIUS + i] * (s[RADIUS + i] - s[RADIUS - i]);
    return sum;
}

// Equation 6: of the depth map; of the normal map, the largest of its three channels.
vec2 magnitudesOf(vec4 ix, vec4 iy) {
    precise vec4 squared = ix * ix + iy * iy;
    return sqrt(vec2(squared.a, max(squared.r, max(squared.g, squared.b))));
}
