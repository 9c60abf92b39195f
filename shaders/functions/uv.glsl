// Isoparametric lines: texture coordinates in steps. option[0]: the step; option[1]: 0 both coordinates, 1 u, 2 v.
// Differences are taken modulo the number of steps that make 1, so that seams of a repeated texture are lines like the
// others.
vec4 surface(Surface s) {
    float u = option[1] == 2.0 ? 0.0 : stepsIn(fract(s.coordinates.x + 1e-6) / option[0]);
    float v = option[1] == 1.0 ? 0.0 : stepsIn(fract(s.coordinates.y + 1e-6) / option[0]);
    return vec4(u, v, 0.0, 0.0);
}
