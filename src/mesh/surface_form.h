#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include <inkedge/mesh.h>

#include "mesh/topology.h"

namespace inkedge::mesh {

/// How a surface bends at a point. Lengths are counted in the surface's feature size, so that no value has a unit.
struct PointForm {
    glm::vec3 normal{0.0F};  ///< unit, to the front
    glm::vec3 first{0.0F};   ///< unit, tangent: the direction of the first curvature
    /// The principal curvatures, the greater one first; over 0 where the surface bulges towards its front.
    std::array<float, 2> curvatures{};
    /// The derivative of the curvature tensor, which is symmetric: its components 111, 112, 122 and 222 along the
    /// principal directions. The second one is cross(normal, first).
    std::array<float, 4> derivative{};
};

/// How the surfaces of a mesh bend.
struct SurfaceForm {
    std::vector<std::uint32_t> fans;   ///< one per corner: an index into points
    std::vector<PointForm> points;     ///< one per fan: corners at one position with no crease between them
    std::vector<double> featureSizes;  ///< one per patch: that of its surface, in the mesh's unit; 0: it has no area
    /// One per patch: over what its surface is smoothed: the feature size, or the mean length of an edge if that is
    /// more.
    std::vector<double> resolutions;
};

/// The curvature tensor and its derivative, each by least squares over the edges of a face, and then averaged over the
/// faces around a point by their shares of the area: Rusinkiewicz 2004. Nothing is averaged across creases. Faces at
/// borders and creases, whose normals there are one-sided, count only where there are no others.
///
/// All is smoothed by a kernel about as wide as the feature size, or as the mean length of an edge if that is more, so
/// that what is smaller does not count.
/// @param featureSize  as a share of the radius of a sphere of the surface's area: over 0. A surface is what is
///                     connected across edges that are no creases.
/// O(n), on all cores.
[[nodiscard]] SurfaceForm surfaceForm(const Mesh&, const MeshTopology&, double featureSize);

}  // namespace inkedge::mesh
