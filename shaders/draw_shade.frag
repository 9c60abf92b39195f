#version 450 core
#extension GL_GOOGLE_include_directive : require

// What lies under the lines. CPU definition: reference.h, drawShade().
#define SHADE_FLAT 1
#define SHADE_GOOCH 2
#define SHADE_LIGHT 3

layout(location = 0) in vec3 surfaceNormal;
layout(location = 1) in vec3 viewPosition;
layout(location = 4) in vec4 surfaceColor;
layout(location = 5) in vec2 paintCoordinates;
layout(location = 7) flat in uvec2 triangles;

layout(location = 8) uniform int shade;
layout(location = 9) uniform vec3 towardsLight;  // view space, unit
layout(location = 10) uniform bool orthographic;

layout(location = 0) out vec4 color;  // RGBA8, sRGB

#include "shared/lights.glsl"
#include "shared/paint.glsl"

// src/reference/shade.cpp has the same numbers; a test holds the two together.
const vec3 COOL = vec3(0.0, 0.0, 0.4);
const vec3 WARM = vec3(0.3, 0.3, 0.0);
const float COOL_SHARE = 0.35;  // of the base colour
const float WARM_SHARE = 0.65;
const float AMBIENT = 0.2;

vec3 faceNormal() {
    vec3 n = cross(dFdx(viewPosition), dFdy(viewPosition));
    if (n == vec3(0.0)) return seenSide(surfaceNormal);
    vec3 towardsEye = orthographic ? vec3(0.0, 0.0, 1.0) : -viewPosition;
    return normalize(dot(n, towardsEye) < 0.0 ? -n : n);
}

void main() {
    // Drivers differ: gl_PrimitiveID starts again with each instance, or does not.
    uint triangle = triangles.x + uint(gl_PrimitiveID) % triangles.y;
    vec3 base = clamp(paintOf(triangle, paintCoordinates).rgb * surfaceColor.rgb, 0.0, 1.0);
    float towards = dot(shade == SHADE_FLAT ? faceNormal() : seenSide(surfaceNormal), towardsLight);
    if (shade == SHADE_GOOCH) {
        vec3 paint = toSrgb(base);
        vec3 cool = min(COOL + COOL_SHARE * paint, 1.0);
        vec3 warm = min(WARM + WARM_SHARE * paint, 1.0);
        color = vec4(mix(cool, warm, 0.5 + 0.5 * towards), 1.0);
        return;
    }
    bool lit = shade == SHADE_FLAT || shade == SHADE_LIGHT;
    color = vec4(toSrgb(lit ? base * mix(AMBIENT, 1.0, max(towards, 0.0)) : base), 1.0);
}
