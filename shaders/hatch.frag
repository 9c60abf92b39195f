#version 450 core
#extension GL_GOOGLE_include_directive : require

// Hatch marks: edges of the faceted normal map, after Hertzmann 1999, Figure 2(b). CPU definition: reference.h,
// hatch().
//
// Between two facets the picture shows a straight mark where their planes meet. Its tone depends on the angle between
// the facets, and on how much light falls on them.
layout(binding = 0) uniform sampler2D planes;  // as draw_planes.frag writes them

layout(location = 3) uniform float bend;       // radians
layout(location = 4) uniform float shade;      // 0 to 1
layout(location = 5) uniform float markWidth;  // pixels

layout(location = 0) out float ink;  // 0 none, 1 full

const vec3 LIGHT = normalize(vec3(-0.45, 0.6, 0.66));  // the camera's axes

#include "shared/planes.glsl"

float brightness(vec3 n) {
    // normalOf() counts along the axes of the picture, where x and y have the opposite sign.
    return max(dot(vec3(-n.x, n.y, n.z), LIGHT) / length(n), 0.0);
}

float bendOf(vec3 np, vec3 nq) { return atan(length(cross(np, nq)), dot(np, nq)); }

vec4 planeAt(ivec2 pixel) { return texelFetch(planes, clamp(pixel, ivec2(0), textureSize(planes, 0) - 1), 0); }

vec3 normalAt(ivec2 pixel) { return normalOf(planeAt(pixel), vec2(pixel) + 0.5 - centre); }

// Whether the two pixels beside a pair see the pair's two facets and no third one. Facets that meet only in a point
// have other facets beside them.
bool goesOn(ivec2 a, ivec2 b, vec3 na, vec3 nb, float bendOfPair) {
    vec3 n = normalAt(a);
    vec3 m = normalAt(b);
    float tolerance = 0.2 * bendOfPair;
    return min(bendOf(n, na), bendOf(n, nb)) < tolerance && min(bendOf(m, na), bendOf(m, nb)) < tolerance;
}

// How much the mark between the facets of two neighbours covers of a pixel.
float mark(ivec2 pixel, ivec2 atA, vec4 a, vec3 na, ivec2 step, vec4 b, vec3 nb) {
    float found = bendOf(na, nb);
    float light = 0.5 * (brightness(na) + brightness(nb));
    float dark = bend * max(mix(1.0, 3.0 * light * sqrt(light), shade), 0.1);
    float tone = smoothstep(0.7 * dark, 1.3 * dark, found);
    // The planes meet where their difference is 0, which is linear in the picture.
    vec2 slope = a.yz - b.yz;
    float difference = a.x - (b.x - dot(b.yz, vec2(step))) + dot(slope, vec2(pixel - atA));
    float away = abs(difference) / max(length(slope), 1e-30);
    float covered = tone * clamp(min(0.5 + 0.5 * markWidth - away, markWidth), 0.0, 1.0);
    if (covered == 0.0) return 0.0;
    ivec2 beside = step.yx;
    bool line = goesOn(atA + beside, atA + step + beside, na, nb, found) ||
                goesOn(atA - beside, atA + step - beside, na, nb, found);
    return line ? covered : 0.0;
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 p = planeAt(pixel);
    ink = 0.0;
    if (p.w == 0.0) return;
    vec2 fromCentre = vec2(pixel) + 0.5 - centre;
    vec3 np = normalOf(p, fromCentre);
    for (int side = 0; side < 4; ++side) {
        int sign = side < 2 ? 1 : -1;
        ivec2 step = (side & 1) == 0 ? ivec2(sign, 0) : ivec2(0, sign);
        vec4 q = planeAt(pixel + step);
        vec3 nq = normalOf(q, fromCentre + vec2(step));
        int axis = 1 + (side & 1);
        float focal = focalLengths[side & 1];
        if (q.w == 0.0 || jumps(p.x, q.x, float(sign) * p[axis], float(sign) * q[axis], focal, 1.0)) continue;
        ink = max(ink, mark(pixel, pixel, p, np, step, q, nq));
        // The next pair, if p's facet goes on to q.
        vec4 r = planeAt(pixel + 2 * step);
        vec3 nr = normalOf(r, fromCentre + 2.0 * vec2(step));
        if (r.w == 0.0 || jumps(q.x, r.x, float(sign) * q[axis], float(sign) * r[axis], focal, 1.0)) continue;
        if (bendOf(np, nq) < 0.5 * bendOf(nq, nr)) ink = max(ink, mark(pixel, pixel + step, q, nq, step, r, nr));
    }
}
