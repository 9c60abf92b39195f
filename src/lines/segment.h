#pragma once

#include <array>
#include <cstdint>

#include <glm/vec3.hpp>

#include "scene/scene_face.h"

namespace inkedge::lines {

inline constexpr scene::SceneFace noFace{~0U, 0};
/// The triangle of an instance's face that is none: of lines that lie on no face.
inline constexpr std::uint32_t noTriangle = ~0U;

/// What a segment is by its shape alone. Whether a contour is an outline or an occlusion is decided later.
enum class Curve : std::uint8_t {
    Contour,
    Boundary,
    Crease,
    Intersection,
    Isoparametric,
    Marked,
    Suggestive,
    Ridge,
    Valley,
    Apparent,
    Tangent,
};

/// Names a point where segments meet: segments that have an end of the same name are joined.
using Key = std::uint64_t;
inline constexpr Key noKey = ~Key{0};
/// A point of an instance's mesh (MeshTopology::points).
[[nodiscard]] constexpr Key pointKey(std::uint32_t instance, std::uint32_t point) noexcept {
    return (Key{instance} << 32U) | point;
}
/// A point on an edge. The edge is named by the smaller of its half-edges.
[[nodiscard]] constexpr Key edgeKey(std::uint32_t instance, std::uint32_t halfEdge) noexcept {
    return (Key{1} << 61U) | (Key{instance} << 32U) | halfEdge;
}

/// An edge of a RefinedContourMesh, or a joint of a contour within a triangle, numbered in an order of its own.
[[nodiscard]] constexpr Key refinedKey(std::uint32_t instance, std::uint32_t number) noexcept {
    return (Key{3} << 61U) | (Key{instance} << 32U) | number;
}
/// An end of an IntersectionSegment.
[[nodiscard]] constexpr Key intersectionKey(std::uint32_t node) noexcept { return (Key{1} << 63U) | node; }

/// An end of a piece of Mesh::lines.
[[nodiscard]] constexpr Key fileLineKey(std::uint32_t instance, std::uint32_t number) noexcept {
    return (Key{1} << 62U) | (Key{instance} << 32U) | number;
}

/// An end of an IsolineSegment.
[[nodiscard]] constexpr Key isolineKey(std::uint32_t instance, std::uint32_t node) noexcept {
    return (Key{3} << 62U) | (Key{instance} << 32U) | node;
}

/// A point on an edge, as edgeKey() names it, where a line of form meets it.
[[nodiscard]] constexpr Key formKey(std::uint32_t instance, std::uint32_t halfEdge) noexcept {
    return (Key{5} << 61U) | (Key{instance} << 32U) | halfEdge;
}

/// A straight piece of a line on the surface. Positions are world space less the centre of Scene::bounds().
struct Segment {
    Curve curve = Curve::Contour;
    bool drawn = true;     ///< false: the segment is not drawn, but may hide lines behind it
    bool marked = false;   ///< whether it is drawn as LineType::Marked where its own type is not drawn
    bool occludes = true;  ///< whether the surface ends or turns away here, so that it may hide lines behind it
    bool hidden = false;   ///< whether the surface that the segment lies on hides it: no ray is needed
    bool edgeOn = false;   ///< of edges: whether one of their faces is seen edge-on, as the line itself
    /// The faces that the segment lies on: they do not hide it. The first one's instance is the line's.
    std::array<scene::SceneFace, 2> faces{noFace, noFace};
    std::array<glm::dvec3, 2> ends{};
    std::array<Key, 2> keys{noKey, noKey};
    std::array<double, 2> strengths{1.0, 1.0};  ///< LinePoint::strength at the ends
    glm::dvec3 inner{0.0};                      ///< of contours and boundaries: a point of the surface that ends here
    /// How far behind the faces of its component the segment may lie: smooth contours are no edges of faces.
    double slack = 0.0;
    double pixelSlack = 0.0;  ///< how far behind any face it may lie, in footprints: of lines of the file
};

}  // namespace inkedge::lines
