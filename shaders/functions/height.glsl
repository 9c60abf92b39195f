// Level curves: steps from the scene's lowest point up. option[0]: the axis, 3: up; option[1]: the step, scene units;
// option[2]: without a step, the number of steps in the scene's extent.
vec4 surface(Surface s) {
    int axis = int(option[0]);
    bool upwards = axis == 3;
    float above = upwards ? dot(s.world, up) - heights.x : s.world[axis % 3] - lowest[axis % 3];
    float whole = upwards ? heights.y : extent[axis % 3];
    float size = option[1] > 0.0 ? option[1] : whole / option[2];
    return vec4(size > 0.0 ? stepsIn(above / size) : 0.0, 0.0, 0.0, 0.0);
}
