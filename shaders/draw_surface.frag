#version 450 core
#extension GL_GOOGLE_include_directive : require

// The normal map by lights. A target that cannot hold negative light takes two passes.
#define LIGHTS_BOTH 0
#define LIGHTS_POSITIVE 1
#define LIGHTS_NEGATIVE 2

layout(location = 0) in vec3 surfaceNormal;
layout(location = 1) in float eyeDepth;

#if LIGHTS == LIGHTS_BOTH
layout(location = 0) out vec4 surface;  // RGBA32F: light received = normal; eye-space depth, scene units
#else
layout(location = 0) out vec3 light;  // RGBA8
#endif

#include "shared/lights.glsl"

void main() {
    vec3 n = seenSide(surfaceNormal);
#if LIGHTS == LIGHTS_BOTH
    surface = vec4(positiveLights(n) - negativeLights(n), eyeDepth);
#elif LIGHTS == LIGHTS_POSITIVE
    light = positiveLights(n);
#else
    light = negativeLights(n);
#endif
}
