#version 450 core
#extension GL_GOOGLE_include_directive : require

// Edges of a surface function's values, 4 x 4 pixels per invocation, as in detect_edges.frag. CPU definition:
// reference.h, functionMagnitude(); measure_function.frag is the same for one pixel.
#include "shared/function_edges.glsl"

layout(location = 0) uniform float threshold;

layout(location = 0) out uint marks;  // as in detect_edges.frag, but only the lower bit of a pixel is used

const int SIDE = 4;
const int SPAN = SIDE + 2 * RADIUS;

// Row r of samples, as in detect_edges.frag.
Sample alongX[SPAN * SIDE];
Sample acrossX[SPAN * SIDE];
Sample centres[SPAN * SIDE];

#ifdef WRAPPED
VALUE lowest = VALUE(1e30);
VALUE highest = VALUE(-1e30);

// Where there is no value the datum stands, one of the block's values.
void widenRange(VALUE value) {
    lowest = min(lowest, value);
    highest = max(highest, value);
}

// Where all values lie within half a period no difference wraps, and the marks are right. Software OpenGL runs every
// branch, but ends loops early: hence loops whose counts may be 0.
uint wrappedMarks(uint marks) {
    bool wraps = largestOf(highest - lowest) > 0.5 * period;
    ivec2 first = SIDE * ivec2(gl_FragCoord.xy);
    uint found = 0u;
    for (int i = 0; i < (wraps ? SIDE * SIDE : 0); ++i) {
        float magnitude = wrappedMagnitude(first + ivec2(i % SIDE, i / SIDE), wraps ? TAPS * TAPS : 0);
        found |= (magnitude >= threshold ? 1u : 0u) << (2 * i);  // equation 7
    }
    return wraps ? found : marks;
}
#endif

void sumRow(int r, Sample row[SPAN]) {
    for (int x = 0; x < SIDE; ++x) {
        Sample taps[TAPS];
        for (int i = 0; i < TAPS; ++i) taps[i] = row[x + i];
        alongX[r * SIDE + x] = differentiated(taps);
        acrossX[r * SIDE + x] = smoothed(taps);
        centres[r * SIDE + x] = row[x + RADIUS];
    }
#ifdef WRAPPED
    for (int x = 0; x < SPAN; ++x) widenRange(row[x].value);
#endif
}

uint marksOfRow(int y) {
    uint found = 0u;
    for (int x = 0; x < SIDE; ++x) {
        Sample derivatives[TAPS];
        Sample smooths[TAPS];
        for (int i = 0; i < TAPS; ++i) {
            derivatives[i] = alongX[(y + i) * SIDE + x];
            smooths[i] = acrossX[(y + i) * SIDE + x];
        }
        Sample centre = centres[(y + RADIUS) * SIDE + x];
        float magnitude = magnitudeOf(smoothed(derivatives), differentiated(smooths), centre);
        found |= (magnitude >= threshold ? 1u : 0u) << (2 * (y * SIDE + x));  // equation 7
    }
    return found;
}

// Offsets must be constants, as in detect_edges.frag.
#define TEXEL(x, y) textureLodOffset(values, corner, 0.0, ivec2(x, y))
#define SAMPLE(x, y) sampleOf(TEXEL(x, y))
#if KERNEL == KERNEL_SOBEL
#define ROW(y) \
    Sample[](SAMPLE(-1, y), SAMPLE(0, y), SAMPLE(1, y), SAMPLE(2, y), SAMPLE(3, y), SAMPLE(4, y))
#else
#define ROW(y) \
    Sample[](SAMPLE(-2, y), SAMPLE(-1, y), SAMPLE(0, y), SAMPLE(1, y), SAMPLE(2, y), SAMPLE(3, y), SAMPLE(4, y), \
             SAMPLE(5, y))
#endif

void main() {
    vec2 corner = (float(SIDE) * floor(gl_FragCoord.xy) + 0.5) / vec2(textureSize(values, 0));
    setDatum(TEXEL(0, 0), TEXEL(3, 0), TEXEL(0, 3), TEXEL(3, 3));
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
#ifdef WRAPPED
    marks = wrappedMarks(marks);
#endif
}
