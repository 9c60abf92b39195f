// Between eye-space depth (scene units, along the view direction) and window-space depth (0 at near, 1 at far).
// In perspective window depth is linear in 1/z; in an orthographic view it is linear in z.
struct Depths {
    float near;
    float far;
    bool orthographic;
};

float windowDepthFromEye(float z, Depths d) {
    float linear = (z - d.near) / (d.far - d.near);
    return d.orthographic ? linear : linear * d.far / z;
}

// From reversed window-space depth, 1 at near and 0 at far, which keeps the digits that 1 - depth would lose.
float eyeDepthFromReversed(float w, Depths d) {
    return d.orthographic ? mix(d.far, d.near, w) : d.near / mix(d.near / d.far, 1.0, w);
}
