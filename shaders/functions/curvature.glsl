// Mean curvature, between -1 and 1. option[0]: a factor, over which the steep part of the scale is moved.
vec4 surface(Surface s) {
    float scaled = option[0] * s.curvature;
    return vec4(scaled / (1.0 + abs(scaled)), 0.0, 0.0, 0.0);
}
