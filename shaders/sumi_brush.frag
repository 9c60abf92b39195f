#version 450 core

// Smears ink along the edges: the mean of the ink along the tangents through each pixel, weighted by a Gaussian. CPU
// definition: reference.h, sumi().
layout(binding = 0) uniform sampler2D tangents;  // as sumi_tangents.frag writes them

layout(location = 0) uniform int steps;  // each way, of a pixel
// Of the pixel, of points one step away, ...; the sum over both ways is 1.
layout(location = 1) uniform float weights[128];

layout(location = 0) out float ink;

float smear(vec2 pixel, vec2 direction) {
    vec2 last = vec2(textureSize(tangents, 0) - 1);
    float sum = 0.0;
    for (int i = 1; i <= steps; ++i) {
        pixel += direction;
        vec4 t = texelFetch(tangents, ivec2(clamp(floor(pixel), vec2(0.0), last)), 0);
        sum += weights[i] * t.z;
        direction = dot(t.xy, direction) < 0.0 ? -t.xy : t.xy;  // an axis has no sign
    }
    return sum;
}

void main() {
    vec2 pixel = gl_FragCoord.xy;
    vec4 t = texelFetch(tangents, ivec2(pixel), 0);
    ink = t.z;
    if (t.xy == vec2(0.0)) return;
    ink = weights[0] * t.z + smear(pixel, t.xy) + smear(pixel, -t.xy);
}
