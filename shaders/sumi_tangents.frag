#version 450 core

// The direction of the edges: across the major axis of the blurred structure tensor. CPU definition: reference.h,
// sumi().
layout(binding = 0) uniform sampler2D blurred;  // as sumi_gradients.frag writes it, blurred
layout(binding = 1) uniform sampler2D tensor;   // the same, not blurred

layout(location = 0) out vec4 tangent;  // xy: unit, (0, 0) where no edge is near; z: the ink

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 t = texelFetch(blurred, pixel, 0);
    float difference = t.x - t.y;
    float r = sqrt(difference * difference + 4.0 * t.z * t.z);
    // The angle of the major axis is half that of (difference, 2 xy).
    float cosine = sqrt(max(0.5 + 0.5 * difference / r, 0.0));
    float sine = sqrt(max(1.0 - cosine * cosine, 0.0)) * (t.z < 0.0 ? -1.0 : 1.0);
    tangent = vec4(r > 0.0 ? vec2(-sine, cosine) : vec2(0.0), texelFetch(tensor, pixel, 0).a, 0.0);
}
