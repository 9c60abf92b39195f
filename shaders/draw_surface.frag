#version 450 core

// The normal map by lights of Hertzmann 1999, section 2.1.2: a white diffuse object, a red, a green and a blue light on
// the axes, and lights of negative intensity opposite to them. A target that cannot hold negative light takes two passes.
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

const vec3 RED = vec3(1.0, 0.0, 0.0);
const vec3 GREEN = vec3(0.0, 1.0, 0.0);
const vec3 BLUE = vec3(0.0, 0.0, 1.0);

vec3 diffuse(vec3 normal, vec3 towardsLight, vec3 color) { return color * max(dot(normal, towardsLight), 0.0); }

vec3 positiveLights(vec3 n) {
    return diffuse(n, vec3(1, 0, 0), RED) + diffuse(n, vec3(0, 1, 0), GREEN) + diffuse(n, vec3(0, 0, 1), BLUE);
}

// With the intensity's sign taken out: how much light is taken away.
vec3 negativeLights(vec3 n) {
    return diffuse(n, vec3(-1, 0, 0), RED) + diffuse(n, vec3(0, -1, 0), GREEN) + diffuse(n, vec3(0, 0, -1), BLUE);
}

void main() {
    // Two-sided lighting: the side that is seen is the side that is lit.
    vec3 n = normalize(gl_FrontFacing ? surfaceNormal : -surfaceNormal);
#if LIGHTS == LIGHTS_BOTH
    surface = vec4(positiveLights(n) - negativeLights(n), eyeDepth);
#elif LIGHTS == LIGHTS_POSITIVE
    light = positiveLights(n);
#else
    light = negativeLights(n);
#endif
}
