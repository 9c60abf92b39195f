// A solid texture: a function of the position in the object. option[0]: 0 a smooth gradient, 1 wood-like rings about an
// axis, 2 stripes across it; option[1]: the axis; option[2]: the number of rings or stripes in the scene's radius;
// option[3]: how far they are bent.
float wave(vec3 p) {
    return sin(3.1 * p.x + 1.7 * p.z) * sin(2.3 * p.y + 0.9 * p.x) + 0.5 * sin(4.7 * p.z - 1.3 * p.y);
}

vec4 surface(Surface s) {
    if (option[0] == 0.0) return vec4(option[2] * s.object, 0.0);
    int axis = int(option[1]);
    float along = s.object[axis];
    vec3 across = s.object;
    across[axis] = 0.0;
    float rings = option[2] * (option[0] == 1.0 ? length(across) : along) + option[3] * wave(2.0 * s.object);
    return vec4(stepsIn(rings), 0.0, 0.0, 0.0);
}
