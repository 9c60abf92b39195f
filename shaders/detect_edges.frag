#version 450 core
#extension GL_GOOGLE_include_directive : require

// Edges of the depth map and of the normal map. CPU definition: reference.h, detectEdges(); measure_edges.frag is the
// same for one pixel. One invocation decides 4 x 4 pixels, which share texels and the sums along rows:
//
//   . . . . . . . .    a row of samples (.) gives four derivatives and four smoothed values;
//   . . . . . . . .    as soon as 2 RADIUS + 1 rows of these are there, they give a row of pixels (#).
//   . . # # # # . .
//   . . # # # # . .    Farid's kernels; Sobel's need one column and one row less on each side.
#include "shared/edges.glsl"

layout(location = 4) uniform float depthThreshold;
layout(location = 5) uniform float normalThreshold;

// Two bits per pixel: depth edge, normal edge; row by row, the first pixel in the lowest bits.
layout(location = 0) out uint marks;

const int SIDE = 4;
const int SPAN = SIDE + 2 * RADIUS;

// Row r of samples; rows are counted from the top row that the block needs.
vec4 alongX[SPAN * SIDE];
vec4 acrossX[SPAN * SIDE];

void sumRow(int r, vec4 row[SPAN]) {
    for (int x = 0; x < SIDE; ++x) {
        vec4 taps[TAPS];
        for (int i = 0; i < TAPS; ++i) taps[i] = row[x + i];
        alongX[r * SIDE + x] = differentiated(taps);
        acrossX[r * SIDE + x] = smoothed(taps);
    }
}

uint marksOfRow(int y) {
    uint found = 0u;
    for (int x = 0; x < SIDE; ++x) {
        vec4 derivatives[TAPS];
        vec4 smooths[TAPS];
        for (int i = 0; i < TAPS; ++i) {
            derivatives[i] = alongX[(y + i) * SIDE + x];
            smooths[i] = acrossX[(y + i) * SIDE + x];
        }
        vec2 magnitudes = magnitudesOf(smoothed(derivatives), differentiated(smooths));
        uint depth = magnitudes.x >= depthThreshold ? 1u : 0u;  // equation 7
        uint normal = magnitudes.y >= normalThreshold ? 2u : 0u;
        found |= (depth | normal) << (2 * (y * SIDE + x));
    }
    return found;
}

// Offsets must be constants, hence no loop. llvmpipe clamps and fetches such a texel in half the time of texelFetch().
#define SAMPLE(x, y) channels(textureLodOffset(surfaces, corner, 0.0, ivec2(x, y)))
#if KERNEL == KERNEL_SOBEL
#define ROW(y) \
    vec4[](SAMPLE(-1, y), SAMPLE(0, y), SAMPLE(1, y), SAMPLE(2, y), SAMPLE(3, y), SAMPLE(4, y))
#else
#define ROW(y) \
    vec4[](SAMPLE(-2, y), SAMPLE(-1, y), SAMPLE(0, y), SAMPLE(1, y), SAMPLE(2, y), SAMPLE(3, y), SAMPLE(4, y), \
           SAMPLE(5, y))
#endif

void main() {
    vec2 corner = (float(SIDE) * floor(gl_FragCoord.xy) + 0.5) / vec2(textureSize(surfaces, 0));
#if KERNEL == KERNEL_SOBEL
    sumRow(0, ROW(-1));
    sumRow(1, ROW(0));
    sumRow(2, ROW(1));
    marks = marksOfRow(0);
    sumRow(3, ROW(2));
    marks |= marksOfRow(1);
    sumRow(4, ROW(3));
    marks |= marksOfRow(2);
    sumRow(5, ROW(4));
    marks |= marksOfRow(3);
#else
    sumRow(0, ROW(-2));
    sumRow(1, ROW(-1));
    sumRow(2, ROW(0));
    sumRow(3, ROW(1));
    sumRow(4, ROW(2));
    marks = marksOfRow(0);
    sumRow(5, ROW(3));
    marks |= marksOfRow(1);
    sumRow(6, ROW(4));
    marks |= marksOfRow(2);
    sumRow(7, ROW(5));
    marks |= marksOfRow(3);
#endif
}
