#version 450 core
#extension GL_GOOGLE_include_directive : require

// Gradient magnitude of a surface function's values, one pixel per invocation: the plain form of detect_function.frag.
// The two are equal bit for bit, or within rounding where differences are wrapped. CPU definition: reference.h,
// functionMagnitude().
#include "shared/function_edges.glsl"

layout(location = 0) out float magnitude;  // the largest of the channels

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
#ifdef WRAPPED
    magnitude = wrappedMagnitude(pixel, TAPS * TAPS);
#else
    ivec2 block = pixel / 4 * 4;
    setDatum(texelAt(block), texelAt(block + ivec2(3, 0)), texelAt(block + ivec2(0, 3)), texelAt(block + 3));
    Sample alongX[TAPS];
    Sample acrossX[TAPS];
    for (int y = 0; y < TAPS; ++y) {
        Sample row[TAPS];
        for (int x = 0; x < TAPS; ++x) row[x] = sampleOf(texelAt(pixel + ivec2(x, y) - RADIUS));
        alongX[y] = differentiated(row);
        acrossX[y] = smoothed(row);
    }
    magnitude = magnitudeOf(smoothed(alongX), differentiated(acrossX), sampleOf(texelAt(pixel)));
#endif
}
