#include "scene/extent.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "scene/prepared.h"

namespace inkedge::scene {
namespace {

std::array<glm::dvec3, 8> cornersOf(const Box& box) {
    std::array<glm::dvec3, 8> corners;
    for (unsigned i = 0; i < corners.size(); ++i) {
        corners[i] = {(i & 1U) != 0 ? box.max.x : box.min.x, (i & 2U) != 0 ? box.max.y : box.min.y,
                      (i & 4U) != 0 ? box.max.z : box.min.z};
    }
    return corners;
}

// The maximum of a convex measure(position, world transform) over all drawn vertices. Over a box the maximum of a
// convex function lies at a corner.
template <class Measure>
double maximum(const InstancedBoxes& instanced, Measure measure) {
    double largest = -std::numeric_limits<double>::infinity();
    for (const Instance& instance : instanced.instances) {
        const Mesh& mesh = instanced.meshes[instance.mesh];
        const auto at = [&](glm::dvec3 p) {
            return measure(glm::dvec3{instance.transform * glm::dvec4{p + mesh.origin, 1.0}});
        };
        double reach = -std::numeric_limits<double>::infinity();
        for (const glm::dvec3 corner : cornersOf(instanced.boxes[instance.mesh])) reach = std::max(reach, at(corner));
        if (reach <= largest) continue;
        for (const glm::vec3 p : mesh.positions) largest = std::max(largest, at(p));
    }
    return largest;
}

}  // namespace

double support(const Scene& scene, glm::dvec3 direction) {
    const PreparedScene& prepared = *preparedOf(scene);
    return maximum({prepared.data.meshes, prepared.meshBoxes, prepared.data.instances},
                   [&](glm::dvec3 p) { return glm::dot(direction, p); });
}

Box boxOfAll(const InstancedBoxes& instanced) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Box all{glm::dvec3{infinity}, glm::dvec3{-infinity}};
    for (const Instance& instance : instanced.instances) {
        const Mesh& mesh = instanced.meshes[instance.mesh];
        const auto at = [&](glm::dvec3 p) { return glm::dvec3{instance.transform * glm::dvec4{p + mesh.origin, 1.0}}; };
        const auto addTo = [&](Box& box, glm::dvec3 p) {
            box.min = glm::min(box.min, at(p));
            box.max = glm::max(box.max, at(p));
        };
        Box reach = all;
        for (const glm::dvec3 corner : cornersOf(instanced.boxes[instance.mesh])) addTo(reach, corner);
        if (reach.min == all.min && reach.max == all.max) continue;
        for (const glm::vec3 p : mesh.positions) addTo(all, p);
    }
    return all;
}

double farthestDistance(const InstancedBoxes& instanced, glm::dvec3 point) {
    return std::sqrt(maximum(instanced, [&](glm::dvec3 p) { return glm::dot(p - point, p - point); }));
}

}  // namespace inkedge::scene
