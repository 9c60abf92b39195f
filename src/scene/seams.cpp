#include "scene/seams.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "scene/box_tree.h"
#include "scene/topology.h"
#include "scene/world_triangles.h"

namespace inkedge {
namespace {

constexpr double seamTolerance = 5e-5;  // of the scene's radius: 1/40 pixel of a model framed at 1024 pixels

// Only a soup of faces in each other's way needs more; seams beyond are then drawn.
std::uint64_t maximumSteps(std::size_t borders) { return 40'000'000 + 100 * std::uint64_t{borders}; }

struct Border {
    glm::dvec3 a;
    glm::dvec3 b;
    glm::dvec3 into;  // unit, in the face's plane, across the edge into the face
    std::uint32_t patch;
};

bool mayHaveSeams(const MeshTopology& topology, std::uint32_t t) { return topology.faceNormals[t] != glm::dvec3{0.0}; }

std::vector<Border> collectBorders(const Scene& scene, const std::vector<std::uint32_t>& base) {
    std::vector<Border> borders;
    for (std::size_t i = 0; i < scene.instances().size(); ++i) {
        const Instance& instance = scene.instances()[i];
        const MeshTopology& topology = scene.topology(instance.mesh);
        const WorldTriangles triangles{scene, instance, scene.bounds().centre};
        for (std::uint32_t h = 0; h < topology.twins.size(); ++h) {
            if (topology.twins[h] != noHalfEdge || !mayHaveSeams(topology, h / 3)) continue;
            if (topology.originals[h / 3] != h / 3) continue;  // a face that repeats another has no twins of its own
            const glm::dvec3 a = triangles.corner(h);
            const glm::dvec3 b = triangles.corner(nextHalfEdge(h));
            const glm::dvec3 third = triangles.corner(nextHalfEdge(nextHalfEdge(h)));
            const double length = glm::length(b - a);
            if (length == 0.0) continue;
            const glm::dvec3 along = (b - a) / length;
            const glm::dvec3 across = third - a - along * glm::dot(third - a, along);
            if (glm::length(across) == 0.0) continue;
            borders.push_back({a, b, glm::normalize(across), base[i] + topology.patches[h / 3]});
        }
    }
    return borders;
}

// Whether two segments run along each other for a length over the tolerance.
bool runAlong(const Border& one, const Border& other, double tolerance) {
    const Border& longer = glm::length(one.b - one.a) >= glm::length(other.b - other.a) ? one : other;
    const Border& shorter = &longer == &one ? other : one;
    const double length = glm::length(longer.b - longer.a);
    const glm::dvec3 along = (longer.b - longer.a) / length;
    const auto distance = [&](glm::dvec3 p) { return glm::length(glm::cross(p - longer.a, along)); };
    if (distance(shorter.a) > tolerance || distance(shorter.b) > tolerance) return false;
    const double s = glm::dot(shorter.a - longer.a, along);
    const double e = glm::dot(shorter.b - longer.a, along);
    return std::min(std::max(s, e), length) - std::max(std::min(s, e), 0.0) > tolerance;
}

}  // namespace

void joinAcrossSeams(const Scene& scene, const std::vector<std::uint32_t>& base, double creaseAngle,
                     UnionFind& joined) {
    const double tolerance = seamTolerance * scene.bounds().radius;
    // Faces that go on across the seam at a bend under the crease angle point away from each other by more than this.
    const double oppositeCosine = -std::cos(glm::radians(creaseAngle));
    const std::vector<Border> borders = collectBorders(scene, base);

    std::vector<Box> boxes;
    boxes.reserve(borders.size());
    for (const Border& border : borders) boxes.push_back({glm::min(border.a, border.b), glm::max(border.a, border.b)});
    const BoxTree tree{boxes};
    std::uint64_t stepsLeft = maximumSteps(borders.size());
    for (std::uint32_t i = 0; i < borders.size(); ++i) {
        const Border& border = borders[i];
        tree.forEachOverlap({boxes[i].min - tolerance, boxes[i].max + tolerance}, stepsLeft, [&](std::uint32_t j) {
            const Border& other = borders[j];
            if (j <= i || joined.root(border.patch) == joined.root(other.patch)) return;
            if (glm::dot(border.into, other.into) > oppositeCosine) return;
            if (runAlong(border, other, tolerance)) joined.unite(border.patch, other.patch);
        });
    }
}

}  // namespace inkedge
