// Converts eye-space depth (scene units, along the view direction) and window-space depth (0 at near, 1 at far) into
// each other. In perspective window-space depth is linear in 1/z; in an orthographic view it is linear in z.
struct Depths {
    float near;
    float far;
    bool orthographic;
};

// Window-space depth, or depth that is linear from 0 at near to 1 at far. One expression serves both without a branch:
// the view's uniforms decide, not each pixel.
float scaledDepth(float z, bool window, Depths d) {
    bool hyperbolic = window && !d.orthographic;
    precise float scaled = (z - d.near) * ((hyperbolic ? d.far : 1.0) / (d.far - d.near)) / (hyperbolic ? z : 1.0);
    return scaled;
}

// Eye-space depth from reversed window-space depth (1 at near, 0 at far), which keeps the digits that 1 - depth loses.
float eyeDepthFromReversed(float w, Depths d) {
    return d.orthographic ? mix(d.far, d.near, w) : d.near / mix(d.near / d.far, 1.0, w);
}
