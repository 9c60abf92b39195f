#include "mesh/weld.h"

#include <algorithm>
#include <array>
#include <bit>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace inkedge::mesh {
namespace {

constexpr std::uint32_t noPoint = ~0U;

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

// Points by cells of space. Cells are so much wider than the tolerance that the neighbours of a point mostly lie in its
// own cell, and so much narrower than a mesh's edges that they mostly hold one point. An axis has at high
// 1 / (cellWidth * weldTolerance) = 31,250 cells.
class CellGrid {
public:
    CellGrid(std::span<const glm::vec3> positions, const Bounds& bounds, double tolerance)
        : positions_{positions},
          low_{bounds.low},
          cells_{1.0 / (cellWidth * tolerance)},
          squaredTolerance_{tolerance * tolerance},
          heads_(std::bit_ceil(positions.size() + positions.size() / 2 + 1), noPoint),
          shift_{64 - std::countr_zero(heads_.size())} {
        points_.reserve(positions.size());
    }

    // Where a position's point is looked up. Kept apart from the look-up, so that memory can be fetched in between.
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

    // The first point within the tolerance of a position, or a new one. Positions that are equal get the same point,
    // whatever the order in cells.
    std::uint32_t pointOf(std::uint32_t position, const Cell& cell) {
        constexpr double margin = 1.0 / cellWidth;  // the tolerance, in cells
        // Conversion rounds towards 0, which is downwards: nothing lies below 0.
        const glm::uvec3 low{glm::max(cell.scaled - margin, 0.0)};
        const glm::uvec3 high{cell.scaled + margin};
        const glm::vec3 p = positions_[position];
        std::uint32_t near = firstNear(cell.slot, p, noPoint);
        if (low != high) {
            for (std::uint32_t x = low.x; x <= high.x; ++x)
                for (std::uint32_t y = low.y; y <= high.y; ++y)
                    for (std::uint32_t z = low.z; z <= high.z; ++z) near = firstNear(slot({x, y, z}), p, near);
        }
        if (near != noPoint) return near;
        const auto point = static_cast<std::uint32_t>(points_.size());
        points_.push_back({position, heads_[cell.slot]});
        heads_[cell.slot] = point;
        return point;
    }

    [[nodiscard]] std::uint32_t pointCount() const { return static_cast<std::uint32_t>(points_.size()); }

private:
    static constexpr double cellWidth = 64.0;  // tolerances

    struct Point {
        std::uint32_t position;  // the first of the point's
        std::uint32_t next;      // an earlier point in the same slot
    };

    [[nodiscard]] std::uint32_t firstNear(std::uint64_t slot, glm::vec3 p, std::uint32_t otherwise) const {
        std::uint32_t first = otherwise;
        for (std::uint32_t point = heads_[slot]; point != noPoint; point = points_[point].next) {
            const glm::dvec3 apart = glm::dvec3{positions_[points_[point].position]} - glm::dvec3{p};
            if (glm::dot(apart, apart) <= squaredTolerance_) first = std::min(first, point);
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
    std::vector<Point> points_;
};

}  // namespace

double weldToleranceOf(std::span<const glm::vec3> positions) { return weldTolerance * boundsOf(positions).diagonal; }

Weld weldByPosition(std::span<const glm::vec3> positions) {
    const Bounds bounds = boundsOf(positions);
    Weld weld;
    const double tolerance = weldTolerance * bounds.diagonal;
    weld.point.resize(positions.size());
    if (bounds.diagonal == 0.0) {
        weld.pointCount = positions.empty() ? 0 : 1;
        return weld;
    }
    CellGrid grid{positions, bounds, tolerance};
    constexpr std::uint32_t ahead = 16;  // cells whose slots are being fetched from memory
    std::array<CellGrid::Cell, ahead> cells;
    const auto count = static_cast<std::uint32_t>(positions.size());
    for (std::uint32_t i = 0; i < std::min(count, ahead); ++i) cells[i] = grid.cellOf(i);
    for (std::uint32_t i = 0; i < count; ++i) {
        const CellGrid::Cell cell = cells[i % ahead];
        if (i + ahead < count) cells[i % ahead] = grid.cellOf(i + ahead);
        weld.point[i] = grid.pointOf(i, cell);
    }
    weld.pointCount = grid.pointCount();
    return weld;
}

}  // namespace inkedge::mesh
