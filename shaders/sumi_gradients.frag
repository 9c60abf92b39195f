#version 450 core

// Gradients of the blurred channels by the Sobel kernels (Hertzmann 1999, equation 5): how much ink each pixel takes,
// and the structure tensor, whose minor axis runs along the edge. CPU definition: reference.h, sumi().
layout(binding = 0) uniform sampler2D channels;

layout(location = 0) uniform float gain;  // makes a step of 1 a magnitude of 1

layout(location = 0) out vec4 tensor;  // xx, yy, xy; its last channel is the ink, 0 to 1

vec4 at(int x, int y) {
    ivec2 pixel = ivec2(gl_FragCoord.xy) + ivec2(x, y);
    return texelFetch(channels, clamp(pixel, ivec2(0), textureSize(channels, 0) - 1), 0);
}

void main() {
    vec4 ix = gain * (at(1, -1) + 2.0 * at(1, 0) + at(1, 1) - at(-1, -1) - 2.0 * at(-1, 0) - at(-1, 1));
    vec4 iy = gain * (at(-1, 1) + 2.0 * at(0, 1) + at(1, 1) - at(-1, -1) - 2.0 * at(0, -1) - at(1, -1));
    vec4 squared = ix * ix + iy * iy;
    float magnitude = sqrt(max(max(squared.r, squared.g), max(squared.b, squared.a)));
    float taken = magnitude * sqrt(magnitude);
    // Normalised, so that a strong edge does not decide the direction of weak edges beside it.
    float share = 1.0 / (1.0 + squared.r + squared.g + squared.b + squared.a);
    tensor = vec4(share * vec3(dot(ix, ix), dot(iy, iy), dot(ix, iy)), taken / (1.0 + taken));
}
