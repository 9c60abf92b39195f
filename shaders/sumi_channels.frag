#version 450 core
#extension GL_GOOGLE_include_directive : require

// The channels whose gradients take ink: normals and depth, in units in which a step of 1 takes half of the ink. CPU
// definition: reference.h, sumi().
#include "shared/depth.glsl"

layout(binding = 0) uniform sampler2D surfaces;  // rgb: normal, a: eye-space depth; background: normal 0

layout(location = 0) uniform Depths depths;
layout(location = 3) uniform float streaks;  // steps from near to far that depth is rounded to; 0: not rounded

layout(location = 0) out vec4 channels;

const float NORMAL_STEP = 0.5;
const float DEPTH_STEP = 0.06;  // of the way from near to far

void main() {
    vec4 s = texelFetch(surfaces, ivec2(gl_FragCoord.xy), 0);
    float depth = scaledDepth(s.a, false, depths);
    if (streaks > 0.0) depth = floor(depth * streaks) / streaks;
    if (s.rgb == vec3(0.0)) depth = 1.0;
    channels = vec4(s.rgb / NORMAL_STEP, depth / DEPTH_STEP);
}
