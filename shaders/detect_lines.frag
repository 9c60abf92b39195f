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

uint pairMarks(vec4 p, vec4 q, vec3 np, vec3 nq, float gp, float gq) {
    if (p.w == 0.0 || q.w == 0.0) return p.w == q.w ? 0u : BACKGROUND;
    float d = dot(np, nq);
    uint found = p.w == q.w ? 0u : PATCH;
    if (d * abs(d) < creaseCosine * dot(np, np) * dot(nq, nq)) found |= BEND;
    if (jumps(p.x, q.x, gp, gq, p.w == q.w ? WITHIN_PATCH : 1.0)) found |= JUMP;
    return found;
}

// The row of samples above the current row.
vec4 above[5];
vec3 aboveNormal[5];

// The marks of the pixels above row y. Row y then becomes the row above. Samples beyond the planes are those at their
// border again: no pairs.
uint marksAbove(int y, vec4 row[5]) {
    ivec2 size = textureSize(planes, 0);
    ivec2 inside = size - 4 * ivec2(gl_FragCoord.xy);
    uint found = 0u;
    for (int x = 0; x < 4 && y > 0 && x + 1 < inside.x; ++x) {
        found |= pairMarks(above[x], above[x + 1], aboveNormal[x], aboveNormal[x + 1], above[x].y, above[x + 1].y)
                 << (8 * x);
    }
    for (int x = 0; x < 5; ++x) {
        ivec2 pixel = min(4 * ivec2(gl_FragCoord.xy) + ivec2(x, y), size - 1);
        vec3 normal = normalOf(row[x], vec2(pixel) + 0.5 - centre);
        if (x < 4 && y > 0 && y < inside.y) {
            found |= pairMarks(above[x], row[x], aboveNormal[x], normal, above[x].z, row[x].z) << (8 * x + 4);
        }
        above[x] = row[x];
        aboveNormal[x] = normal;
    }
    return found;
}

// Offsets must be constants, hence no loop. llvmpipe clamps and fetches such a texel in half the time of texelFetch().
#define SAMPLE(x, y) textureLodOffset(planes, corner, 0.0, ivec2(x, y))
#define ROW(y) vec4[](SAMPLE(0, y), SAMPLE(1, y), SAMPLE(2, y), SAMPLE(3, y), SAMPLE(4, y))

void main() {
    vec2 corner = (4.0 * floor(gl_FragCoord.xy) + 0.5) / vec2(textureSize(planes, 0));
    marksAbove(0, ROW(0));
    marks[0] = marksAbove(1, ROW(1));
    marks[1] = marksAbove(2, ROW(2));
    marks[2] = marksAbove(3, ROW(3));
    marks[3] = marksAbove(4, ROW(4));
}
