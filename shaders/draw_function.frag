#version 450 core
#extension GL_GOOGLE_include_directive : require

// The values of a surface function. The text of the function follows this one: the build puts one of shaders/functions
// there, the renderer a user's.
layout(location = 0) in vec3 surfaceNormal;
layout(location = 1) in vec3 viewPosition;
layout(location = 2) in vec3 objectPosition;
layout(location = 3) in vec2 surfaceCoordinates;
layout(location = 4) in vec4 surfaceColor;
layout(location = 5) in vec2 paintCoordinates;
layout(location = 6) in float surfaceCurvature;
layout(location = 7) flat in uvec2 triangles;

// RGBA32F; the last channel is 1e30 on the background of functions without a value there
layout(location = 0) out vec4 values;

#include "shared/depth.glsl"
#include "shared/lights.glsl"
#include "shared/surface.glsl"

vec4 surface(Surface s);

void main() {
    Surface s;
    s.normal = seenSide(surfaceNormal);
    s.worldNormal = viewToWorld * s.normal;
    s.fromEye = depths.orthographic ? vec3(0.0, 0.0, -1.0) : normalize(viewPosition);
    s.world = viewToWorld * (viewPosition * unitLength) + eye;
    s.object = objectPosition;
    s.depth = -viewPosition.z * unitLength;
    s.coordinates = surfaceCoordinates;
    s.color = surfaceColor;
    s.paint = paintCoordinates;
    s.curvature = gl_FrontFacing ? surfaceCurvature : -surfaceCurvature;
    // Drivers differ: gl_PrimitiveID starts again with each instance, or does not.
    s.triangle = triangles.x + uint(gl_PrimitiveID) % triangles.y;
    vec4 value = surface(s);
    // Values that are not finite would spread into their neighbours.
    values = mix(clamp(value, -1e9, 1e9), vec4(0.0), isnan(value));
}
