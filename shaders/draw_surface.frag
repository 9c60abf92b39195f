#version 450 core
#extension GL_GOOGLE_include_directive : require

// The normal map by lights. A target that cannot hold negative light takes two passes.
#define LIGHTS_BOTH 0
#define LIGHTS_POSITIVE 1
#define LIGHTS_NEGATIVE 2

layout(location = 0) in vec3 surfaceNormal;
layout(location = 1) in float eyeDepth;
layout(location = 2) flat in vec4 corner;

layout(location = 1) uniform float unitLength;  // as in draw_surface.vert

#if LIGHTS == LIGHTS_BOTH
layout(location = 0) out vec4 surface;  // RGBA32F: light received = normal; eye-space depth, scene units
#else
layout(location = 0) out vec3 light;  // RGBA8
#endif

#include "shared/edge_on.glsl"
#include "shared/lights.glsl"

void main() {
    vec4 seen = seenEdgeOn(eyeDepth / unitLength) ? corner : vec4(surfaceNormal, eyeDepth);
    vec3 n = seenSide(seen.xyz);
#if LIGHTS == LIGHTS_BOTH
    surface = vec4(positiveLights(n) - negativeLights(n), seen.w);
#elif LIGHTS == LIGHTS_POSITIVE
    light = positiveLights(n);
#else
    light = negativeLights(n);
#endif
}
