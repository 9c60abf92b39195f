// Shells around the middle of the scene, option[0] apart.
vec4 surface(Surface s) { return vec4(stepsIn(length(s.world) / option[0])); }
