#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "base/union_find.h"
#include "scene/box_tree.h"
#include "scene/instanced_meshes.h"

namespace inkedge::scene {

/// Of the scene's radius: within it borders run along each other. A fortieth of a pixel of a model framed at 1024 pixels.
inline constexpr double seamTolerance = 5e-5;

/// A border edge of an instance's mesh, in world space less the centre of InstancedMeshes::bounds.
struct BorderEdge {
    std::uint32_t instance;
    std::uint32_t halfEdge;
    glm::dvec3 a;
    glm::dvec3 b;
    glm::dvec3 into;  ///< unit, in the face's plane, across the edge into the face
};

/// All border edges of a scene, except those of faces that repeat others or are too thin.
class Borders {
public:
    /// @param faceNormals  for each mesh as MeshTopology::faceNormals
    Borders(const InstancedMeshes&,
            const std::function<const std::vector<glm::dvec3>&(std::uint32_t mesh)>& faceNormals);

    [[nodiscard]] const std::vector<BorderEdge>& edges() const noexcept { return edges_; }
    /// seamTolerance in scene units.
    [[nodiscard]] double tolerance() const noexcept { return tolerance_; }

    /// Calls visit(j) for the borders j > i near border i. Where very many unconnected faces overlap each other the
    /// search ends early, and some are missed.
    template <class Visit>
    void forEachNear(std::uint32_t i, Visit&& visit) {
        const Box box{boxes_[i].min - tolerance_, boxes_[i].max + tolerance_};
        tree_.forEachOverlap(box, stepsLeft_, [&](std::uint32_t j) {
            if (j > i) visit(j);
        });
    }

private:
    std::vector<BorderEdge> edges_;
    double tolerance_;
    std::vector<Box> boxes_;
    BoxTree tree_;
    std::uint64_t stepsLeft_;
};

/// The stretch along which two segments run along each other: as shares of each one's length from its a, from <= to.
struct SharedLength {
    double from[2];
    double to[2];
};

/// The shared stretch of two segments; none if they are further apart than the tolerance, or share no more than that.
[[nodiscard]] std::optional<SharedLength> runAlong(const BorderEdge&, const BorderEdge&, double tolerance);

/// Joins the patches on both sides of every seam: two mesh borders that run along each other within
/// seamTolerance, where the surfaces bend by less than the crease angle. O(b log b + pairs of borders near each
/// other).
/// @param base    PatchNumbers::base
/// @param joined  sets of the patches of all instances
void joinAcrossSeams(const InstancedMeshes&, const std::vector<std::uint32_t>& base, double creaseAngle,
                     base::UnionFind& joined);

}  // namespace inkedge::scene
