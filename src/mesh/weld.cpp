#include "mesh/weld.h"

#include <algorithm>
#include <array>
#include <bit>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace inkedge {
namespace {

constexpr std::uint32_t none = ~0U;

struct Bounds {
    glm::dvec3 low{0.0};
    double diagonal = 0.0;
};

Bounds boundsOf(std::span<const glm::vec3> positions) {
    if (positions.empty()) return {};
    glm::vec3 low = positions.front();
    glm::vec3 high = low;
    for (const glm::vec3 p : positions) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    return {low, glm::length(glm::dvec3{high} - glm::dvec3{low})};
}

// Cells are so much wider than the tolerance that what is near a point mostly lies in its own, and so much narrower
// than a mesh's edges that they mostly hold one point. An axis has at most 1 / (cellWidth * weldTolerance) = 31,250 of
// them.
class CellGrid {
public:
    CellGrid(std::span<const glm::vec3> positions, const Bounds& bounds, double tolerance)
        : positions_{positions},
          low_{bounds.low},
          cells_{1.0 / (cellWidth * tolerance)},
          squaredTolerance_{tolerance * tolerance},
          heads_(std::bit_ceil(positions.size() + positions.size() / 2 + 1), none),
          shift_{64 - std::countr_zero(heads_.size())} {
        places_.reserve(positions.size());
    }

    // What a position's place is looked up by; apart from looking, so that memory can be fetched in between.
    struct Cell {
        glm::dvec3 scaled;
        std::uint64_t slot;
    };
    [[nodiscard]] Cell cellOf(std::uint32_t position) const {
        const glm::dvec3 scaled = (glm::dvec3{positions_[position]} - low_) * cells_;
        const Cell cell{scaled, slot(glm::uvec3{scaled})};
        __builtin_prefetch(&heads_[cell.slot]);
        return cell;
    }

    // The first place within the tolerance of a position, or a new one: whatever the order in cells, positions that are
    // equal come to one.
    std::uint32_t placeOf(std::uint32_t position, const Cell& cell) {
        constexpr double margin = 1.0 / cellWidth;  // the tolerance, in cells
        // Towards 0 is downwards but below 0, where nothing lies.
        const glm::uvec3 least{glm::max(cell.scaled - margin, 0.0)};
        const glm::uvec3 most{cell.scaled + margin};
        const glm::vec3 p = positions_[position];
        std::uint32_t near = firstNear(cell.slot, p, none);
        if (least != most) {
            for (std::uint32_t x = least.x; x <= most.x; ++x)
                for (std::uint32_t y = least.y; y <= most.y; ++y)
                    for (std::uint32_t z = least.z; z <= most.z; ++z) near = firstNear(slot({x, y, z}), p, near);
        }
        if (near != none) return near;
        const auto place = static_cast<std::uint32_t>(places_.size());
        places_.push_back({position, heads_[cell.slot]});
        heads_[cell.slot] = place;
        return place;
    }

    [[nodiscard]] std::uint32_t placeCount() const { return static_cast<std::uint32_t>(places_.size()); }

private:
    static constexpr double cellWidth = 64.0;  // tolerances

    struct Place {
        std::uint32_t position;  // its first
        std::uint32_t next;      // place in the same slot, which came before
    };

    [[nodiscard]] std::uint32_t firstNear(std::uint64_t slot, glm::vec3 p, std::uint32_t otherwise) const {
        std::uint32_t first = otherwise;
        for (std::uint32_t place = heads_[slot]; place != none; place = places_[place].next) {
            const glm::dvec3 apart = glm::dvec3{positions_[places_[place].position]} - glm::dvec3{p};
            if (glm::dot(apart, apart) <= squaredTolerance_) first = std::min(first, place);
        }
        return first;
    }

    [[nodiscard]] std::uint64_t slot(glm::uvec3 cell) const {
        const std::uint64_t packed = cell.x | std::uint64_t{cell.y} << 16U | std::uint64_t{cell.z} << 32U;
        const std::uint64_t mixed = (packed ^ packed >> 23U) * 0x9E3779B97F4A7C15U;
        return (mixed ^ mixed >> 32U) * 0xD6E8FEB86659FD93U >> shift_;
    }

    std::span<const glm::vec3> positions_;
    glm::dvec3 low_;
    double cells_;  // a unit of length
    double squaredTolerance_;
    std::vector<std::uint32_t> heads_;
    int shift_;
    std::vector<Place> places_;
};

}  // namespace

double weldToleranceOf(std::span<const glm::vec3> positions) { return weldTolerance * boundsOf(positions).diagonal; }

Weld weldByPosition(std::span<const glm::vec3> positions) {
    const Bounds bounds = boundsOf(positions);
    Weld weld;
    weld.tolerance = weldTolerance * bounds.diagonal;
    weld.point.resize(positions.size());
    if (bounds.diagonal == 0.0) {
        weld.pointCount = positions.empty() ? 0 : 1;
        return weld;
    }
    CellGrid grid{positions, bounds, weld.tolerance};
    constexpr std::uint32_t ahead = 16;  // their slots are on the way from memory
    std::array<CellGrid::Cell, ahead> cells;
    const auto count = static_cast<std::uint32_t>(positions.size());
    for (std::uint32_t i = 0; i < std::min(count, ahead); ++i) cells[i] = grid.cellOf(i);
    for (std::uint32_t i = 0; i < count; ++i) {
        const CellGrid::Cell cell = cells[i % ahead];
        if (i + ahead < count) cells[i % ahead] = grid.cellOf(i + ahead);
        weld.point[i] = grid.placeOf(i, cell);
    }
    weld.pointCount = grid.placeCount();
    return weld;
}

}  // namespace inkedge
