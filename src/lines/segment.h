#pragma once

#include <array>
#include <cstdint>

#include <glm/vec3.hpp>

#include "scene/scene_face.h"

namespace inkedge::lines {

inline constexpr SceneFace noFace{~0U, 0};

/// What a segment is by its shape alone; whether a contour is an outline or hides another surface is seen later.
enum class Curve : std::uint8_t { Contour, Boundary, Crease, Intersection, Isoparametric, Marked };

/// Names a place where segments meet: segments that have an end of the same name go on into each other.
using Key = std::uint64_t;
inline constexpr Key noKey = ~Key{0};
/// A point of an instance's mesh (MeshTopology::points).
[[nodiscard]] constexpr Key pointKey(std::uint32_t instance, std::uint32_t point) noexcept {
    return (Key{instance} << 32U) | point;
}
/// A place on an edge, by the lesser of its half-edges.
[[nodiscard]] constexpr Key edgeKey(std::uint32_t instance, std::uint32_t halfEdge) noexcept {
    return (Key{1} << 61U) | (Key{instance} << 32U) | halfEdge;
}

/// An edge of a RefinedContourMesh, numbered in an order of its own.
[[nodiscard]] constexpr Key refinedKey(std::uint32_t instance, std::uint32_t number) noexcept {
    return (Key{3} << 61U) | (Key{instance} << 32U) | number;
}
/// An end of an IntersectionSegment.
[[nodiscard]] constexpr Key intersectionKey(std::uint32_t node) noexcept { return (Key{1} << 63U) | node; }

/// An end of an IsolineSegment.
[[nodiscard]] constexpr Key isolineKey(std::uint32_t instance, std::uint32_t node) noexcept {
    return (Key{3} << 62U) | (Key{instance} << 32U) | node;
}

/// A straight piece of a line on the surface. Positions are world space less the centre of Scene::bounds().
struct Segment {
    Curve curve = Curve::Contour;
    bool drawn = true;     ///< else it only hides what lies behind
    bool marked = false;   ///< whether it is drawn as LineType::Marked where it has another type that is not drawn
    bool occludes = true;  ///< whether the surface ends or turns away here, so that it may hide what lies behind
    bool hidden = false;   ///< by the part of its mesh that it lies on: no ray need be asked
    std::array<SceneFace, 2> faces{noFace, noFace};  ///< that it lies on: they do not hide it
    std::array<glm::dvec3, 2> ends{};
    std::array<Key, 2> keys{noKey, noKey};
    glm::dvec3 inner{0.0};  ///< of contours and boundaries: a point of the surface that ends here
    double slack = 0.0;     ///< how far behind the faces the line may lie: smooth contours are no edges of theirs
};

}  // namespace inkedge::lines
