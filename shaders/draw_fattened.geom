#version 450 core
#extension GL_GOOGLE_include_directive : require

// Silhouettes and creases by added polygons, in one pass: Raskar and Cohen 1999, Raskar 2001. CPU definition:
// reference.h, drawFattened().
//
// A triangle is drawn as paper. Where an edge of a back face is a silhouette, the face is enlarged by a strip of ink
// beyond the edge; so is any face at a border. At a crease each of the two faces has a fin of half that width along the
// edge, in its own plane.
layout(triangles) in;
layout(triangle_strip, max_vertices = 15) out;

layout(location = 0) flat in uvec2 triangles[];

// struct FaceEdges of src/scene/face_edges.h, which says what the flags are.
struct FaceEdges {
    vec4 plane;
    uvec3 beyond;
    uint flags;
};
layout(std430, binding = 1) readonly buffer Faces { FaceEdges faces[]; };
const uint NO_FACE = ~0u;
const uint CREASE = 1u;
const uint BORDER = 8u;
const uint REVERSED = 64u;
const uint MIRRORED = 512u;
const uint ONE_SIDED = 1024u;

layout(location = 1) uniform vec4 eye;       // from the centre of the bounds, radii, and 1; or towards the eye, and 0
layout(location = 2) uniform vec4 viewport;  // its corner and its size, pixels of the target
layout(location = 3) uniform float inkWidth;  // pixels of the target
layout(location = 7) uniform float lift;      // added to clip-space z: towards the eye

layout(location = 0) flat out vec4 segment;  // the edge's ends, pixels of the target
layout(location = 1) flat out float reach;   // pixels from it that are inked; 0: paper

uint flagsOf(uint face, uint k) { return faces[face].flags >> k; }

// Over 0: seen wound counter-clockwise; 0: there is no telling.
float facing(uint face) { return dot(faces[face].plane.xyz, eye.xyz) - faces[face].plane.w * eye.w; }

// y runs down.
vec2 pixelOf(vec2 ndc) { return viewport.xy + (0.5 + 0.5 * vec2(ndc.x, -ndc.y)) * viewport.zw; }
vec2 ndcOf(vec2 pixel) { return vec2(2.0, -2.0) * ((pixel - viewport.xy) / viewport.zw) + vec2(-1.0, 1.0); }

struct Corner {
    vec2 pixel;
    float depth;  // window space, reversed
};

Corner cornerOf(int k, float lifted) {
    vec4 clip = gl_in[k].gl_Position;
    return Corner(pixelOf(clip.xy / clip.w), (clip.z + lifted) / clip.w);
}

void emit(vec2 pixel, float depth, vec4 ends, float inked) {
    segment = ends;
    reach = inked;
    gl_Position = vec4(ndcOf(pixel), depth, 1.0);
    EmitVertex();
}

// A strip beside an edge, and beyond its ends, in which the fragment shader draws what is near enough to the edge.
// @param across  unit, towards the strip
// @param slope   of depth along the edge and across it, a pixel
void emitStrip(Corner a, Corner b, vec2 along, vec2 across, vec2 slope, float inked, bool mirrored) {
    vec4 ends = vec4(a.pixel, b.pixel);
    vec2 before = -inked * along;
    vec2 side = inked * across;
    float drop = inked * slope.x;
    float rise = inked * slope.y;
    // Wound so that no culling takes it for a back.
    bool leftward = along.x * across.y - along.y * across.x < 0.0;
    bool swap = leftward == mirrored;
    vec2 first = swap ? side : vec2(0.0);
    vec2 second = swap ? vec2(0.0) : side;
    float firstRise = swap ? rise : 0.0;
    float secondRise = swap ? 0.0 : rise;
    emit(a.pixel + before + first, a.depth - drop + firstRise, ends, inked);
    emit(b.pixel - before + first, b.depth + drop + firstRise, ends, inked);
    emit(a.pixel + before + second, a.depth - drop + secondRise, ends, inked);
    emit(b.pixel - before + second, b.depth + drop + secondRise, ends, inked);
    EndPrimitive();
}

// The enlargement of a face beyond an edge, as deep as the edge and a little deeper.
void enlarge(int k, float side, bool mirrored) {
    Corner a = cornerOf(k, -lift);
    Corner b = cornerOf((k + 1) % 3, -lift);
    float length = distance(a.pixel, b.pixel);
    if (length == 0.0) return;
    vec2 along = (b.pixel - a.pixel) / length;
    // The face lies to the left of its edges if it is seen counter-clockwise; y runs down.
    vec2 across = side > 0.0 ? vec2(-along.y, along.x) : vec2(along.y, -along.x);
    emitStrip(a, b, along, across, vec2(0.0), inkWidth, mirrored);
}

// A fin in the face's plane, a little nearer.
void addFin(int k, bool mirrored) {
    Corner a = cornerOf(k, lift);
    Corner b = cornerOf((k + 1) % 3, lift);
    Corner c = cornerOf((k + 2) % 3, lift);
    float length = distance(a.pixel, b.pixel);
    if (length == 0.0) return;
    vec2 along = (b.pixel - a.pixel) / length;
    float foot = dot(c.pixel - a.pixel, along);
    vec2 into = c.pixel - a.pixel - foot * along;
    float height = distance(into, vec2(0.0));
    if (height < 0.01) return;  // seen from its edge
    float reached = 0.5 * inkWidth;
    float slopeAlong = (b.depth - a.depth) / length;
    float slopeAcross = (c.depth - a.depth - foot * slopeAlong) / height;
    // Beyond the face its plane may soon be in front of everything: no depth is used that the face does not have.
    vec2 slope = vec2(slopeAlong * min(length / reached, 1.0), slopeAcross * min(height / reached, 1.0));
    emitStrip(a, b, along, into / height, slope, reached, mirrored);
}

void main() {
    // Drivers differ: gl_PrimitiveIDIn starts again with each instance, or does not.
    uint face = triangles[0].x + uint(gl_PrimitiveIDIn) % triangles[0].y;
    for (int k = 0; k < 3; ++k) {
        segment = vec4(0.0);
        reach = 0.0;
        gl_Position = gl_in[k].gl_Position;
        EmitVertex();
    }
    EndPrimitive();

    float side = facing(face);
    bool mirrored = (flagsOf(face, 0u) & MIRRORED) != 0u;
    bool hiddenBack = (flagsOf(face, 0u) & ONE_SIDED) != 0u && (side < 0.0) != mirrored;
    for (int k = 0; k < 3; ++k) {
        if (gl_in[k].gl_Position.w <= 0.0 || gl_in[(k + 1) % 3].gl_Position.w <= 0.0) continue;
        uint flags = flagsOf(face, uint(k));
        uint beyond = faces[face].beyond[k];
        float other = beyond == NO_FACE ? 0.0 : facing(beyond) * ((flags & REVERSED) != 0u ? -1.0 : 1.0);
        if (side < 0.0 && other > 0.0) {
            enlarge(k, side, mirrored);
        } else if (hiddenBack) {
            continue;
        } else if ((flags & BORDER) != 0u) {
            enlarge(k, side, mirrored);
        } else if ((flags & CREASE) != 0u && gl_in[(k + 2) % 3].gl_Position.w > 0.0 && side * other >= 0.0) {
            addFin(k, mirrored);
        }
    }
}
