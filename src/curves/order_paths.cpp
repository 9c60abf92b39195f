#include "curves/order_paths.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace inkedge::curves {
namespace {

// An end of a path: 2 index, or 2 index + 1 of where it ends.
using End = std::size_t;

// The ends of paths that are not drawn yet, in square cells, on average of few ends each.
class EndGrid {
public:
    explicit EndGrid(std::span<const PathEnds> paths) : paths_{paths} {
        glm::dvec2 low{std::numeric_limits<double>::infinity()};
        glm::dvec2 high = -low;
        for (const auto& [start, end] : paths) {
            low = glm::min(low, glm::min(start, end));
            high = glm::max(high, glm::max(start, end));
        }
        const double side = std::max(high.x - low.x, high.y - low.y);
        cells_ = std::max(1, static_cast<int>(std::sqrt(static_cast<double>(paths.size()))));
        corner_ = low;
        cellSide_ = side > 0.0 ? side / cells_ : 1.0;
        lists_.resize(static_cast<std::size_t>(cells_) * static_cast<std::size_t>(cells_));
        for (End end = 0; end < 2 * paths.size(); ++end) listAt(cellOf(positionOf(end))).push_back(end);
    }

    [[nodiscard]] glm::dvec2 positionOf(End end) const {
        return end % 2 == 0 ? paths_[end / 2].start : paths_[end / 2].end;
    }

    void remove(std::size_t path) {
        for (const End end : {2 * path, 2 * path + 1}) std::erase(listAt(cellOf(positionOf(end))), end);
    }

    // The end nearest to a position; of several the first. There is one.
    [[nodiscard]] End nearest(glm::dvec2 position) {
        const Cell middle = cellOf(position);
        const glm::dvec2 within = position - corner_;
        const double outside = glm::distance(within, glm::clamp(within, 0.0, cellSide_ * cells_));
        End best = 0;
        double bestDistance = std::numeric_limits<double>::infinity();
        for (int ring = 0; ring < cells_; ++ring) {
            if (bestDistance <= std::max(ring - 1, 0) * cellSide_ - outside) break;
            forEachInRing(middle, ring, [&](End end) {
                const double distance = glm::distance(position, positionOf(end));
                if (distance > bestDistance || (distance == bestDistance && end > best)) return;
                best = end;
                bestDistance = distance;
            });
        }
        return best;
    }

private:
    struct Cell {
        int x;
        int y;
    };

    [[nodiscard]] Cell cellOf(glm::dvec2 position) const {
        const glm::dvec2 cell = glm::clamp((position - corner_) / cellSide_, 0.0, cells_ - 1.0);
        return {static_cast<int>(cell.x), static_cast<int>(cell.y)};
    }

    [[nodiscard]] std::vector<End>& listAt(Cell cell) {
        return lists_[static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(cells_) +
                      static_cast<std::size_t>(cell.x)];
    }

    // The cells whose larger distance from the middle, along x or y, is the ring's number.
    template <class Visit>
    void forEachInRing(Cell middle, int ring, Visit visit) {
        for (int y = std::max(middle.y - ring, 0); y <= std::min(middle.y + ring, cells_ - 1); ++y) {
            const bool whole = std::abs(y - middle.y) == ring;
            for (int x = middle.x - ring; x <= middle.x + ring; x += whole || ring == 0 ? 1 : 2 * ring) {
                if (x < 0 || x >= cells_) continue;
                for (const End end : listAt({x, y})) visit(end);
            }
        }
    }

    std::span<const PathEnds> paths_;
    int cells_ = 1;  // along each axis
    glm::dvec2 corner_{0.0};
    double cellSide_ = 1.0;
    std::vector<std::vector<End>> lists_;
};

class Order {
public:
    Order(std::span<const PathEnds> paths, glm::dvec2 from) : paths_{paths}, from_{from} {
        EndGrid left{paths};
        order_.reserve(paths.size());
        for (std::size_t i = 0; i < paths.size(); ++i) {
            const End end = left.nearest(exitOf(order_.size()));
            order_.push_back({end / 2, end % 2 == 1});
            left.remove(end / 2);
        }
    }

