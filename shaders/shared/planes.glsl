// Reads the planes that draw_planes.frag writes.
layout(location = 0) uniform vec2 focalLengths;  // along x and y: pixels (orthographic: pixels per unit length)
layout(location = 1) uniform bool orthographic;
layout(location = 2) uniform vec2 centre;        // where the view axis meets the picture, pixels from the tile's corner

// The face normal up to a positive factor, turned to the eye. x and y are along the axes of the picture, with the
// opposite sign.
vec3 normalOf(vec4 plane, vec2 fromCentre) {
    return orthographic ? vec3(plane.yz * focalLengths, 1.0)
                        : vec3(plane.yz * focalLengths, plane.x - dot(plane.yz, fromCentre));
}

// Whether the surface jumps from p to q by more than the limit, in footprints. The slopes of w along the step are gp
// and gq, the focal length along it is focal.
bool jumps(float wp, float wq, float gp, float gq, float focal, float limit) {
    float rp = wq - (wp + gp);
    float rq = wp - (wq - gq);
    if (rp * rq >= 0.0) return false;  // the planes meet between p and q
    float footprints = orthographic ? focal : focal / max(wp, wq);
    return min(abs(rp), abs(rq)) * footprints > limit * (1.0 + min(abs(gp), abs(gq)) * footprints);
}
