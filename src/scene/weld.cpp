#include "scene/weld.h"

#include <bit>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace inkedge {
namespace {

constexpr std::uint32_t none = ~0U;

std::uint64_t mix(std::uint64_t h, std::uint64_t value) {
    h = (h ^ value) * 0x9E3779B97F4A7C15U;
    return h ^ (h >> 29U);
}

std::uint64_t hash(glm::vec3 p) {
    std::uint64_t h = 0;
    for (int i = 0; i < 3; ++i) h = mix(h, std::bit_cast<std::uint32_t>(p[i] + 0.0F));  // + 0: -0 and 0 hash alike
    return h;
}

struct Places {
    Weld weld;
    std::vector<std::uint32_t> first;  // a position of each place
};

Places weldEqual(std::span<const glm::vec3> positions) {
    Places places;
    places.weld.point.resize(positions.size());
    // Open addressing at a load of at most one half; a slot names a place.
    std::vector<std::uint32_t> slots(std::bit_ceil(2 * positions.size() + 1), none);
    const std::uint64_t mask = slots.size() - 1;
    for (std::uint32_t i = 0; i < positions.size(); ++i) {
        std::uint64_t slot = hash(positions[i]) & mask;
        while (slots[slot] != none && positions[places.first[slots[slot]]] != positions[i]) slot = (slot + 1) & mask;
        if (slots[slot] == none) {
            slots[slot] = places.weld.pointCount++;
            places.first.push_back(i);
        }
        places.weld.point[i] = slots[slot];
    }
    return places;
}

double diagonal(std::span<const glm::vec3> positions) {
    if (positions.empty()) return 0.0;
    glm::vec3 low = positions.front();
    glm::vec3 high = low;
    for (const glm::vec3 p : positions) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    return glm::length(glm::dvec3{high} - glm::dvec3{low});
}

// Cells are so much wider than the tolerance that what is near a point mostly lies in its own, and so much narrower than
// a mesh's edges that they mostly hold one point.
class CellGrid {
public:
    CellGrid(std::span<const glm::vec3> positions, const std::vector<std::uint32_t>& first, double tolerance)
        : positions_{positions},
          first_{first},
          tolerance_{tolerance},
          heads_(std::bit_ceil(2 * first.size() + 1), none),
          next_(first.size(), none) {}

    // A place added before that lies within the tolerance of this one, or none; this one is then added.
    std::uint32_t nearOrAdd(std::uint32_t place) {
        const glm::dvec3 p{positions_[first_[place]]};
        constexpr double cellWidth = 64.0;  // tolerances
        const glm::dvec3 scaled = p / (cellWidth * tolerance_);
        const glm::dvec3 low = glm::floor(scaled - 1.0 / cellWidth);
        const glm::dvec3 high = glm::floor(scaled + 1.0 / cellWidth);
        for (int i = 0; i < 8; ++i) {
            const glm::bvec3 upper{(i & 1) != 0, (i & 2) != 0, (i & 4) != 0};
            if (cellsAreOne(low, high, upper)) continue;
            const std::uint32_t near = nearIn(slot(glm::mix(low, high, upper)), p);
            if (near != none) return near;
        }
        std::uint32_t& head = heads_[slot(glm::floor(scaled))];
        next_[place] = head;
        head = place;
        return none;
    }

private:
    // Whether the upper cell along one of the axes wished for is the lower one again.
    static bool cellsAreOne(const glm::dvec3& low, const glm::dvec3& high, const glm::bvec3& upper) {
        return (upper.x && low.x == high.x) || (upper.y && low.y == high.y) || (upper.z && low.z == high.z);
    }

    [[nodiscard]] std::uint32_t nearIn(std::uint64_t slot, const glm::dvec3& p) const {
        std::uint32_t other = heads_[slot];
        while (other != none && glm::length(glm::dvec3{positions_[first_[other]]} - p) > tolerance_) other = next_[other];
        return other;
    }

    [[nodiscard]] std::uint64_t slot(glm::dvec3 cell) const {
        constexpr double farthest = 0x1p62;  // along an axis where all points lie far off and nearly in one plane
        const glm::dvec3 bounded = glm::clamp(cell, -farthest, farthest);
        std::uint64_t h = 0;
        for (int i = 0; i < 3; ++i) h = mix(h, static_cast<std::uint64_t>(static_cast<std::int64_t>(bounded[i])));
        return h & (heads_.size() - 1);
    }

    std::span<const glm::vec3> positions_;
    const std::vector<std::uint32_t>& first_;
    double tolerance_;
    std::vector<std::uint32_t> heads_;
    std::vector<std::uint32_t> next_;
};

}  // namespace

Weld weldByPosition(std::span<const glm::vec3> positions) {
    Places places = weldEqual(positions);
    const double tolerance = weldTolerance * diagonal(positions);
    places.weld.tolerance = tolerance;
    if (tolerance == 0.0) return std::move(places.weld);

    CellGrid grid{positions, places.first, tolerance};
    std::vector<std::uint32_t> merged(places.weld.pointCount);
    std::uint32_t count = 0;
    for (std::uint32_t place = 0; place < merged.size(); ++place) {
        const std::uint32_t near = grid.nearOrAdd(place);
        merged[place] = near == none ? count++ : merged[near];
    }
    for (std::uint32_t& point : places.weld.point) point = merged[point];
    places.weld.pointCount = count;
    return std::move(places.weld);
}

}  // namespace inkedge
