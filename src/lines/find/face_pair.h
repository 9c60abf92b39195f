#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec3.hpp>

#include "lines/find/face_cones.h"
#include "lines/find/face_tree.h"
#include "lines/find/file_faces.h"
#include "lines/find/intersections.h"
#include "mesh/topology.h"

namespace inkedge::lines {

/// Radians: faces that meet at less do not cross; and its cosine.
inline constexpr double minCrossingAngle = glm::radians(minIntersectionAngle);
inline const double maxCrossingCosine = std::cos(minCrossingAngle);
/// The distance of the ends of two unit normals at that angle.
inline const float minCrossingDistance = static_cast<float>(2.0 * std::sin(0.5 * minCrossingAngle));

/// A mesh as one of the two sides that may cross.
struct FaceSide {
    const FaceTree* tree;
    const FaceCones* cones;
    const FileFaces* fileFaces;
    std::span<const glm::dvec3> normals;  ///< as MeshTopology::faceNormals
    const mesh::MeshTopology* topology;
    glm::dmat4 transform;  ///< into the space in which the two are compared
};

/// A face of a side, in the space in which sides are compared.
struct SideFace {
    std::uint32_t triangle;
    std::array<std::uint32_t, 3> points;
    std::array<glm::dvec3, 3> corners;
    glm::dvec3 normal;  ///< unit
};
[[nodiscard]] SideFace faceOf(const FaceSide&, std::uint32_t triangle);

/// Where a face of one side crosses one of the other.
struct FaceCrossing {
    std::uint32_t a;  ///< triangles
    std::uint32_t b;
    std::array<glm::dvec3, 2> ends;
};

/// Finds where two faces cross. The cases of touching are in the docstring of findIntersections().
class FacePair {
public:
    /// @param a, b       must outlive this; the same object for a mesh against itself
    /// @param tolerance  smaller distances count as 0
    FacePair(const FaceSide& a, const FaceSide& b, double tolerance)
        : a_{a}, b_{b}, tolerance_{tolerance}, sameMesh_{&a == &b} {}

    [[nodiscard]] std::optional<FaceCrossing> cross(const SideFace& a, const SideFace& b) const {
        if (!mayCross(a, b)) return {};
        const Distances distancesOfA = distances(a, b);
        if (allOnOneSide(distancesOfA)) return {};
        const Distances distancesOfB = distances(b, a);
        if (allOnOneSide(distancesOfB)) return {};
        return crossPlanes(a, distancesOfA, b, distancesOfB);
    }

private:
    using Distances = std::array<double, 3>;
    struct Around;

    [[nodiscard]] bool mayCross(const SideFace& a, const SideFace& b) const {
        if (sameMesh_) {
            for (const std::uint32_t p : a.points)
                if (p == b.points[0] || p == b.points[1] || p == b.points[2]) return false;
        }
        return std::abs(glm::dot(a.normal, b.normal)) < maxCrossingCosine;
    }

    // The distances of a face's corners from the plane of another face; exactly 0 within the tolerance.
    [[nodiscard]] Distances distances(const SideFace& of, const SideFace& plane) const {
        Distances distances{};
        for (std::size_t k = 0; k < 3; ++k) {
            const double d = glm::dot(plane.normal, of.corners[k] - plane.corners[0]);
            distances[k] = std::abs(d) <= tolerance_ ? 0.0 : d;
        }
        return distances;
    }

    // Whether a face does not cross the plane. A face with one corner in the plane and the others to one side only
    // touches it; a face with three corners in the plane lies in it.
    static bool allOnOneSide(const Distances& distances) {
        const auto above = std::ranges::count_if(distances, [](double d) { return d > 0.0; });
        const auto below = std::ranges::count_if(distances, [](double d) { return d < 0.0; });
        return above + below == 0 || (above + below > 1 && (above == 0 || below == 0));
    }

    [[nodiscard]] std::optional<FaceCrossing> crossPlanes(const SideFace& a, const Distances& distancesOfA,
                                                          const SideFace& b, const Distances& distancesOfB) const;
    [[nodiscard]] bool crossesAtEdge(const SideFace& a, int edgeOfA, const SideFace& b, int edgeOfB,
                                     glm::dvec3 along) const;
    [[nodiscard]] static std::optional<Around> around(const FaceSide&, const SideFace&, int edge, glm::dvec3 along,
                                                      glm::dvec3 zero);
    [[nodiscard]] bool isFirst(const Around& a, const Around& b) const;

    const FaceSide& a_;
    const FaceSide& b_;
    double tolerance_;
    bool sameMesh_;
};

}  // namespace inkedge::lines
