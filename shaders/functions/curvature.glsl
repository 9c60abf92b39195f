// Mean curvature in steps: lines of equal curvature. option[0]: a factor; half of the scale is at a curvature times
// factor of 1. option[1]: the number of steps from flat to the sharpest, on either side. Flat is in the middle of a
// step.
vec4 surface(Surface s) {
    float scaled = option[0] * s.curvature;
    return vec4(stepsIn(option[1] * scaled / (1.0 + abs(scaled)) + 0.5), 0.0, 0.0, 0.0);
}
