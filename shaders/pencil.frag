#version 450 core

// Loose strokes after Curtis 1998 (reference 5 of Hertzmann 1999): the drawing is drawn several times, each time
// displaced by smooth noise and with a varying pressure on paper with a grain. CPU definition: reference.h, pencil().
layout(binding = 0) uniform sampler2D drawing;  // RGBA8, not premultiplied

layout(location = 0) uniform ivec2 corner;  // of the tile in the picture
layout(location = 1) uniform int strokes;
layout(location = 2) uniform float looseness;  // pixels
layout(location = 3) uniform uint seed;

layout(location = 0) out vec4 drawn;  // not premultiplied

// Mixes bits: finaliser and constants after Wellons 2018, "triple32".
uint mixed(uvec3 v) {
    uint h = v.x * 0x9e3779b1u ^ v.y * 0x85ebca77u ^ v.z * 0xc2b2ae3du;
    h = (h ^ (h >> 17)) * 0xed5ad4bbu;
    h = (h ^ (h >> 11)) * 0xac4c1b51u;
    h = (h ^ (h >> 15)) * 0x31848babu;
    return h ^ (h >> 14);
}

float chance(uvec2 knot, uint layer) { return float(mixed(uvec3(knot, layer)) >> 8) / 16777216.0; }

// Noise from 0 to 1, smooth between knots that are `cell` pixels apart.
float noise(vec2 pixel, float cell, uint layer) {
    vec2 p = pixel / cell;
    uvec2 knot = uvec2(floor(p));
    vec2 f = p - floor(p);
    f = f * f * f * (f * (6.0 * f - 15.0) + 10.0);
    float upper = mix(chance(knot, layer), chance(knot + uvec2(1, 0), layer), f.x);
    float lower = mix(chance(knot + uvec2(0, 1), layer), chance(knot + uvec2(1, 1), layer), f.x);
    return mix(upper, lower, f.y);
}

// Noise from -1.3 to 1.3, mostly within a half.
float stray(vec2 pixel, float cell, uint layer) {
    return (2.0 * noise(pixel, cell, layer) - 1.0) + 0.3 * (2.0 * noise(pixel, cell / 3.0, layer + 1u) - 1.0);
}

vec4 texelAt(ivec2 pixel) {
    vec4 t = texelFetch(drawing, clamp(pixel, ivec2(0), textureSize(drawing, 0) - 1), 0);
    return vec4(t.rgb * t.a, t.a);
}

// The drawing between four pixels, premultiplied.
vec4 inkAt(vec2 position) {
    vec2 corner = floor(position - 0.5);
    vec2 share = position - 0.5 - corner;
    ivec2 pixel = ivec2(corner);
    return mix(mix(texelAt(pixel), texelAt(pixel + ivec2(1, 0)), share.x),
               mix(texelAt(pixel + ivec2(0, 1)), texelAt(pixel + ivec2(1, 1)), share.x), share.y);
}

const uint LAYERS = 8u;  // of noise per stroke

void main() {
    vec2 pixel = gl_FragCoord.xy + vec2(corner);
    float cell = max(16.0 * looseness, 24.0);
    vec4 sum = vec4(0.0);  // premultiplied
    float grain = -1.0;
    for (int i = 0; i < strokes; ++i) {
        uint layer = (seed * 16u + uint(i)) * LAYERS;
        vec2 away = looseness * 1.5 * vec2(stray(pixel, cell, layer), stray(pixel, cell, layer + 2u));
        vec4 found = inkAt(gl_FragCoord.xy + away);
        if (found.a == 0.0) continue;
        if (grain < 0.0) grain = 0.6 * noise(pixel, 1.7, 0xfffffffeu) + 0.4 * noise(pixel, 3.1, 0xffffffffu);
        float pressed = found.a * (0.5 + 0.5 * noise(pixel, 1.3 * cell, layer + 4u));
        // The lower the pressure, the more of the paper's hollows stay white.
        float left = clamp((pressed - 0.6 * grain * (1.0 - pressed)) / 0.5, 0.0, 1.0) * min(0.35 + pressed, 1.0);
        vec4 added = vec4(found.rgb / found.a, 1.0) * (0.85 * left);
        sum = added + sum * (1.0 - added.a);
    }
    drawn = vec4(sum.a > 0.0 ? sum.rgb / sum.a : vec3(0.0), sum.a);
}
