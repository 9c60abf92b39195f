#version 450 core
#extension GL_GOOGLE_include_directive : require

layout(location = 0) in vec3 position;     // mesh space
layout(location = 1) in vec3 normal;       // mesh space, unit
layout(location = 2) in vec4 modelView[3];     // rows; per instance: mesh space -> view space in unit lengths
layout(location = 5) in vec4 normalMatrix[3];  // rows; per instance: mesh space -> the lights' space

layout(location = 0) uniform mat4 projection;   // view space in unit lengths -> clip space, z reversed: w near, 0 far
layout(location = 1) uniform float unitLength;  // scene units

layout(location = 0) out vec3 surfaceNormal;  // the lights' space, any length
layout(location = 1) out float eyeDepth;      // scene units
layout(location = 2) flat out vec4 corner;    // both, at one corner of the triangle

invariant gl_Position;  // the two passes of the two-pass normal map must agree on depth

#include "shared/view.glsl"

void main() {
    vec4 p = vec4(position, 1.0);
    vec3 viewPosition = vec3(dot(modelView[0], p), dot(modelView[1], p), dot(modelView[2], p));
    vec4 n = vec4(normal, 0.0);
    surfaceNormal = vec3(dot(normalMatrix[0], n), dot(normalMatrix[1], n), dot(normalMatrix[2], n));
    eyeDepth = -viewPosition.z * unitLength;
    corner = vec4(surfaceNormal, eyeDepth);
    gl_Position = inView(projection * vec4(viewPosition, 1.0));
}
