#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "base/union_find.h"
#include "scene/box_tree.h"
#include "scene/placed_meshes.h"

namespace inkedge {

/// A border of an instance's mesh, in world space less the centre of PlacedMeshes::bounds.
struct BorderEdge {
    std::uint32_t instance;
    std::uint32_t halfEdge;
    glm::dvec3 a;
    glm::dvec3 b;
    glm::dvec3 into;  ///< unit, in the face's plane, across the edge into the face
};

/// All borders of a scene, but for those of faces that repeat others or are too thin.
class Borders {
public:
    /// @param faceNormals  for each mesh as MeshTopology::faceNormals
    Borders(const PlacedMeshes&, const std::function<const std::vector<glm::dvec3>&(std::uint32_t mesh)>& faceNormals);

    [[nodiscard]] const std::vector<BorderEdge>& edges() const noexcept { return edges_; }
    /// How far apart two borders that run along each other may be: 1/20,000 of the scene's radius.
    [[nodiscard]] double tolerance() const noexcept { return tolerance_; }

    /// Calls visit(j) for the borders j > i near border i; of a soup of faces in each other's way for some only.
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

/// Where two segments run along each other: shares of each one's length from its a, from <= to.
struct SharedLength {
    double from[2];
    double to[2];
};

/// None if they are further apart than the tolerance or share no more than it.
[[nodiscard]] std::optional<SharedLength> runAlong(const BorderEdge&, const BorderEdge&, double tolerance);

/// Joins the patches on both sides of every seam: two mesh borders that run along each other within 1/20,000 of the
/// scene's radius, bent there by less than the crease angle. O(b log b + pairs of borders that are near each other).
/// @param base    where each instance's patches begin
/// @param joined  sets of all instances' patches
void joinAcrossSeams(const PlacedMeshes&, const std::vector<std::uint32_t>& base, double creaseAngle,
                     UnionFind& joined);

}  // namespace inkedge
