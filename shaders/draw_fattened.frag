#version 450 core

layout(location = 0) flat in vec4 segment;  // as draw_fattened.geom writes them
layout(location = 1) flat in float reach;

layout(location = 0) out float ink;  // R8

void main() {
    ink = 0.0;
    if (reach == 0.0) return;
    vec2 along = segment.zw - segment.xy;
    vec2 offset = gl_FragCoord.xy - segment.xy;
    float share = clamp(dot(offset, along) / dot(along, along), 0.0, 1.0);
    if (distance(offset, share * along) > reach) discard;
    ink = 1.0;
}
