// A smooth picture on the surface. option[0]: how often it is repeated along each coordinate's unit.
//
// The seams of a repeated texture must not become lines. Without a picture the value is a ramp, whose differences are
// taken modulo 1. A picture is mirrored at its sides, so that copies join wherever a coordinate jumps by a whole
// number.
vec4 surface(Surface s) {
    vec2 uv = fract(s.coordinates * option[0]);
    if (!hasPicture) return vec4(uv, 0.0, 0.0);
    vec2 halfTexel = 0.5 / vec2(textureSize(picture, 0));
    return vec4(textureLod(picture, mix(halfTexel, 1.0 - halfTexel, 1.0 - abs(2.0 * uv - 1.0)), 0.0).rgb, 0.0);
}
