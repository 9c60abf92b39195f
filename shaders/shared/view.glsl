// Transforms a vertex from the clip space of the whole picture to that of the part which the viewport shows, so that
// every tile of a picture draws the vertex at the same pixel position. Rasterisers round positions to a grid of 1/256
// pixel, and the rounding of floats differs from tile to tile. A vertex near the middle between two grid points, within
// that rounding, is moved away from the middle: then all tiles round it to the same grid point.
layout(location = 4) uniform vec2 halfPicture;  // steps of the grid
layout(location = 5) uniform vec2 viewCentre;   // of the viewport, from the picture's centre; steps
layout(location = 6) uniform vec2 halfView;     // steps

const float ROUNDING = 1.0 / 4194304.0;  // of a division, a product and a sum, and of moving

vec4 inView(vec4 clip) {
    vec2 shown = clip.xy * (halfPicture / halfView) - (viewCentre / halfView) * clip.w;
    vec2 steps = clip.xy / clip.w * halfPicture;
    vec2 fromMiddle = fract(steps) - 0.5;
    vec2 margin = min((abs(steps) + halfPicture) * ROUNDING, 0.5);
    vec2 moved = floor(steps) + 0.5 + mix(margin, -margin, lessThan(fromMiddle, vec2(0.0)));
    vec2 shifted = (moved - viewCentre) / halfView * clip.w;
    bvec2 near = lessThan(abs(fromMiddle), margin);
    return vec4(clip.w > 0.0 && near.x ? shifted.x : shown.x, clip.w > 0.0 && near.y ? shifted.y : shown.y, clip.zw);
}
