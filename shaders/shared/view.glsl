// Brings a vertex from the clip space of the whole picture to that of the part of it which the viewport shows, so that
// every tile of a picture draws it at the same place. Rasterisers round to a grid of 1/256 pixel; floats say where a
// vertex lies only to within a rounding that differs from tile to tile. A vertex that lies as near as that to the
// middle between two places of the grid is moved away from there: then all tiles round it to the same one.
layout(location = 4) uniform vec2 halfPicture;  // steps of the grid
layout(location = 5) uniform vec2 viewCentre;   // from the picture's, steps
layout(location = 6) uniform vec2 halfView;     // steps

const float ROUNDING = 1.0 / 4194304.0;  // of a division, a product and a sum, and of moving

vec4 inView(vec4 clip) {
    vec2 shown = clip.xy * (halfPicture / halfView) - (viewCentre / halfView) * clip.w;
    vec2 steps = clip.xy / clip.w * halfPicture;
    vec2 fromMiddle = fract(steps) - 0.5;
    vec2 least = min((abs(steps) + halfPicture) * ROUNDING, 0.5);
    vec2 moved = floor(steps) + 0.5 + mix(least, -least, lessThan(fromMiddle, vec2(0.0)));
    vec2 placed = (moved - viewCentre) / halfView * clip.w;
    bvec2 near = lessThan(abs(fromMiddle), least);
    return vec4(clip.w > 0.0 && near.x ? placed.x : shown.x, clip.w > 0.0 && near.y ? placed.y : shown.y, clip.zw);
}
