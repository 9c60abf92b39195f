#include "formats/polygons/polygons.h"

#include <glm/geometric.hpp>

#include "base/message.h"

namespace inkedge::load {
namespace {

// Twice the signed area.
double cross(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

// Newell's sum: the polygon's normal, twice its area long.
glm::dvec3 normalOf(std::span<const glm::dvec3> corners) {
    glm::dvec3 sum{0.0};
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        sum += glm::cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
    return sum;
}

}  // namespace

std::span<const PolygonCutter::Triangle> PolygonCutter::cut(std::span<const glm::dvec3> corners) {
    triangles_.clear();
    if (corners.size() == 3)
        triangles_.push_back({0, 1, 2});
    else if (corners.size() == 4)
        cutQuad(corners);
    else
        cutPolygon(corners);
    return triangles_;
}

void PolygonCutter::cutQuad(std::span<const glm::dvec3> corners) {
    const glm::dvec3 normal = normalOf(corners);
    const auto hollow = [&](std::size_t i) {
        const glm::dvec3& corner = corners[i];
        const glm::dvec3 turn = glm::cross(corners[(i + 1) % 4] - corner, corners[(i + 3) % 4] - corner);
        return glm::dot(turn, normal) < 0.0;
    };
    if (hollow(1) || hollow(3))
        triangles_ = {{1, 2, 3}, {1, 3, 0}};
    else
        triangles_ = {{0, 1, 2}, {0, 2, 3}};
}

// Ear clipping, in the plane that the polygon comes closest to.
void PolygonCutter::cutPolygon(std::span<const glm::dvec3> corners) {
    const auto count = static_cast<std::uint32_t>(corners.size());
    flatten(corners);
    gone_.assign(count, false);
    previous_.resize(count);
    next_.resize(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        previous_[i] = i == 0 ? count - 1 : i - 1;
        next_[i] = i + 1 == count ? 0 : i + 1;
    }
    hollow_.clear();
    for (std::uint32_t i = 0; i < count; ++i)
        if (area(i) <= 0.0) hollow_.push_back(i);

    std::uint32_t corner = 0;
    std::uint32_t misses = 0;
    for (std::uint32_t left = count; left > 3;) {
        const bool none = misses == left;
        if (none) corner = leastBadEar(corner);
        if (none || isEar(corner)) {
            cutOff(corner);
            corner = next_[next_[corner]];  // not the neighbour: that would make a fan of slivers
            misses = 0;
            --left;
        } else {
            corner = next_[corner];
            ++misses;
        }
    }
    triangles_.push_back({previous_[corner], corner, next_[corner]});
}

void PolygonCutter::flatten(std::span<const glm::dvec3> corners) {
    const glm::dvec3 normal = normalOf(corners);
    const glm::dvec3 size = glm::abs(normal);
    const int axis = size.z >= size.x && size.z >= size.y ? 2 : (size.y >= size.x ? 1 : 0);
    const bool turned = normal[axis] < 0.0;
    const int x = (axis + (turned ? 2 : 1)) % 3;
    const int y = (axis + (turned ? 1 : 2)) % 3;
    flat_.clear();
    for (const glm::dvec3& corner : corners) flat_.emplace_back(corner[x], corner[y]);
}

double PolygonCutter::area(std::uint32_t corner) const {
    return cross(flat_[previous_[corner]], flat_[corner], flat_[next_[corner]]);
}

bool PolygonCutter::isEar(std::uint32_t corner) {
    spend(1);
    if (area(corner) <= 0.0) return false;
    const glm::dvec2 a = flat_[previous_[corner]];
    const glm::dvec2 b = flat_[corner];
    const glm::dvec2 c = flat_[next_[corner]];
    spend(hollow_.size());
    for (const std::uint32_t other : hollow_) {
        const glm::dvec2 p = flat_[other];
        if (gone_[other] || p == a || p == b || p == c) continue;
        if (cross(a, b, p) >= 0.0 && cross(b, c, p) >= 0.0 && cross(c, a, p) >= 0.0) return false;
    }
    return true;
}

// Where there is no ear: a corner on a line, whose triangle covers nothing, or else a convex one.
std::uint32_t PolygonCutter::leastBadEar(std::uint32_t corner) const {
    const std::uint32_t first = corner;
    std::uint32_t convex = corner;
    do {
        const double size = area(corner);
        if (size == 0.0) return corner;
        if (size > 0.0) convex = corner;
        corner = next_[corner];
    } while (corner != first);
    return convex;
}

void PolygonCutter::cutOff(std::uint32_t ear) {
    const std::uint32_t before = previous_[ear];
    const std::uint32_t after = next_[ear];
    triangles_.push_back({before, ear, after});
    next_[before] = after;
    previous_[after] = before;
    gone_[ear] = true;
}

void PolygonCutter::spend(std::uint64_t steps) {
    if (steps > stepsLeft_) refuse("expected polygons that are simple to cut into triangles, found very complex ones");
    stepsLeft_ -= steps;
}

}  // namespace inkedge::load
