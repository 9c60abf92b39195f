#version 450 core

// A Gaussian along one axis; one pass per axis makes a Gaussian in the plane. Beyond the border the border pixel is
// repeated.
layout(binding = 0) uniform sampler2D image;

layout(location = 0) uniform ivec2 direction;  // (1, 0) or (0, 1)
layout(location = 1) uniform int radius;
layout(location = 2) uniform float weights[64];  // of the pixel, of pixels one away, ...; the sum over all taps is 1

layout(location = 0) out vec4 blurred;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    ivec2 last = textureSize(image, 0) - 1;
    blurred = weights[0] * texelFetch(image, pixel, 0);
    for (int i = 1; i <= radius; ++i) {
        blurred += weights[i] * (texelFetch(image, max(pixel - i * direction, ivec2(0)), 0) +
                                 texelFetch(image, min(pixel + i * direction, last), 0));
    }
}
