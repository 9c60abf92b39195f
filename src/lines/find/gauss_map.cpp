#include "lines/find/gauss_map.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace inkedge::lines {
namespace {

constexpr std::uint32_t deepest = 12;      // level: cells of a fiftieth of a degree
constexpr std::size_t worthDividing = 16;  // arcs in a cell
constexpr unsigned levelBits = 4;
constexpr unsigned mortonBits = 2 * deepest;

std::uint32_t mortonOf(std::uint32_t x, std::uint32_t y) {
    std::uint32_t morton = 0;
    for (std::uint32_t bit = 0; bit < deepest; ++bit)
        morton |= ((x >> bit) & 1U) << (2 * bit) | ((y >> bit) & 1U) << (2 * bit + 1);
    return morton;
}

double halfSide(std::uint32_t level) { return 1.0 / (1U << level); }
double centreOf(std::uint32_t index, std::uint32_t level) { return (2.0 * index + 1.0) * halfSide(level) - 1.0; }

// The key of the smallest cell that holds an arc; none if no cell holds it. Keys order cells before their descendants.
std::optional<std::uint32_t> cellKey(glm::dvec3 a, glm::dvec3 b) {
    const glm::dvec3 middle = a + b;
    const glm::dvec3 size = glm::abs(middle);
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const double sign = middle[axis] < 0.0 ? -1.0 : 1.0;
    if (sign * a[axis] <= 0.0 || sign * b[axis] <= 0.0) return std::nullopt;
    const auto onSide = [&](glm::dvec3 n) {
        return glm::dvec2{n[(axis + 1) % 3], n[(axis + 2) % 3]} / (sign * n[axis]);
    };
    const glm::dvec2 low = glm::min(onSide(a), onSide(b));
    const glm::dvec2 high = glm::max(onSide(a), onSide(b));
    const double reach = std::max(high.x - low.x, high.y - low.y);
    std::uint32_t level = deepest;
    while (level > 0 && 2.0 * halfSide(level) < reach) --level;
    for (;; --level) {
        const auto indexOf = [&](double at) {
            const double index = std::floor((at + 1.0) / (2.0 * halfSide(level)));
            return static_cast<std::uint32_t>(std::clamp(index, 0.0, static_cast<double>((1U << level) - 1)));
        };
        const glm::dvec2 at = 0.5 * (low + high);
        const std::uint32_t x = indexOf(at.x);
        const std::uint32_t y = indexOf(at.y);
        const glm::dvec2 centre{centreOf(x, level), centreOf(y, level)};
        const glm::dvec2 beyond = glm::max(high - centre, centre - low);
        if (std::max(beyond.x, beyond.y) <= 2.0 * halfSide(level)) {
            const std::uint32_t side = 2 * static_cast<std::uint32_t>(axis) + (sign < 0.0 ? 1 : 0);
            const unsigned up = deepest - level;
            return (side << mortonBits | mortonOf(x << up, y << up)) << levelBits | level;
        }
        if (level == 0) return std::nullopt;
    }
}

std::uint32_t keyOf(std::uint64_t arc) { return static_cast<std::uint32_t>(arc >> 32U); }
std::uint32_t levelOf(std::uint64_t arc) { return keyOf(arc) & ((1U << levelBits) - 1); }
std::uint32_t squareOf(std::uint64_t arc) { return keyOf(arc) >> levelBits; }

}  // namespace

