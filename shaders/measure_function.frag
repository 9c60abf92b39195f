#version 450 core
#extension GL_GOOGLE_include_directive : require

// Gradient magnitude of a surface function's values: Hertzmann 1999, appendix A, equation 6. CPU definition: reference.h,
// functionMagnitude().
#define KERNEL_SOBEL 0
#define KERNEL_FARID 1

#include "shared/kernels.glsl"

const int TAPS = 2 * RADIUS + 1;

layout(binding = 0) uniform sampler2D values;  // as draw_function.frag writes them

layout(location = 0) uniform float period;  // differences are taken modulo this; 0: as they are

layout(location = 0) out float magnitude;  // the largest of the four channels

bool isBackground(vec4 value) { return value.a > 1e29; }

// Less the pixel's own value: kernels of derivatives do not see it, and what begins anew can be told from an edge. What is
// not there differs from nothing.
vec4 difference(vec4 value, vec4 centre) {
    if (isBackground(value)) return vec4(0.0);
    vec4 d = value - centre;
    return period > 0.0 ? d - period * roundEven(d / period) : d;
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 centre = texelFetch(values, pixel, 0);
    magnitude = 0.0;
    if (isBackground(centre)) return;
    vec4 ix = vec4(0.0);
    vec4 iy = vec4(0.0);
    for (int y = 0; y < TAPS; ++y) {
        for (int x = 0; x < TAPS; ++x) {
            ivec2 at = clamp(pixel + ivec2(x, y) - RADIUS, ivec2(0), textureSize(values, 0) - 1);
            vec4 d = difference(texelFetch(values, at, 0), centre);
            ix += DERIVATIVE[x] * SMOOTHING[y] * d;
            iy += SMOOTHING[x] * DERIVATIVE[y] * d;
        }
    }
    vec4 squared = ix * ix + iy * iy;
    magnitude = sqrt(max(max(squared.r, squared.g), max(squared.b, squared.a)));
}
