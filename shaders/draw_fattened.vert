#version 450 core
#extension GL_GOOGLE_include_directive : require

layout(location = 0) in vec3 position;      // mesh space
layout(location = 2) in vec4 modelView[3];  // rows; per instance: mesh space -> view space in unit lengths
layout(location = 9) in uvec3 numbering;    // per instance: its first patch, its first triangle, its triangles

layout(location = 0) uniform mat4 projection;  // as in draw_surface.vert

layout(location = 0) flat out uvec2 triangles;  // the instance's first triangle; how many there are

#include "shared/view.glsl"

void main() {
    vec4 p = vec4(position, 1.0);
    triangles = numbering.yz;
    gl_Position = inView(projection * vec4(dot(modelView[0], p), dot(modelView[1], p), dot(modelView[2], p), 1.0));
}
