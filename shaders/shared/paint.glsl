// Colours and pictures of materials. All pictures are in one buffer, each followed by its smaller copies, so that one
// draw can use any number of them.
struct Paint {
    vec4 factor;   // linear
    uint first;    // index of the picture's first texel; without a picture the number of levels is 0
    uint width;
    uint height;
    uint levels;
    uvec2 wrap;    // along each axis: 0 clamps, 1 mirrors, 2 repeats
    uvec2 unused;
};
layout(std430, binding = 1) readonly buffer TrianglePaints { uint trianglePaints[]; };  // into paints
layout(std430, binding = 2) readonly buffer Paints { Paint paints[]; };
layout(std430, binding = 3) readonly buffer Texels { uint texels[]; };  // RGBA8, sRGB

vec3 toSrgb(vec3 c) {
    c = clamp(c, 0.0, 1.0);
    return mix(12.92 * c, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, greaterThan(c, vec3(0.0031308)));
}

vec3 toLinear(vec3 c) { return mix(c / 12.92, pow((c + 0.055) / 1.055, vec3(2.4)), greaterThan(c, vec3(0.04045))); }

int wrapped(int texel, int size, uint wrap) {
    if (wrap == 0u) return clamp(texel, 0, size - 1);
    int period = wrap == 1u ? 2 * size : size;
    int inPeriod = texel - period * int(floor(float(texel) / float(period)));
    return inPeriod < size ? inPeriod : 2 * size - 1 - inPeriod;
}

vec4 texelAt(Paint paint, uint first, ivec2 size, ivec2 texel) {
    int x = wrapped(texel.x, size.x, paint.wrap.x);
    int y = wrapped(texel.y, size.y, paint.wrap.y);
    return unpackUnorm4x8(texels[first + uint(y * size.x + x)]);
}

vec4 filtered(Paint paint, int level, vec2 coordinates) {
    uint first = paint.first;
    ivec2 size = ivec2(paint.width, paint.height);
    for (int i = 0; i < level; ++i) {
        first += uint(size.x * size.y);
        size = max(size / 2, ivec2(1));
    }
    vec2 position = coordinates * vec2(size) - 0.5;
    ivec2 corner = ivec2(floor(position));
    vec2 share = position - vec2(corner);
    vec4 upper = mix(texelAt(paint, first, size, corner), texelAt(paint, first, size, corner + ivec2(1, 0)), share.x);
    vec4 lower =
        mix(texelAt(paint, first, size, corner + ivec2(0, 1)), texelAt(paint, first, size, corner + 1), share.x);
    return mix(upper, lower, share.y);
}

// The linear colour of a triangle's material.
vec4 paintOf(uint triangle, vec2 coordinates) {
    Paint paint = paints[trianglePaints[triangle]];
    vec2 size = vec2(paint.width, paint.height);
    float texelsAPixel = max(length(dFdx(coordinates) * size), length(dFdy(coordinates) * size));
    if (paint.levels == 0u) return paint.factor;
    float level = clamp(log2(max(texelsAPixel, 1.0)), 0.0, float(paint.levels - 1u));
    int fine = int(level);
    int coarse = min(fine + 1, int(paint.levels) - 1);
    vec4 color = mix(filtered(paint, fine, coordinates), filtered(paint, coarse, coordinates), level - float(fine));
    return paint.factor * vec4(toLinear(color.rgb), color.a);
}
