#version 450 core
#extension GL_GOOGLE_include_directive : require

// Lines without thresholds: a line runs between two neighbouring pixels if the faces that they see do not go on into
// each other. CPU definition: reference.h, detectLines(). One invocation decides 4 x 4 pixels, which share texels.
//
//   p . | q    The planes of p and q are extended over the step between the two pixels. Either they meet on the step,
//   ----+--    and the surface goes on; or they leave a residual on both sides, and the surface jumps.
//   s   |
layout(binding = 0) uniform sampler2D planes;  // as draw_planes.frag writes them

layout(location = 3) uniform float creaseCosine;  // c |c|, where c is the cosine of the crease angle

// One byte per pixel, four pixels per component (the first in the low byte), four rows per texel.
layout(location = 0) out uvec4 marks;

#include "shared/marks.glsl"
#include "shared/planes.glsl"

const float WITHIN_PATCH = 0.02;  // the mesh says whether so small a jump is one

uint pairMarks(vec4 p, vec4 q, vec3 np, vec3 nq, float gp, float gq, float focal) {
    if (p.w == 0.0 || q.w == 0.0) return p.w == q.w ? 0u : BACKGROUND;
    float d = dot(np, nq);
    uint found = p.w == q.w ? 0u : PATCH;
    if (d * abs(d) < creaseCosine * dot(np, np) * dot(nq, nq)) found |= BEND;
    if (jumps(p.x, q.x, gp, gq, focal, p.w == q.w ? WITHIN_PATCH : 1.0)) found |= JUMP;
    return found;
}

void main() {
    ivec2 size = textureSize(planes, 0);
    ivec2 first = 4 * ivec2(gl_FragCoord.xy);
    ivec2 inside = size - first;

    // The row of samples above the current row.
    vec4 above[5];
    vec3 aboveNormal[5];
    marks = uvec4(0u);
    // A count that the compiler does not know keeps it from repeating the rows' code, which takes it five times as long
    // to compile. Samples beyond the planes are those at their border again: no pairs.
    int last = min(4, inside.y);
    for (int y = 0; y <= last; ++y) {
        vec4 row[5];
        vec3 normal[5];
        uint found = 0u;
        for (int x = 0; x < 5; ++x) {
            ivec2 pixel = min(first + ivec2(x, y), size - 1);
            // llvmpipe clamps and fetches such a texel in half the time of texelFetch().
            row[x] = textureLod(planes, (vec2(pixel) + 0.5) / vec2(size), 0.0);
            normal[x] = normalOf(row[x], vec2(pixel) + 0.5 - centre);
        }
        if (y > 0) {
            for (int x = 0; x < 4; ++x) {
                uint right = x + 1 < inside.x ? pairMarks(above[x], above[x + 1], aboveNormal[x], aboveNormal[x + 1],
                                                              above[x].y, above[x + 1].y, focalLengths.x)
                                                  : 0u;
                uint below = y < inside.y ? pairMarks(above[x], row[x], aboveNormal[x], normal[x], above[x].z,
                                                      row[x].z, focalLengths.y)
                                          : 0u;
                found |= (right | (below << 4)) << (8 * x);
            }
            marks[y - 1] = found;
        }
        above = row;
        aboveNormal = normal;
    }
}
