#include "lines/see/surface_components.h"

#include <algorithm>

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include "base/union_find.h"
#include "mesh/closed_surface.h"
#include "scene/prepared.h"

namespace inkedge::lines {
namespace {

void extend(Box& box, glm::dvec3 point) {
    box = box.empty() ? Box{point, point} : Box{glm::min(box.min, point), glm::max(box.max, point)};
}

}  // namespace

SurfaceComponents::SurfaceComponents(const Scene& scene, std::span<const BorderSegment> borders) {
    std::vector<std::uint32_t> counts;
    for (std::size_t i = 0; i < scene.meshes().size(); ++i) {
        mesh::Components components = mesh::findComponents(scene::topologyOf(scene, i));
        ofFaces_.push_back(std::move(components.ofFaces));
        counts.push_back(components.count);
    }
    std::uint32_t total = 0;
    for (const Instance& instance : scene.instances()) {
        meshes_.push_back(instance.mesh);
        begins_.push_back(total);
        total += counts[instance.mesh];
    }
    base::UnionFind joined{total};
    const auto number = [&](scene::SceneFace face) {
        return begins_[face.instance] + ofFaces_[meshes_[face.instance]][face.triangle];
    };
    for (const BorderSegment& border : borders)
        if (border.other != noFace) joined.unite(number({border.instance, border.halfEdge / 3}), number(border.other));
    components_.resize(total);
    for (std::uint32_t i = 0; i < total; ++i) components_[i] = joined.root(i);
    areOne_ = std::ranges::all_of(components_, [](std::uint32_t component) { return component == 0; });
    if (!areOne_ && total <= manyComponents) makeBoxes(scene, counts);
}

void SurfaceComponents::makeBoxes(const Scene& scene, std::span<const std::uint32_t> counts) {
    std::vector<std::vector<Box>> ofMeshes;
    for (std::size_t i = 0; i < scene.meshes().size(); ++i) {
        const Mesh& mesh = scene.meshes()[i];
        std::vector<Box>& boxes = ofMeshes.emplace_back(counts[i]);
        for (std::size_t c = 0; c < mesh.indices.size(); ++c)
            extend(boxes[ofFaces_[i][c / 3]], glm::dvec3{mesh.positions[mesh.indices[c]]} + mesh.origin);
    }
    for (std::size_t i = 0; i < meshes_.size(); ++i) {
        for (std::uint32_t k = 0; k < counts[meshes_[i]]; ++k) {
            const std::uint32_t component = components_[begins_[i] + k];
            auto found = std::ranges::find(boxes_, component, &ComponentBox::component);
            if (found == boxes_.end()) found = boxes_.insert(found, {component, {}});
            const Box& box = ofMeshes[meshes_[i]][k];
            for (int corner = 0; corner < 8; ++corner) {
                const glm::dvec3 p{(corner & 1) != 0 ? box.max.x : box.min.x, (corner & 2) != 0 ? box.max.y : box.min.y,
                                   (corner & 4) != 0 ? box.max.z : box.min.z};
                extend(found->box,
                       glm::dvec3{scene.instances()[i].transform * glm::dvec4{p, 1.0}} - scene.bounds().centre);
            }
        }
    }
}

bool SurfaceComponents::mayBeNear(scene::SceneFace face, glm::dvec3 point, double within) const noexcept {
    const auto holds = [&](const ComponentBox& other) {
        return other.component != of(face) && glm::all(glm::greaterThanEqual(point, other.box.min - within)) &&
               glm::all(glm::lessThanEqual(point, other.box.max + within));
    };
    return boxes_.empty() || std::ranges::any_of(boxes_, holds);
}

}  // namespace inkedge::lines
