#version 450 core
#extension GL_GOOGLE_include_directive : require

layout(location = 0) in vec3 position;      // mesh space
layout(location = 2) in vec4 modelView[3];  // rows; per instance: mesh space -> view space in unit lengths
#ifdef SURFACE
layout(location = 1) in vec3 normal;           // as in draw_surface.vert
layout(location = 5) in vec4 normalMatrix[3];
#endif
layout(location = 8) in uint patchIndex;    // of the mesh's patches; the same at all corners of a triangle
layout(location = 9) in uvec3 numbering;    // per instance: its first patch, its first triangle, its triangles

// The numbers of all instances' patches; negative where coplanar layers overlap. See src/gl/upload.cpp.
layout(std430, binding = 0) readonly buffer PatchNumbers { float patchNumbers[]; };

layout(location = 0) uniform mat4 projection;  // as in draw_surface.vert
layout(location = 1) uniform float layerLift;  // added to clip-space z: lifts a layer towards the eye

#ifdef SURFACE
layout(location = 3) uniform float unitLength;  // as in draw_surface.vert
#endif

layout(location = 0) out float eyeDepth;  // unit lengths
layout(location = 1) flat out float patchNumber;
layout(location = 2) flat out uvec2 triangles;  // the instance's first triangle; how many there are
#ifdef SURFACE
layout(location = 3) out vec3 surfaceNormal;  // as in draw_surface.vert
layout(location = 4) out float surfaceDepth;
layout(location = 5) flat out vec4 corner;  // as in draw_surface.vert
#endif

invariant gl_Position;  // in the second pass layers must cover the same pixels as in the first

#include "shared/view.glsl"

void main() {
    vec4 p = vec4(position, 1.0);
    vec3 viewPosition = vec3(dot(modelView[0], p), dot(modelView[1], p), dot(modelView[2], p));
    eyeDepth = -viewPosition.z;
    patchNumber = patchNumbers[numbering.x + patchIndex];
    triangles = numbering.yz;
    gl_Position = inView(projection * vec4(viewPosition, 1.0));
    gl_Position.z += layerLift;
#ifdef SURFACE
    vec4 n = vec4(normal, 0.0);
    surfaceNormal = vec3(dot(normalMatrix[0], n), dot(normalMatrix[1], n), dot(normalMatrix[2], n));
    surfaceDepth = eyeDepth * unitLength;
    corner = vec4(surfaceNormal, surfaceDepth);
#endif
}
