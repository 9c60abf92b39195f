#include "lines/lengths.h"

#include <glm/geometric.hpp>

namespace inkedge::lines {

LineLengths lengthsOf(std::span<const Line> lines) {
    LineLengths lengths{};
    for (const Line& line : lines) {
        if (!line.visible || line.points.empty()) continue;
        double length = line.closed ? glm::distance(line.points.back().pixel, line.points.front().pixel) : 0.0;
        for (std::size_t i = 1; i < line.points.size(); ++i)
            length += glm::distance(line.points[i - 1].pixel, line.points[i].pixel);
        lengths[static_cast<std::size_t>(bitIndex(line.type))] += length;
    }
    return lengths;
}

}  // namespace inkedge::lines
