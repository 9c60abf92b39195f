// What a surface function knows of the point that a pixel sees: Hertzmann 1999, section 2.1.3. Lengths are in scene
// units unless another unit is given.
struct Surface {
    vec3 world;         // position in world space, less the centre of the scene's bounds
    vec3 object;        // position along the object's own axes, from the middle of its mesh; in radii of the scene
    vec3 normal;        // unit; the camera's axes, turned to the side that is seen
    vec3 worldNormal;   // the same along the world's axes
    vec3 fromEye;       // unit; the camera's axes
    float depth;        // along the view direction
    vec2 coordinates;   // texture coordinates; (0, 0) where there are none
    vec4 color;         // vertex colour; white where there is none
    vec2 paint;         // coordinates of the material's picture
    float curvature;    // mean curvature times the scene's radius; over 0 where the surface bulges
    uint triangle;      // number of the triangle in the scene, from 0
};

layout(location = 8) uniform mat3 viewToWorld;
layout(location = 9) uniform vec3 eye;        // from the centre of the scene's bounds
layout(location = 10) uniform vec3 lowest;    // corner of the scene's box, from the centre of the scene's bounds
layout(location = 11) uniform vec3 extent;    // of the scene's box
layout(location = 12) uniform float unitLength;
layout(location = 13) uniform Depths depths;
layout(location = 16) uniform bool hasPicture;  // FunctionSettings::file
layout(location = 17) uniform float option[8];  // in the order of the function's row in functionTable()
layout(location = 25) uniform vec3 up;          // of the model, world space, unit length
layout(location = 26) uniform vec2 heights;     // along it: the lowest point, from the centre of the scene's bounds,
                                                // and how far up from there the highest is
layout(binding = 0) uniform sampler2D picture;

// The number of whole steps. A face that lies on a level belongs to one side of it, however its positions are rounded.
float stepsIn(float steps) { return floor(steps + 1e-3); }
