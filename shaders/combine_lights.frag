#version 450 core
#extension GL_GOOGLE_include_directive : require

#include "shared/depth.glsl"

// The second half of the two-pass normal map: positive minus negative light, and depth from the depth buffer.
layout(binding = 0) uniform sampler2D positiveLight;
layout(binding = 1) uniform sampler2D negativeLight;
layout(binding = 2) uniform sampler2D reversedDepth;  // 1 at near, 0 at far and on the background

layout(location = 0) uniform Depths depths;

layout(location = 0) out vec4 surface;  // as draw_surface.frag writes it

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec3 light = texelFetch(positiveLight, pixel, 0).rgb - texelFetch(negativeLight, pixel, 0).rgb;
    surface = vec4(light, eyeDepthFromReversed(texelFetch(reversedDepth, pixel, 0).r, depths));
}
