// Stands for a user's text, which the renderer compiles instead. With it the build checks the text around the function.
vec4 surface(Surface s) { return vec4(s.object, 0.0); }
