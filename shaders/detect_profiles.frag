#version 450 core
#extension GL_GOOGLE_include_directive : require

// Profiles and internal edges of the depth map after Saito and Takahashi 1990 (reference 18 of Hertzmann 1999). CPU
// definition: reference.h, detectProfiles(). In a 3 x 3 neighbourhood
//
//   A B C    g = (|A + 2 B + C - F - 2 G - H| + |C + 2 E + H - A - 2 D - F|) / 8
//   D X E    l = (8 X - A - B - C - D - E - F - G - H) / 3
//   F G H
//
// a profile is where g varies: (g_max - g_min) / k_p over the neighbours; an internal edge is |l| / k_l; both squared.
layout(binding = 0) uniform sampler2D surfaces;  // rgb: normal, a: eye-space depth; background: normal 0

layout(location = 0) uniform float focalLength;  // pixels (orthographic: pixels per scene unit)
layout(location = 1) uniform bool orthographic;
layout(location = 2) uniform float profileLimit;  // k_p, pixel footprints
layout(location = 3) uniform float edgeLimit;     // k_l, pixel footprints per pixel

layout(location = 0) out float ink;  // 0 none, 1 full

const float FAR = 1e3;  // the background's depth, in footprints
const int SIDE = 5;

// Depths less that of the middle pixel, in footprints of that pixel. In perspective they are taken of 1 / z, which is
// linear in the picture, so that planes stay planes.
float depths[SIDE * SIDE];

float at(int x, int y) { return depths[y * SIDE + x]; }

float gradient(int x, int y) {
    float down = at(x - 1, y - 1) + 2.0 * at(x, y - 1) + at(x + 1, y - 1)
               - at(x - 1, y + 1) - 2.0 * at(x, y + 1) - at(x + 1, y + 1);
    float right = at(x + 1, y - 1) + 2.0 * at(x + 1, y) + at(x + 1, y + 1)
                - at(x - 1, y - 1) - 2.0 * at(x - 1, y) - at(x - 1, y + 1);
    return (abs(down) + abs(right)) / 8.0;
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float centre = texelFetch(surfaces, pixel, 0).a;
    bool nothing = true;
    for (int y = 0; y < SIDE; ++y) {
        for (int x = 0; x < SIDE; ++x) {
            vec4 s = texelFetch(surfaces, clamp(pixel + ivec2(x, y) - 2, ivec2(0), textureSize(surfaces, 0) - 1), 0);
            bool background = s.rgb == vec3(0.0);
            float depth = focalLength * (orthographic ? s.a - centre : 1.0 - centre / s.a);
            depths[y * SIDE + x] = background ? FAR : clamp(depth, -FAR, FAR);
            if (x == 2 && y == 2) nothing = background;
        }
    }
    ink = 0.0;
    if (nothing) return;  // lines lie on the nearer side
    float smallest = gradient(2, 2);
    float largest = smallest;
    float around = 0.0;
    for (int y = 1; y <= 3; ++y) {
        for (int x = 1; x <= 3; ++x) {
            float g = gradient(x, y);
            smallest = min(smallest, g);
            largest = max(largest, g);
            around += at(x, y);
        }
    }
    float profile = min((largest - smallest) / profileLimit, 1.0);
    float edge = min(abs(9.0 * at(2, 2) - around) / 3.0 / edgeLimit, 1.0);
    ink = max(profile, edge) * max(profile, edge);
}