    // Turns a run of paths round wherever that shortens the ways to it and from it, until it does nowhere.
    void exchange() {
        constexpr std::size_t reach = 100;  // of a run: larger ones cost more than they save
        constexpr int maxSweeps = 20;
        bool shortened = true;
        for (int sweep = 0; sweep < maxSweeps && shortened; ++sweep) {
            shortened = false;
            for (std::size_t i = 0; i < order_.size(); ++i)
                for (std::size_t j = i; j < std::min(order_.size(), i + reach); ++j)
                    shortened = turnRound(i, j) || shortened;
        }
    }

    [[nodiscard]] std::vector<OrderedPath> take() && { return std::move(order_); }

private:
    [[nodiscard]] glm::dvec2 entryOf(std::size_t i) const {
        const auto& [index, reversed] = order_[i];
        return reversed ? paths_[index].end : paths_[index].start;
    }

    // Where the pen stands before path i.
    [[nodiscard]] glm::dvec2 exitOf(std::size_t i) const {
        if (i == 0) return from_;
        const auto& [index, reversed] = order_[i - 1];
        return reversed ? paths_[index].start : paths_[index].end;
    }

    // The pen need not come back after the last path.
    [[nodiscard]] double wayTo(std::size_t i, glm::dvec2 from) const {
        return i < order_.size() ? glm::distance(from, entryOf(i)) : 0.0;
    }

    bool turnRound(std::size_t i, std::size_t j) {
        constexpr double rounding = 1e-9;
        const double before = wayTo(i, exitOf(i)) + wayTo(j + 1, exitOf(j + 1));
        const double after = glm::distance(exitOf(i), exitOf(j + 1)) + wayTo(j + 1, entryOf(i));
        if (after >= before - rounding * (1.0 + before)) return false;
        const auto begin = order_.begin() + static_cast<std::ptrdiff_t>(i);
        const auto end = order_.begin() + static_cast<std::ptrdiff_t>(j + 1);
        std::reverse(begin, end);
        std::for_each(begin, end, [](OrderedPath& path) { path.reversed = !path.reversed; });
        return true;
    }

    std::span<const PathEnds> paths_;
    glm::dvec2 from_;
    std::vector<OrderedPath> order_;
};

}  // namespace

std::vector<OrderedPath> orderForTravel(std::span<const PathEnds> paths, glm::dvec2 from) {
    Order order{paths, from};
    order.exchange();
    return std::move(order).take();
}

namespace {

// Lets a closed line begin at the point that lies nearest on the way between two positions.
void beginNear(Line& line, glm::dvec2 before, glm::dvec2 after) {
    const auto way = [&](const LinePoint& p) { return glm::distance(before, p.pixel) + glm::distance(p.pixel, after); };
    std::rotate(line.points.begin(), std::ranges::min_element(line.points, {}, way), line.points.end());
}

}  // namespace

std::vector<Line> inTravelOrder(std::vector<Line> lines, glm::dvec2& pen) {
    std::vector<PathEnds> ends;
    ends.reserve(lines.size());
    for (const Line& line : lines)
        ends.push_back({line.points.front().pixel, (line.closed ? line.points.front() : line.points.back()).pixel});
    const std::vector<OrderedPath> order = orderForTravel(ends, pen);
    std::vector<Line> ordered;
    ordered.reserve(lines.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        Line line = std::move(lines[order[i].index]);
        if (order[i].reversed && !line.closed) std::ranges::reverse(line.points);
        if (line.closed) {
            const bool isLast = i + 1 == order.size();
            const OrderedPath next = order[isLast ? i : i + 1];
            const glm::dvec2 entry = next.reversed ? ends[next.index].end : ends[next.index].start;
            beginNear(line, pen, isLast ? pen : entry);
        }
        pen = (line.closed ? line.points.front() : line.points.back()).pixel;
        ordered.push_back(std::move(line));
    }
    return ordered;
}

}  // namespace inkedge::curves
