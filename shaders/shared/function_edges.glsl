// What the two forms of the functions' edge pass share: Hertzmann 1999, appendix A, on differences from the pixel's own
// value. What is not there differs from nothing.
#include "shared/row_sums.glsl"

layout(binding = 0) uniform sampler2D values;  // as draw_function.frag writes them; beyond the border it repeats it

#ifdef WRAPPED
#define VALUE vec2  // Wrapping: values that begin anew have two channels
VALUE valueOf(vec4 texel) { return texel.xy; }
float largestOf(VALUE channels) { return max(channels.x, channels.y); }
#else
#define VALUE vec4
VALUE valueOf(vec4 texel) { return texel; }
float largestOf(VALUE channels) { return max(max(channels.r, channels.g), max(channels.b, channels.a)); }
#endif

struct Sample {
    VALUE value;  // 0 where there is none
    float there;  // 0 on the background of functions that have no value there, else 1
};

Sample sampleOf(vec4 texel) {
    float there = texel.a > 1e29 ? 0.0 : 1.0;
    return Sample(there * valueOf(texel), there);
}

Sample sampleAt(ivec2 pixel) {
    return sampleOf(texelFetch(values, clamp(pixel, ivec2(0), textureSize(values, 0) - 1), 0));
}

SUMS_OF(VALUE)
SUMS_OF(float)

void split(Sample s[TAPS], out VALUE v[TAPS], out float there[TAPS]) {
    for (int i = 0; i < TAPS; ++i) {
        v[i] = s[i].value;
        there[i] = s[i].there;
    }
}

Sample smoothed(Sample s[TAPS]) {
    VALUE v[TAPS];
    float there[TAPS];
    split(s, v, there);
    return Sample(smoothed(v), smoothed(there));
}

Sample differentiated(Sample s[TAPS]) {
    VALUE v[TAPS];
    float there[TAPS];
    split(s, v, there);
    return Sample(differentiated(v), differentiated(there));
}

// Equation 6, the largest of the channels.
float magnitudeOf(VALUE ix, VALUE iy, Sample centre) {
    precise VALUE squared = ix * ix + iy * iy;
    return centre.there * sqrt(largestOf(squared));
}

// The sum of k (v - c) over what is there is that of k v less c times that of k: both are separable.
float magnitudeOf(Sample x, Sample y, Sample centre) {
    precise VALUE ix = x.value - x.there * centre.value;
    precise VALUE iy = y.value - y.there * centre.value;
    return magnitudeOf(ix, iy, centre);
}

#ifdef WRAPPED
layout(location = 1) uniform float period;  // differences are taken modulo this

// Tap by tap, as each pixel has differences of its own.
// @param taps  TAPS * TAPS; with 0 the result means nothing
float wrappedMagnitude(ivec2 pixel, int taps) {
    Sample centre = sampleAt(pixel);
    VALUE ix = VALUE(0.0);
    VALUE iy = VALUE(0.0);
    for (int i = 0; i < taps; ++i) {
        ivec2 tap = ivec2(i % TAPS, i / TAPS);
        Sample s = sampleAt(pixel + tap - RADIUS);
        VALUE d = s.value - centre.value;
        d = s.there * (d - period * roundEven(d / period));
        ix += DERIVATIVE[tap.x] * SMOOTHING[tap.y] * d;
        iy += SMOOTHING[tap.x] * DERIVATIVE[tap.y] * d;
    }
    return magnitudeOf(ix, iy, centre);
}
#endif
