#version 450 core
#extension GL_GOOGLE_include_directive : require

layout(location = 0) in vec3 position;     // mesh space, less the mesh's origin
layout(location = 1) in vec3 normal;       // mesh space, unit
layout(location = 2) in vec4 modelView[3];     // rows; per instance: mesh space -> view space in unit lengths
layout(location = 5) in vec4 normalMatrix[3];  // rows; per instance: mesh space -> view space
layout(location = 9) in uvec3 numbering;       // per instance: its first patch, its first triangle, its triangles
layout(location = 10) in vec2 textureCoordinates;
layout(location = 11) in vec4 color;
layout(location = 12) in vec2 pictureCoordinates;
layout(location = 13) in float curvature;  // 1 / unit of mesh space

layout(location = 0) uniform mat4 projection;  // as in draw_surface.vert

layout(location = 0) out vec3 surfaceNormal;
layout(location = 1) out vec3 viewPosition;  // unit lengths
layout(location = 2) out vec3 objectPosition;
layout(location = 3) out vec2 surfaceCoordinates;
layout(location = 4) out vec4 surfaceColor;
layout(location = 5) out vec2 paintCoordinates;
layout(location = 6) out float surfaceCurvature;
layout(location = 7) flat out uvec2 triangles;  // the instance's first triangle; how many there are

#include "shared/view.glsl"

void main() {
    vec4 p = vec4(position, 1.0);
    viewPosition = vec3(dot(modelView[0], p), dot(modelView[1], p), dot(modelView[2], p));
    vec4 n = vec4(normal, 0.0);
    surfaceNormal = vec3(dot(normalMatrix[0], n), dot(normalMatrix[1], n), dot(normalMatrix[2], n));
    // The object's own axes, the scene's lengths.
    float volume = abs(dot(modelView[0].xyz, cross(modelView[1].xyz, modelView[2].xyz)));
    float radii = pow(volume, 1.0 / 3.0);
    objectPosition = position * radii;
    surfaceCoordinates = textureCoordinates;
    surfaceColor = color;
    paintCoordinates = pictureCoordinates;
    surfaceCurvature = radii > 0.0 ? curvature / radii : 0.0;
    triangles = numbering.yz;
    gl_Position = inView(projection * vec4(viewPosition, 1.0));
}
