#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec4.hpp>

#include <inkedge/scene.h>

namespace inkedge::scene {

/// Stands for no triangle beyond an edge.
inline constexpr std::uint32_t noFace = ~0U;

/// What lies beyond the edge of a triangle from its corner k to the next one.
enum class EdgeFlag : std::uint32_t {
    Crease = 1,     ///< the two faces meet in a crease, or more than two meet
    Border = 8,     ///< no face goes on there
    Reversed = 64,  ///< the face beyond is wound the other way
    // Of the whole triangle:
    Mirrored = 512,  ///< its winding is the other way round in the world
    OneSided = 1024  ///< its back is not seen
};

/// One triangle of a scene and what its edges meet, as draw_fattened.geom reads it. Flags of edge k are shifted left
/// by k.
struct FaceEdges {
    /// A point x, world space less the centre of the bounds, in radii of the scene, is on the side from which the
    /// winding is counter-clockwise if dot(xyz, x) > w. 0: the triangle is too thin.
    glm::vec4 plane{0.0F};
    std::array<std::uint32_t, 3> beyond{noFace, noFace, noFace};  ///< into the triangles of the scene
    std::uint32_t flags = 0;

    [[nodiscard]] bool has(EdgeFlag flag, std::uint32_t k = 0) const noexcept {
        return (flags & (static_cast<std::uint32_t>(flag) << k)) != 0;
    }
};
static_assert(sizeof(FaceEdges) == 32);

/// One for each triangle of the scene, those of instance 0 first. Edges that run along each other where two borders
/// meet without a common vertex lie beyond each other. O(n), and of borders as joinAcrossSeams().
[[nodiscard]] std::vector<FaceEdges> faceEdgesOf(const Scene&);

}  // namespace inkedge::scene
