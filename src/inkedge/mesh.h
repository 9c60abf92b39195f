#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <inkedge/edge_kinds.h>
#include <inkedge/face_surfaces.h>

namespace inkedge {

/// Which texel of a picture texture coordinates outside 0..1 stand for.
enum class TextureWrap { Clamp, Mirror, Repeat };

/// What a vertex says of the colour of its surface.
struct VertexPaint {
    glm::vec4 color{1.0F};  ///< linear: a factor of the material's
    glm::vec2 uv{0.0F};     ///< in the material's picture: (0, 0) its top left corner, (1, 1) its bottom right one
};

/// Triangles and lines in a coordinate system of their own: mesh space.
struct Mesh {
    std::string name;
    glm::dvec3 origin{0.0};  ///< added to every position, so that floats stay exact however far off the mesh lies
    std::vector<glm::vec3> positions;      ///< mesh space, less origin
    std::vector<glm::vec3> normals;        ///< unit length, one per position; empty: the scene makes them
    std::vector<std::uint32_t> indices;    ///< three per triangle, into positions
    std::vector<std::uint32_t> materials;  ///< one per triangle: 1 + its number in the file, 0: none; empty: all 0
    /// One per index: the kinds of the edge from this corner to the next corner of its triangle. A kind that one
    /// triangle of an edge has goes for the whole edge, except EdgeKind::Inner. Empty: no edge has a kind.
    std::vector<EdgeKinds> edges;
    /// One per triangle: the face of the file that the triangle is a part of, in any numbering. Empty: the file has no
    /// faces.
    std::vector<std::uint32_t> faces;
    /// One per position, v = 0 at the top of the picture as in glTF. Empty: the file has none, or
    /// LoadSettings::textureCoordinates does not ask for them. Parts of the mesh without any have (0, 0).
    std::vector<glm::vec2> textureCoordinates;
    /// One per position. Empty: all have the default, or LoadSettings::paint does not ask for it.
    std::vector<VertexPaint> paint;
    /// Mean curvature, one per position, in 1 / unit of mesh space; over 0 where the surface bulges towards its front.
    /// The scene makes it if LoadSettings::curvature asks for it; else empty.
    std::vector<float> curvatures;
    /// Lines that the file has besides triangles, as straight pieces of two positions each: mesh space, less origin.
    /// Pieces that end at one position go on into each other. They are drawn as LineType::Marked.
    std::vector<glm::vec3> lines;
    /// The smooth surfaces that the triangles stand for. Normals are then taken as they are. None: there is nothing but
    /// triangles.
    std::shared_ptr<const FaceSurfaces> surfaces;
    /// One per position, of a CAD file's faces: u and v on the surface of its face. One that is NaN says nothing: at a
    /// pole all values of it are one point. Else empty.
    std::vector<glm::dvec2> parameters;
    /// One per triangle, of a subdivided mesh: its number among those that its control mesh was divided into. Else
    /// empty.
    std::vector<std::uint32_t> limitTriangles;
};

}  // namespace inkedge
