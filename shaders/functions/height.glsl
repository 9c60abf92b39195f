// Level curves: steps from the scene's lowest point up. option[0]: the axis; option[1]: the step, scene units;
// option[2]: without a step, the number of steps in the scene's extent.
vec4 surface(Surface s) {
    int axis = int(option[0]);
    float size = option[1] > 0.0 ? option[1] : extent[axis] / option[2];
    return vec4(size > 0.0 ? stepsIn((s.world[axis] - lowest[axis]) / size) : 0.0, 0.0, 0.0, 0.0);
}
