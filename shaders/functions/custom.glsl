// Stands for a user's text, which the renderer compiles in its place: the build holds the frame around it to the
// language.
vec4 surface(Surface s) { return vec4(s.object, 0.0); }
