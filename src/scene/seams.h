#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <vector>

#include <glm/geometric.hpp>

#include <inkedge/settings.h>

#include "base/union_find.h"
#include "scene/border_edge.h"
#include "scene/box_tree.h"
#include "scene/instanced_meshes.h"

namespace inkedge::scene {

/// All border edges of a scene, except those of faces that repeat others or are too thin.
class Borders {
public:
    /// @param faceNormals  for each mesh as MeshTopology::faceNormals
    Borders(const InstancedMeshes&,
            const std::function<const std::vector<glm::dvec3>&(std::uint32_t mesh)>& faceNormals);

    [[nodiscard]] const std::vector<BorderEdge>& edges() const noexcept { return edges_; }
    /// seamTolerance in scene units.
    [[nodiscard]] double tolerance() const noexcept { return tolerance_; }

    /// Calls visit(j) for the borders j > i that may run along border i, all that do among them. Where very many
    /// unconnected faces overlap each other the search ends early, and some are missed.
    template <class Visit>
    void forEachNear(std::uint32_t i, Visit&& visit) {
        const Box box{boxes_[i].min - tolerance_, boxes_[i].max + tolerance_};
        tree_.forEachOverlap(box, stepsLeft_, [&](std::uint32_t j, const Box& other) {
            if (j > i && mayBeParallel(boxes_[i], other)) visit(j);
        });
    }

private:
    // Decided by the boxes alone, which the search has at hand. Of a segment along a longer one no end is further off
    // than the tolerance, so that its direction is off by twice that at most; and the sides of boxes, which are the
    // sizes of directions, are no further off each other than the directions are.
    [[nodiscard]] bool mayBeParallel(const Box& one, const Box& other) const noexcept {
        const glm::dvec3 a = one.max - one.min;
        const glm::dvec3 b = other.max - other.min;
        const glm::dvec3 area = glm::cross(a, b);
        constexpr double rounding = 1.001;
        return glm::dot(area, area) <=
               rounding * 4.0 * tolerance_ * tolerance_ * std::max(glm::dot(a, a), glm::dot(b, b));
    }

    std::vector<BorderEdge> edges_;
    double tolerance_;
    std::vector<Box> boxes_;
    BoxTree tree_;
    std::uint64_t stepsLeft_;
};

/// Joins the patches on both sides of every seam: two mesh borders that run along each other within
/// seamTolerance, where the surfaces do not meet in a crease. O(b log b + pairs of borders near each other).
/// @param base    PatchNumbers::base
/// @param joined  sets of the patches of all instances
void joinAcrossSeams(const InstancedMeshes&, const std::vector<std::uint32_t>& base, const LoadSettings&,
                     base::UnionFind& joined);

}  // namespace inkedge::scene
