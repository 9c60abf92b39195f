#version 450 core
#extension GL_GOOGLE_include_directive : require

#include "shared/depth.glsl"

// Edge detection of Hertzmann 1999, appendix A, on the depth map and on the three channels of the normal map at once.
// CPU definition: reference.h, detectEdges().
#define KERNEL_SOBEL 0
#define KERNEL_FARID 1

#include "shared/kernels.glsl"

layout(binding = 0) uniform sampler2D surfaces;  // rgb: normal, a: eye-space depth

layout(location = 0) uniform Depths depths;
layout(location = 3) uniform bool windowDepth;      // find depth edges in window depth instead of linear depth
layout(location = 4) uniform float depthThreshold;
layout(location = 5) uniform float normalThreshold;

layout(location = 0) out uint marks;  // bit 0: depth edge, bit 1: normal edge
#ifdef WRITE_MAGNITUDES
layout(location = 1) out vec2 magnitudes;  // depth; normal, the largest of the three channels
#endif

// The four channels that edges are found in, at a pixel; beyond the border the border pixel is repeated.
vec4 channels(ivec2 pixel) {
    vec4 s = texelFetch(surfaces, clamp(pixel, ivec2(0), textureSize(surfaces, 0) - 1), 0);
    s.a = windowDepth ? windowDepthFromEye(s.a, depths) : (s.a - depths.near) / (depths.far - depths.near);
    return s;
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 ix = vec4(0.0);
    vec4 iy = vec4(0.0);
    for (int y = -RADIUS; y <= RADIUS; ++y) {
        for (int x = -RADIUS; x <= RADIUS; ++x) {
            vec4 s = channels(pixel + ivec2(x, y));
            ix += DERIVATIVE[x + RADIUS] * SMOOTHING[y + RADIUS] * s;
            iy += SMOOTHING[x + RADIUS] * DERIVATIVE[y + RADIUS] * s;
        }
    }
    vec4 magnitude = sqrt(ix * ix + iy * iy);  // equation 6
    float normalMagnitude = max(magnitude.r, max(magnitude.g, magnitude.b));
    marks = (magnitude.a >= depthThreshold ? 1u : 0u) | (normalMagnitude >= normalThreshold ? 2u : 0u);  // equation 7
#ifdef WRITE_MAGNITUDES
    magnitudes = vec2(magnitude.a, normalMagnitude);
#endif
}
