#pragma once

#include <cstdint>
#include <optional>

#include <glm/vec3.hpp>

#include <inkedge/settings.h>

#include "scene/instanced_meshes.h"

namespace inkedge::scene {

/// Of the scene's radius: within it borders run along each other. A fortieth of a pixel of a model framed at 1024
/// pixels.
inline constexpr double seamTolerance = 5e-5;

/// A border edge of an instance's mesh, in world space less the centre of InstancedMeshes::bounds.
struct BorderEdge {
    std::uint32_t instance;
    std::uint32_t halfEdge;
    glm::dvec3 a;
    glm::dvec3 b;
    glm::dvec3 into;  ///< unit, in the face's plane, across the edge into the face
};

/// The stretch along which two segments run along each other: as shares of each one's length from its a, from <= to.
struct SharedLength {
    double from[2];
    double to[2];
};

/// None of an edge without length, or of a face without area.
[[nodiscard]] std::optional<BorderEdge> borderEdgeOf(const InstancedMeshes&, std::uint32_t instance,
                                                     std::uint32_t halfEdge);

/// The shared stretch of two segments; none if they are further apart than the tolerance, or share no more than that.
[[nodiscard]] std::optional<SharedLength> runAlong(const BorderEdge&, const BorderEdge&, double tolerance);

/// Decides where the faces on both sides of a seam meet in a crease: where they bend by more than the crease angle, or
/// by more than mesh::sharedCreaseAngle() if the normals at the seam agree.
class SeamCreases {
public:
    SeamCreases(const InstancedMeshes&, const LoadSettings&);

    [[nodiscard]] bool meetInCrease(const BorderEdge&, const BorderEdge&, const SharedLength&) const;

private:
    [[nodiscard]] bool haveOneNormal(const BorderEdge&, const BorderEdge&, const SharedLength&) const;
    [[nodiscard]] glm::dvec3 normalAt(const BorderEdge&, double share) const;

    InstancedMeshes instanced_;
    double creaseCosine_;  // between `into` directions; over it there is a crease
    double sharedCosine_;  // the same where the normals agree
};

}  // namespace inkedge::scene
