// Shared by the two forms of the functions' edge pass: Hertzmann 1999, appendix A, on differences from the pixel's own
// value. Where there is no value the difference is 0.
#include "shared/row_sums.glsl"

layout(binding = 0) uniform sampler2D values;  // as draw_function.frag writes them; the border pixel is repeated

#ifdef WRAPPED
#define VALUE vec2  // Wrapping: values that wrap have two channels
VALUE valueOf(vec4 texel) { return texel.xy; }
float largestOf(VALUE channels) { return max(channels.x, channels.y); }
#else
#define VALUE vec4
VALUE valueOf(vec4 texel) { return texel; }
float largestOf(VALUE channels) { return max(max(channels.r, channels.g), max(channels.b, channels.a)); }
#endif

struct Sample {
    VALUE value;  // datum where there is none
    float there;  // 0 on the background of functions that have no value there, else 1
};

bool isThere(vec4 texel) { return texel.a < 1e29; }

// The value that stands where there is none: that of a corner of the block of 4 x 4 pixels, so that large values do not
// lead to large rounding.
VALUE datum = VALUE(0.0);

void setDatum(vec4 a, vec4 b, vec4 c, vec4 d) {
    vec4 texel = isThere(a) ? a : isThere(b) ? b : isThere(c) ? c : d;
    datum = isThere(texel) ? valueOf(texel) : VALUE(0.0);
}

Sample sampleOf(vec4 texel) {
    bool there = isThere(texel);
    return Sample(there ? valueOf(texel) : datum, there ? 1.0 : 0.0);
}

vec4 texelAt(ivec2 pixel) { return texelFetch(values, clamp(pixel, ivec2(0), textureSize(values, 0) - 1), 0); }

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

// The sum of k (v - c) over the pixels with a value equals the sum of k v over all pixels, less (c - datum) times the
// sum of k over the pixels with a value, since the sum of all k is 0. Both sums are separable.
float magnitudeOf(Sample x, Sample y, Sample centre) {
    VALUE above = centre.value - datum;
    precise VALUE ix = x.value - x.there * above;
    precise VALUE iy = y.value - y.there * above;
    return magnitudeOf(ix, iy, centre);
}

#ifdef WRAPPED
layout(location = 1) uniform float period;  // differences are taken modulo this

// Sums tap by tap, as each pixel has differences of its own.
// @param taps  TAPS * TAPS; with 0 the result has no meaning
float wrappedMagnitude(ivec2 pixel, int taps) {
    Sample centre = sampleOf(texelAt(pixel));
    VALUE ix = VALUE(0.0);
    VALUE iy = VALUE(0.0);
    for (int i = 0; i < taps; ++i) {
        ivec2 tap = ivec2(i % TAPS, i / TAPS);
        Sample s = sampleOf(texelAt(pixel + tap - RADIUS));
        VALUE d = s.value - centre.value;
        d = s.there * (d - period * roundEven(d / period));
        ix += DERIVATIVE[tap.x] * SMOOTHING[tap.y] * d;
        iy += SMOOTHING[tap.x] * DERIVATIVE[tap.y] * d;
    }
    return magnitudeOf(ix, iy, centre);
}
#endif
