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

// Whether the vertices of an instance do not all lie at one point, as they do where an animation scales by 0.
bool hasExtent(const InstancedBoxes& instanced, const Instance& instance) {
    const Box& box = instanced.boxes[instance.mesh];
    const glm::dvec3 size = box.max - box.min;
    for (int axis = 0; axis < 3; ++axis)
        if (size[axis] * glm::dvec3{instance.transform[axis]} != glm::dvec3{0.0}) return true;
    return false;
}

// Calls an action for every instance that counts: those with an extent, or all if none has one.
template <class Action>
void forEachInstance(const InstancedBoxes& instanced, Action&& action) {
    const auto extends = [&](const Instance& instance) { return hasExtent(instanced, instance); };
    const bool someExtend = std::ranges::any_of(instanced.instances, extends);
    for (const Instance& instance : instanced.instances)
        if (!someExtend || extends(instance)) action(instance, instanced.meshes[instance.mesh]);
}

// The maximum of a convex measure(position, world transform) over all drawn vertices. Over a box the maximum of a
// convex function lies at a corner.
template <class Measure>
double maximum(const InstancedBoxes& instanced, Measure measure) {
    double largest = -std::numeric_limits<double>::infinity();
    forEachInstance(instanced, [&](const Instance& instance, const Mesh& mesh) {
        const auto at = [&](glm::dvec3 p) {
            return measure(glm::dvec3{instance.transform * glm::dvec4{p + mesh.origin, 1.0}});
        };
        double reach = -std::numeric_limits<double>::infinity();
        for (const glm::dvec3 corner : cornersOf(instanced.boxes[instance.mesh])) reach = std::max(reach, at(corner));
        if (reach <= largest) return;
        for (const glm::vec3 p : mesh.positions) largest = std::max(largest, at(p));
        for (const glm::vec3 p : mesh.lines) largest = std::max(largest, at(p));
    });
    return largest;
}

InstancedBoxes instancedBoxesOf(const Scene& scene) {
    const PreparedScene& prepared = *preparedOf(scene);
    return {prepared.data.meshes, prepared.meshBoxes, prepared.data.instances};
}

}  // namespace

void forEachInstance(const Scene& scene, const std::function<void(const Instance&, const Mesh&)>& action) {
    forEachInstance(instancedBoxesOf(scene), action);
}

double support(const Scene& scene, glm::dvec3 direction) {
    return maximum(instancedBoxesOf(scene), [&](glm::dvec3 p) { return glm::dot(direction, p); });
}

Box boxOfAll(const InstancedBoxes& instanced) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Box all{glm::dvec3{infinity}, glm::dvec3{-infinity}};
    forEachInstance(instanced, [&](const Instance& instance, const Mesh& mesh) {
        const auto at = [&](glm::dvec3 p) { return glm::dvec3{instance.transform * glm::dvec4{p + mesh.origin, 1.0}}; };
        const auto addTo = [&](Box& box, glm::dvec3 p) {
            box.min = glm::min(box.min, at(p));
            box.max = glm::max(box.max, at(p));
        };
        Box reach = all;
        for (const glm::dvec3 corner : cornersOf(instanced.boxes[instance.mesh])) addTo(reach, corner);
        if (reach.min == all.min && reach.max == all.max) return;
        for (const glm::vec3 p : mesh.positions) addTo(all, p);
        for (const glm::vec3 p : mesh.lines) addTo(all, p);
    });
    return all;
}

double farthestDistance(const InstancedBoxes& instanced, glm::dvec3 point) {
    return std::sqrt(maximum(instanced, [&](glm::dvec3 p) { return glm::dot(p - point, p - point); }));
}

}  // namespace inkedge::scene
