#include "scene/coplanar_layers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "scene/topology.h"
#include "scene/world_triangles.h"

namespace inkedge {
namespace {

constexpr double planeTolerance = 2e-6;   // of the scene's radius: float coordinates are no finer
constexpr double normalStep = 1.0 / 256;  // normals are sorted into cells this wide,
constexpr double normalTolerance = 1e-4;  // and into each cell that they are this near to

constexpr std::uint64_t maximumSteps = 300'000'000;  // about two seconds

struct Face {
    std::uint32_t cell;  // of normals, numbered over a cube
    float distance;      // of the plane from the scene's centre, in radii
    std::uint32_t instance;
    std::uint32_t triangle;
};

// One of two opposite normals: they name one plane. The largest component decides, so that noise cannot.
glm::dvec3 canonical(glm::dvec3 n) {
    const glm::dvec3 size = glm::abs(n);
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    return n[axis] < 0.0 ? -n : n;
}

// Cells that a normal lies in or is within the tolerance of: one, seldom two to eight.
template <class Visit>
void forEachCell(glm::dvec3 n, Visit visit) {
    std::array<std::uint32_t, 8> seen{};
    std::size_t count = 0;
    for (int i = 0; i < 8; ++i) {
        const glm::dvec3 offset{i & 1 ? normalTolerance : -normalTolerance, i & 2 ? normalTolerance : -normalTolerance,
                                i & 4 ? normalTolerance : -normalTolerance};
        std::uint32_t cell = 0;
        for (int axis = 0; axis < 3; ++axis) {
            cell = cell * 1024 + static_cast<std::uint32_t>(std::floor((n[axis] + offset[axis]) / normalStep) + 512.0);
        }
        if (std::find(seen.begin(), seen.begin() + count, cell) != seen.begin() + count) continue;
        seen[count++] = cell;
        visit(cell);
    }
}

struct FlatTriangle {
    std::array<glm::dvec2, 3> corners;
    double low;
    double high;  // along the first axis
    std::uint32_t patch;
    std::uint32_t number;
};

double cross(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

// Whether a line along one side of a separates it from b; overlaps thinner than the margin count as separate.
bool separates(const FlatTriangle& a, const FlatTriangle& b, double margin) {
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec2 from = a.corners[i];
        const glm::dvec2 side = a.corners[(i + 1) % 3] - from;
        const double length = glm::length(side);
        if (length == 0.0) continue;
        const double inward = cross(side, a.corners[(i + 2) % 3] - from) >= 0.0 ? 1.0 / length : -1.0 / length;
        const auto inside = [&](glm::dvec2 p) { return cross(side, p - from) * inward > margin; };
        if (std::ranges::none_of(b.corners, inside)) return true;
    }
    return false;
}

class LayerFinder {
public:
    LayerFinder(const Scene& scene, const PatchNumbers& patches)
        : scene_{scene}, patches_{patches}, layered_(patches.number.size(), false) {}

    std::vector<bool> find() {
        collectFaces();
        std::ranges::sort(faces_, [](const Face& a, const Face& b) {
            return a.cell != b.cell ? a.cell < b.cell : a.distance < b.distance;
        });
        for (std::size_t begin = 0; begin < faces_.size();) {
            std::size_t end = begin + 1;  // chains of planes, each within the tolerance of the one before
            while (end < faces_.size() && faces_[end].cell == faces_[begin].cell &&
                   faces_[end].distance - faces_[end - 1].distance <= static_cast<float>(planeTolerance)) {
                ++end;
            }
            findIn({faces_.data() + begin, end - begin});
            begin = end;
        }
        return std::move(layered_);
    }

private:
    [[nodiscard]] WorldTriangles triangles(std::size_t instance) const {
        return {scene_, scene_.instances()[instance], scene_.bounds().centre};
    }

    [[nodiscard]] std::uint32_t patchOf(const Face& face) const {
        const std::uint32_t mesh = scene_.instances()[face.instance].mesh;
        return patches_.base[face.instance] + scene_.topology(mesh).patches[face.triangle];
    }

    void collectFaces() {
        for (std::uint32_t i = 0; i < scene_.instances().size(); ++i) {
            const WorldTriangles world = triangles(i);
            for (std::uint32_t t = 0; t < world.count(); ++t) {
                const auto [a, b, c] = world.triangle(t);
                const glm::dvec3 area = glm::cross(b - a, c - a);
                const double length = glm::length(area);
                if (length == 0.0) continue;
                const glm::dvec3 n = canonical(area / length);
                const auto distance = static_cast<float>(glm::dot(n, a) / scene_.bounds().radius);
                forEachCell(n, [&](std::uint32_t cell) { faces_.push_back({cell, distance, i, t}); });
            }
        }
    }

    // Overlaps among faces of about one plane.
    void findIn(std::span<const Face> group) {
        const std::uint32_t firstNumber = patches_.number[patchOf(group.front())];
        if (std::ranges::all_of(group, [&](const Face& f) { return patches_.number[patchOf(f)] == firstNumber; }))
            return;

        const std::vector<FlatTriangle> flat = flatten(group);
        const double margin = planeTolerance * scene_.bounds().radius;
        std::vector<const FlatTriangle*> active;
        for (const FlatTriangle& one : flat) {
            if (active.size() >= stepsLeft_) return markAll(group);
            stepsLeft_ -= active.size();
            std::erase_if(active, [&](const FlatTriangle* other) { return other->high <= one.low; });
            for (const FlatTriangle* other : active) {
                if (one.number == other->number || (layered_[one.patch] && layered_[other->patch])) continue;
                if (separates(one, *other, margin) || separates(*other, one, margin)) continue;
                layered_[one.patch] = layered_[other->patch] = true;
            }
            active.push_back(&one);
        }
    }

    // Drawing a face as a layer that is none costs time only.
    void markAll(std::span<const Face> group) {
        for (const Face& face : group) layered_[patchOf(face)] = true;
    }

    // In two axes of the plane, sorted along the first.
    [[nodiscard]] std::vector<FlatTriangle> flatten(std::span<const Face> group) const {
        const auto [a, b, c] = triangles(group.front().instance).triangle(group.front().triangle);
        const glm::dvec3 u = glm::normalize(b - a);
        const glm::dvec3 v = glm::normalize(glm::cross(glm::cross(b - a, c - a), u));
        std::vector<FlatTriangle> flat;
        flat.reserve(group.size());
        for (const Face& face : group) {
            const auto world = triangles(face.instance).triangle(face.triangle);
            FlatTriangle t{{}, 0.0, 0.0, patchOf(face), patches_.number[patchOf(face)]};
            for (std::size_t i = 0; i < 3; ++i) t.corners[i] = {glm::dot(world[i], u), glm::dot(world[i], v)};
            t.low = std::min({t.corners[0].x, t.corners[1].x, t.corners[2].x});
            t.high = std::max({t.corners[0].x, t.corners[1].x, t.corners[2].x});
            flat.push_back(t);
        }
        std::ranges::sort(flat, {}, &FlatTriangle::low);
        return flat;
    }

    const Scene& scene_;
    const PatchNumbers& patches_;
    std::vector<bool> layered_;
    std::vector<Face> faces_;
    std::uint64_t stepsLeft_ = maximumSteps;
};

}  // namespace

std::vector<bool> findCoplanarLayers(const Scene& scene, const PatchNumbers& patches) {
    if (patches.count < 2 || scene.bounds().radius == 0.0) return std::vector<bool>(patches.number.size(), false);
    return LayerFinder{scene, patches}.find();
}

}  // namespace inkedge
