#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <inkedge/edge_kinds.h>

namespace inkedge {

/// How texture coordinates outside 0..1 find their place in a picture.
enum class TextureWrap { Clamp, Mirror, Repeat };

/// What a vertex says of its surface's colour.
struct VertexPaint {
    glm::vec4 color{1.0F};  ///< linear: a factor of the material's
    glm::vec2 place{0.0F};  ///< in the material's picture: (0, 0) its top left corner, (1, 1) its bottom right one
};

/// Triangles in a space of their own.
struct Mesh {
    std::string name;
    glm::dvec3 origin{0.0};  ///< added to every position: keeps floats near zero, however far off the mesh lies
    std::vector<glm::vec3> positions;      ///< mesh space, less origin
    std::vector<glm::vec3> normals;        ///< unit length, one for each position; empty: made by completeNormals()
    std::vector<std::uint32_t> indices;    ///< three a triangle, into positions
    std::vector<std::uint32_t> materials;  ///< one a triangle: 1 + its number in the file, 0: none; empty: all 0
    /// One an index: of what kinds the edge from this corner to its triangle's next is. What is said of an edge in one
    /// of its triangles goes for the edge, but for EdgeKind::Inner. Empty: nothing is known of any.
    std::vector<EdgeKinds> edges;
    /// One a triangle: the face of the file that it is a part of, in any numbering. Empty: each patch is by itself.
    std::vector<std::uint32_t> faces;
    /// One a position, v = 0 at the top of the picture as in glTF; empty: none, or not asked for
    /// (LoadSettings::textureCoordinates). Of a mesh of several parts those without have (0, 0).
    std::vector<glm::vec2> textureCoordinates;
    std::vector<VertexPaint>
        paint;  ///< one a position; empty: all as by default, or not asked for (LoadSettings::paint)
    /// Mean curvature, one a position, one over mesh space's unit, over 0 where the surface bulges; made by the scene
    /// if LoadSettings::curvature asks for it, else empty.
    std::vector<float> curvatures;
};

}  // namespace inkedge
