// Reflections: a smooth environment map, looked up by the reflection of the view direction. option[0]: 0: the map turns
// with the camera; 1: the map stands in the world.
const float PI = 3.14159265358979;

vec4 surface(Surface s) {
    vec3 reflected = reflect(s.fromEye, s.normal);
    if (option[0] == 1.0) reflected = viewToWorld * reflected;
    if (!hasPicture) return vec4(0.5 + 0.5 * reflected, 0.0);
    // A panorama of all directions: its middle lies ahead, along -Z, and its ends meet behind.
    float around = 0.5 + atan(reflected.x, -reflected.z) / (2.0 * PI);
    float down = acos(clamp(reflected.y, -1.0, 1.0)) / PI;
    return vec4(textureLod(picture, vec2(around, down), 0.0).rgb, 0.0);
}
