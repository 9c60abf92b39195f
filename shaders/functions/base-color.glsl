// The colour of the surface, sRGB: the material's colour and picture times the vertex colour.
#include "shared/paint.glsl"

vec4 surface(Surface s) { return vec4(toSrgb(paintOf(s.triangle, s.paint).rgb * s.color.rgb), 0.0); }
