// Section 2.1.1: 0 at near, 1 at far. option[0]: 1 is window-space depth.
vec4 surface(Surface s) { return vec4(scaledDepth(s.depth, option[0] == 1.0, depths), 0.0, 0.0, 0.0); }
