#version 450 core

// The outline picture: line colour on an edge, background off it (Hertzmann 1999, section 2.2, first sentence).
layout(binding = 0) uniform usampler2D marks;  // not 0: an edge

layout(location = 0) uniform vec4 lineColor;
layout(location = 1) uniform vec4 background;

#ifdef GREY
layout(location = 0) out float picture;
#else
layout(location = 0) out vec4 picture;
#endif

void main() {
    bool edge = texelFetch(marks, ivec2(gl_FragCoord.xy), 0).r != 0u;
    vec4 color = edge ? lineColor : background;
#ifdef GREY
    picture = color.r;
#else
    picture = color;
#endif
}
