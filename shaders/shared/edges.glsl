// Shared by the two forms of the edge pass, so that they agree to the last bit.
#include "shared/depth.glsl"

#include "shared/row_sums.glsl"

// rgb: normal, a: eye-space depth; beyond the border the border pixel is repeated.
layout(binding = 0) uniform sampler2D surfaces;

layout(location = 0) uniform Depths depths;
layout(location = 3) uniform bool windowDepth;  // find depth edges in window depth instead of linear depth

// The four channels that edges are found in.
vec4 channels(vec4 surface) { return vec4(surface.rgb, scaledDepth(surface.a, windowDepth, depths)); }

SUMS_OF(vec4)

// Equation 6, of the depth map and of the normal map, for which it is the largest of its three channels.
vec2 magnitudesOf(vec4 ix, vec4 iy) {
    precise vec4 squared = ix * ix + iy * iy;
    return sqrt(vec2(squared.a, max(squared.r, max(squared.g, squared.b))));
}