GaussMap::GaussMap(const MeshEdges& edges) {
    const MeshEdges::Shared& shared = edges.shared;
    for (const float sine : edges.edgeOnSines) largestSine_ = std::max(largestSine_, double{sine});
    std::vector<std::uint64_t> arcs;  // key, edge
    for (std::uint32_t e = 0; e < shared.halfEdges.size(); ++e) {
        const glm::dvec3 a = edges.faceNormals[shared.faces[2 * e]];
        const glm::dvec3 b = edges.faceNormals[shared.faces[2 * e + 1]];
        const bool against = shared.against[e] != 0;
        const bool alike = edges.edgeOnSines[shared.faces[2 * e]] == edges.edgeOnSines[shared.faces[2 * e + 1]];
        if (a == b && !against && alike) continue;
        const auto key = cellKey(a, against ? -b : b);
        if (key) {
            arcs.push_back(std::uint64_t{*key} << 32U | e);
        } else {
            edges_.push_back(e);
        }
    }
    largeEnd_ = edges_.size();
    std::ranges::sort(arcs);
    edges_.reserve(largeEnd_ + arcs.size());
    for (const std::uint64_t arc : arcs) edges_.push_back(static_cast<std::uint32_t>(arc));
    std::size_t begin = 0;
    for (std::uint32_t side = 0; side < 6; ++side) {
        const auto end = static_cast<std::size_t>(
            std::ranges::lower_bound(arcs, (side + 1) << mortonBits, {}, squareOf) - arcs.begin());
        if (begin < end) addCell(arcs, begin, end, {side, 0, 0, 0});
        begin = end;
    }
    cells_.shrink_to_fit();
}

void GaussMap::addCell(const std::vector<std::uint64_t>& arcs, std::size_t begin, std::size_t end, Square square) {
    const std::size_t cell = cells_.size();
    std::size_t ownEnd = begin;
    if (end - begin <= worthDividing || square.level == deepest) {
        ownEnd = end;
    } else {
        while (ownEnd < end && levelOf(arcs[ownEnd]) == square.level) ++ownEnd;
    }
    const auto index = [&](std::size_t arc) { return static_cast<std::uint32_t>(largeEnd_ + arc); };
    cells_.push_back({static_cast<float>(centreOf(square.x, square.level)),
                      static_cast<float>(centreOf(square.y, square.level)),
                      static_cast<float>(2.0 * halfSide(square.level)), index(begin), index(ownEnd), 0, square.side});
    for (std::uint32_t k = 0; k < 4 && ownEnd < end; ++k) {
        const std::uint32_t level = square.level + 1;
        const Square below{square.side, level, 2 * square.x + (k & 1U), 2 * square.y + (k >> 1U)};
        const unsigned up = deepest - level;
        const std::uint32_t last =
            square.side << mortonBits | (mortonOf(below.x << up, below.y << up) + ((1U << (2 * up)) - 1));
        std::size_t belowEnd = ownEnd;
        const auto from = arcs.begin() + static_cast<std::ptrdiff_t>(ownEnd);
        const auto to = arcs.begin() + static_cast<std::ptrdiff_t>(end);
        belowEnd += static_cast<std::size_t>(std::ranges::upper_bound(from, to, last, {}, squareOf) - from);
        if (ownEnd < belowEnd) addCell(arcs, ownEnd, belowEnd, below);
        ownEnd = belowEnd;
    }
    cells_[cell].after = static_cast<std::uint32_t>(cells_.size());
}

void GaussMap::findNear(glm::dvec3 direction, std::vector<std::uint32_t>& to) const {
    const auto add = [&](std::size_t begin, std::size_t end) {
        to.insert(to.end(), edges_.begin() + static_cast<std::ptrdiff_t>(begin),
                  edges_.begin() + static_cast<std::ptrdiff_t>(end));
    };
    add(0, largeEnd_);
    // Far more than the rounding of a dot product, and faces seen edge-on; the cube reaches to the root of 3.
    const double slack = (1e-9 + 2.0 * largestSine_) * glm::length(direction);
    for (std::size_t c = 0; c < cells_.size();) {
        const Cell& cell = cells_[c];
        const std::uint32_t axis = cell.side / 2;
        const double u = direction[static_cast<int>((axis + 1) % 3)];
        const double v = direction[static_cast<int>((axis + 2) % 3)];
        const double w = (cell.side % 2 == 0 ? 1.0 : -1.0) * direction[static_cast<int>(axis)];
        // The great circle misses the cell if the cell's four corners are on one side.
        const double centre = w + u * double{cell.u} + v * double{cell.v};
        const double reach = double{cell.half} * (std::abs(u) + std::abs(v));
        if (std::abs(centre) > reach + slack) {
            c = cell.after;
            continue;
        }
        add(cell.begin, cell.end);
        ++c;
    }
}

std::size_t GaussMap::bytes() const noexcept {
    return cells_.capacity() * sizeof(Cell) + edges_.capacity() * sizeof(std::uint32_t);
}

}  // namespace inkedge::lines
