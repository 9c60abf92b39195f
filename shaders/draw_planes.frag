#version 450 core
#extension GL_GOOGLE_include_directive : require

// The plane and the patch that each pixel sees. On a plane w = 1/z (orthographic: w = -z) is linear in the picture, so
// that w and its derivatives describe the whole plane of the triangle.
layout(location = 0) in float eyeDepth;
layout(location = 1) flat in float patchNumber;
layout(location = 2) flat in uvec2 triangles;

#ifdef SURFACE
layout(location = 3) in vec3 surfaceNormal;
layout(location = 4) in float surfaceDepth;
layout(location = 5) flat in vec4 corner;
#endif

layout(location = 2) uniform bool orthographic;

#ifdef LAYERS
layout(location = 0) out vec4 plane;  // only the last channel is written: adds the layer's number
#else
layout(location = 0) out vec4 plane;     // RGBA32F: w, dw/dx, dw/dy, patch number (0: background, or layers to come)
layout(location = 1) out uint triangle;  // R32UI: 1 + the scene's triangle, 0: background
#endif
#ifdef SURFACE
layout(location = 2) out vec4 surface;  // as draw_surface.frag writes it

#include "shared/edge_on.glsl"
#include "shared/lights.glsl"
#endif

void main() {
#ifdef LAYERS
    plane = vec4(0.0, 0.0, 0.0, -patchNumber);
#else
    float w = orthographic ? -eyeDepth : gl_FragCoord.w;
    plane = vec4(w, dFdx(w), dFdy(w), max(patchNumber, 0.0));
    // Drivers differ: gl_PrimitiveID starts again with each instance, or does not.
    triangle = triangles.x + uint(gl_PrimitiveID) % triangles.y + 1u;
#ifdef SURFACE
    vec4 seen = seenEdgeOn(eyeDepth) ? corner : vec4(surfaceNormal, surfaceDepth);
    vec3 n = seenSide(seen.xyz);
    surface = vec4(positiveLights(n) - negativeLights(n), seen.w);
#endif
#endif
}
