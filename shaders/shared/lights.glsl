// The normal map by lights of Hertzmann 1999, section 2.1.2: a white diffuse object, a red, a green and a blue light on
// the axes, and lights of negative intensity opposite to them.
const vec3 RED = vec3(1.0, 0.0, 0.0);
const vec3 GREEN = vec3(0.0, 1.0, 0.0);
const vec3 BLUE = vec3(0.0, 0.0, 1.0);

vec3 diffuse(vec3 normal, vec3 towardsLight, vec3 color) { return color * max(dot(normal, towardsLight), 0.0); }

vec3 positiveLights(vec3 n) {
    return diffuse(n, vec3(1, 0, 0), RED) + diffuse(n, vec3(0, 1, 0), GREEN) + diffuse(n, vec3(0, 0, 1), BLUE);
}

// How much light the negative lights take away: their light without its sign.
vec3 negativeLights(vec3 n) {
    return diffuse(n, vec3(-1, 0, 0), RED) + diffuse(n, vec3(0, -1, 0), GREEN) + diffuse(n, vec3(0, 0, -1), BLUE);
}

// The normal to light. Lighting is two-sided: the visible side is lit.
vec3 seenSide(vec3 surfaceNormal) { return normalize(gl_FrontFacing ? surfaceNormal : -surfaceNormal); }
