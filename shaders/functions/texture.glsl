// A smooth picture laid on the surface. option[0]: how often it is repeated along each coordinate's unit.
//
// Where a texture is repeated its seams must not become lines. The ramp's differences are taken modulo 1; a file's
// picture is laid mirrored beside itself, so that copies join wherever a coordinate jumps by a whole number.
vec4 surface(Surface s) {
    vec2 place = fract(s.coordinates * option[0]);
    if (!hasPicture) return vec4(place, 0.0, 0.0);
    vec2 halfTexel = 0.5 / vec2(textureSize(picture, 0));
    return vec4(textureLod(picture, mix(halfTexel, 1.0 - halfTexel, 1.0 - abs(2.0 * place - 1.0)), 0.0).rgb, 0.0);
}
