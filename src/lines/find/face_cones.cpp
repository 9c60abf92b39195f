#include "lines/find/face_cones.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <glm/geometric.hpp>

#include "base/parallel.h"

namespace inkedge::lines {
namespace {

constexpr float rounding = 1e-6F;  // of sums of a few floats below 4

struct Cone {
    glm::vec3 axis{0.0F};
    float radius = FourCones::noNormals;
};

void set(FourCones& cones, std::size_t k, const Cone& cone, float widest) {
    for (int axis = 0; axis < 3; ++axis) cones.axis[axis][k] = cone.axis[axis];
    cones.radius[k] = cone.radius > widest ? FourCones::wide : cone.radius;
}

// Around the normals of up to four faces, or around as many cones.
Cone around(std::span<const Cone> parts) {
    Cone cone;
    glm::vec3 sum{0.0F};
    for (const Cone& part : parts) {
        if (part.radius == FourCones::wide) return {part.axis, FourCones::wide};
        if (part.radius != FourCones::noNormals) sum += glm::dot(part.axis, sum) < 0.0F ? -part.axis : part.axis;
    }
    const float length = glm::length(sum);
    if (length == 0.0F) return cone;
    cone.axis = sum / length;
    for (const Cone& part : parts) {
        if (part.radius == FourCones::noNormals) continue;
        const glm::vec3 axis = glm::dot(part.axis, cone.axis) < 0.0F ? -part.axis : part.axis;
        cone.radius = std::max(cone.radius, glm::distance(axis, cone.axis) + part.radius + rounding);
    }
    return cone;
}

}  // namespace

FaceCones::FaceCones(const FaceTree& tree, std::span<const glm::dvec3> normals, float widest) {
    const std::size_t packets = tree.packets.size();
    std::vector<FourCones>& bottom = levels_.emplace_back((packets + 3) / 4);
    base::inRanges(tree.triangles.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t node = (begin + 15) / 16; node * 16 < end; ++node) {
            for (std::size_t p = 4 * node; p < std::min(4 * node + 4, packets); ++p) {
                std::array<Cone, 4> faces{};
                for (std::size_t k = 0; k < tree.facesIn(static_cast<std::uint32_t>(p)); ++k) {
                    const glm::dvec3 normal = normals[tree.triangles[4 * p + k]];
                    if (normal != glm::dvec3{0.0}) faces[k] = {glm::vec3{normal}, 0.0F};
                }
                set(bottom[node], p - 4 * node, around(faces), widest);
            }
        }
    });
    while (levels_.back().size() > 1) {
        const std::vector<FourCones>& below = levels_.back();
        std::vector<FourCones> above((below.size() + 3) / 4);
        for (std::size_t i = 0; i < below.size(); ++i) {
            std::array<Cone, 4> parts{};
            for (std::size_t k = 0; k < 4; ++k)
                parts[k] = {{below[i].axis[0][k], below[i].axis[1][k], below[i].axis[2][k]}, below[i].radius[k]};
            set(above[i / 4], i % 4, around(parts), widest);
        }
        levels_.push_back(std::move(above));
    }
}

}  // namespace inkedge::lines
