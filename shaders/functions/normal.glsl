// Section 2.1.2. option[0]: 0: along the camera's axes; 1: along the world's axes.
vec4 surface(Surface s) { return vec4(option[0] == 1.0 ? s.worldNormal : s.normal, 0.0); }
