#include "formats/polygons/polygons.h"

#include <glm/geometric.hpp>

#include "base/message.h"
#include "mesh/twice_area.h"

namespace inkedge::polygons {
namespace {

// Newell's sum: the normal of a polygon, with twice its area as length.
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

// Ear clipping in the plane that fits the polygon best.
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
    std::vector<std::uint32_t> hollow;
    for (std::uint32_t i = 0; i < count; ++i)
        if (area(i) <= 0.0) hollow.push_back(i);
    reflex_.build(flat_, std::move(hollow));
    candidates_.clear();
    for (std::uint32_t i = 0; i < count; ++i) candidates_.insert(candidates_.end(), i);
    waiting_.clear();

    std::uint32_t corner = 0;
    for (std::uint32_t left = count; left > 3; --left) {
        corner = nextEar(corner);
        cutOff(corner);
        corner = next_[next_[corner]];  // not the neighbour: that would make a fan of slivers
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
    return mesh::twiceArea(flat_[previous_[corner]], flat_[corner], flat_[next_[corner]]);
}

// The first ear from a corner on. A corner that is no ear is looked at again when its triangle has changed, or when the
// corner that lay in the triangle is gone.
std::uint32_t PolygonCutter::nextEar(std::uint32_t corner) {
    while (!candidates_.empty()) {
        auto found = candidates_.lower_bound(corner);
        if (found == candidates_.end()) found = candidates_.begin();
        const std::uint32_t candidate = *found;
        if (isEar(candidate)) return candidate;
        candidates_.erase(found);
    }
    return forcedEar(corner);
}

bool PolygonCutter::isEar(std::uint32_t corner) {
    spend(1);
    if (area(corner) <= 0.0) return false;
    std::uint64_t steps = 0;
    const std::uint32_t other = reflex_.within(flat_[previous_[corner]], flat_[corner], flat_[next_[corner]], steps);
    spend(steps);
    if (other != CornerTree::none) waiting_.emplace(other, corner);
    return other == CornerTree::none;
}

// The corner to cut where there is no ear: one on a straight line, whose triangle has no area, or else a convex one.
std::uint32_t PolygonCutter::forcedEar(std::uint32_t corner) {
    const std::uint32_t first = corner;
    std::uint32_t convex = corner;
    do {
        spend(1);
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
    reflex_.remove(ear);
    candidates_.erase(ear);
    candidates_.insert({before, after});
    const auto [first, last] = waiting_.equal_range(ear);
    for (auto it = first; it != last; ++it)
        if (!gone_[it->second]) candidates_.insert(it->second);
    waiting_.erase(first, last);
}

void PolygonCutter::spend(std::uint64_t steps) {
    if (steps > stepsLeft_)
        base::refuse("expected polygons that are simple to cut into triangles, found very complex ones");
    stepsLeft_ -= steps;
}

}  // namespace inkedge::polygons
