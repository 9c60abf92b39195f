#version 450 core

// Smears ink along the edges: the mean along the line of tangents through each pixel, by a Gaussian. CPU definition:
// reference.h, sumi().
layout(binding = 0) uniform sampler2D tangents;  // as sumi_tangents.frag writes them

layout(location = 0) uniform int steps;  // each way, of a pixel
layout(location = 1) uniform float weights[128];  // of the pixel, of those one step away, ...; their sum over both ways is 1

layout(location = 0) out float ink;

float smear(vec2 place, vec2 direction) {
    vec2 last = vec2(textureSize(tangents, 0) - 1);
    float sum = 0.0;
    for (int i = 1; i <= steps; ++i) {
        place += direction;
        vec4 t = texelFetch(tangents, ivec2(clamp(floor(place), vec2(0.0), last)), 0);
        sum += weights[i] * t.z;
        direction = dot(t.xy, direction) < 0.0 ? -t.xy : t.xy;  // an axis has no sign
    }
    return sum;
}

void main() {
    vec2 place = gl_FragCoord.xy;
    vec4 t = texelFetch(tangents, ivec2(place), 0);
    ink = t.z;
    if (t.xy == vec2(0.0)) return;
    ink = weights[0] * t.z + smear(place, t.xy) + smear(place, -t.xy);
}
