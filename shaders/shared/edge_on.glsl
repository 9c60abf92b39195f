// A triangle that is seen edge-on covers a pixel's centre by rounding alone, and what is interpolated over it may be
// any number, or none. Where its depth lies outside the camera's range, or changes by many diameters of the scene from
// pixel to pixel, so that a vertex's place on the grid decides, the values of one of its corners stand for it.
// @param depth  interpolated, unit lengths: half the scene's diameter
layout(location = 0) uniform mat4 projection;  // as in draw_surface.vert

bool seenEdgeOn(float depth) {
    const float MAX_CHANGE = 32.0;
    const float ROUNDING = 1e-5;
    float z = projection[3].z - projection[2].z * depth;  // 0 far to w near
    float w = projection[3].w - projection[2].w * depth;
    bool inRange = z >= -ROUNDING * w && z <= (1.0 + ROUNDING) * w;
    return !(inRange && fwidth(depth) < MAX_CHANGE);
}
