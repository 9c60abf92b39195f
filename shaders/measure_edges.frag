#version 450 core
#extension GL_GOOGLE_include_directive : require

// Gradient magnitudes, one pixel per invocation: the plain form of detect_edges.frag, which equals it bit for bit.
// Hertzmann 1999, appendix A, on the depth map and on the three channels of the normal map at once.
#include "shared/edges.glsl"

layout(location = 0) out vec2 magnitudes;  // depth; normal

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 alongX[TAPS];
    vec4 acrossX[TAPS];
    for (int y = 0; y < TAPS; ++y) {
        vec4 row[TAPS];
        for (int x = 0; x < TAPS; ++x) {
            ivec2 at = clamp(pixel + ivec2(x, y) - RADIUS, ivec2(0), textureSize(surfaces, 0) - 1);
            row[x] = channels(texelFetch(surfaces, at, 0));
        }
        alongX[y] = differentiated(row);
        acrossX[y] = smoothed(row);
    }
    magnitudes = magnitudesOf(smoothed(alongX), differentiated(acrossX));
}
