#include "scene/extent.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

namespace inkedge {
namespace {

// The maximum of a convex measure(position, world transform) over all drawn vertices: over a box it lies at a corner.
template <class Measure>
double maximum(const Scene& scene, Measure measure) {
    double most = -std::numeric_limits<double>::infinity();
    for (const Instance& instance : scene.instances()) {
        const Mesh& mesh = scene.meshes()[instance.mesh];
        const Box& box = scene.meshBox(instance.mesh);
        const auto at = [&](glm::dvec3 p) {
            return measure(glm::dvec3{instance.transform * glm::dvec4{p + mesh.origin, 1.0}});
        };
        double reach = -std::numeric_limits<double>::infinity();
        for (int corner = 0; corner < 8; ++corner) {
            reach = std::max(reach,
                             at({(corner & 1) != 0 ? box.max.x : box.min.x, (corner & 2) != 0 ? box.max.y : box.min.y,
                                 (corner & 4) != 0 ? box.max.z : box.min.z}));
        }
        if (reach <= most) continue;
        for (const glm::vec3 p : mesh.positions) most = std::max(most, at(p));
    }
    return most;
}

}  // namespace

double support(const Scene& scene, glm::dvec3 direction) {
    return maximum(scene, [&](glm::dvec3 p) { return glm::dot(direction, p); });
}

double farthestDistance(const Scene& scene, glm::dvec3 point) {
    return std::sqrt(maximum(scene, [&](glm::dvec3 p) { return glm::dot(p - point, p - point); }));
}

}  // namespace inkedge
