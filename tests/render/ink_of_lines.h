#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <inkedge/lines.h>

/// What lines of two sources have in common.
namespace inkedge::render::ink_of_lines {

inline constexpr Size square{360, 360};
inline constexpr double apart = 2.0;  // pixels: a line of one source and its line of the other are no farther apart

struct Ink {
    glm::dvec2 pixel;
    double length;  // pixels of line that it stands for
    LineType type;
    std::uint32_t object;
    std::size_t line;  // its number
    double way;        // pixels along the line
};

inline std::vector<Ink> inkOf(const Lines& lines) {
    constexpr double step = 0.5;
    std::vector<Ink> ink;
    for (std::size_t l = 0; l < lines.lines.size(); ++l) {
        const Line& line = lines.lines[l];
        if (!line.visible) continue;
        double way = 0.0;
        const std::size_t pieces = line.points.size() - (line.closed ? 0 : 1);
        for (std::size_t i = 0; i < pieces; ++i) {
            const glm::dvec2 a = line.points[i].pixel;
            const glm::dvec2 b = line.points[(i + 1) % line.points.size()].pixel;
            const double length = glm::distance(a, b);
            const int count = std::max(1, static_cast<int>(std::ceil(length / step)));
            for (int k = 0; k < count; ++k, way += length / count)
                ink.push_back({glm::mix(a, b, (k + 0.5) / count), length / count, line.type, line.object, l, way});
        }
    }
    return ink;
}

/// Ink by the cells of a grid.
class InkGrid {
public:
    explicit InkGrid(const std::vector<Ink>& ink) : cells_(static_cast<std::size_t>(side * side)) {
        for (const Ink& dot : ink) cells_[cellAt(dot.pixel, 0, 0)].push_back(dot.pixel);
    }
    [[nodiscard]] bool isNear(glm::dvec2 pixel) const {
        for (int y = -1; y <= 1; ++y)
            for (int x = -1; x <= 1; ++x)
                for (const glm::dvec2 other : cells_[cellAt(pixel, x, y)])
                    if (glm::distance(pixel, other) <= apart) return true;
        return false;
    }

private:
    static constexpr int margin = 32;
    static constexpr int side = square.width / static_cast<int>(apart) + 2 * margin;
    static std::size_t cellAt(glm::dvec2 pixel, int right, int down) {
        const auto index = [](double at, int step) {
            return std::clamp(static_cast<int>(std::floor(at / apart)) + margin + step, 0, side - 1);
        };
        return static_cast<std::size_t>(index(pixel.y, down) * side + index(pixel.x, right));
    }
    std::vector<std::vector<glm::dvec2>> cells_;
};

/// Pixels of line that have no ink of the others near them.
inline double alone(const std::vector<Ink>& ink, const std::vector<const std::vector<Ink>*>& others) {
    std::vector<InkGrid> grids;
    for (const std::vector<Ink>* other : others) grids.emplace_back(*other);
    double sum = 0.0;
    for (const Ink& dot : ink) {
        const bool near = std::ranges::any_of(grids, [&](const InkGrid& grid) { return grid.isNear(dot.pixel); });
        if (!near) sum += dot.length;
    }
    return sum;
}

}  // namespace inkedge::render::ink_of_lines
