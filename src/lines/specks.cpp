#include "lines/specks.h"

#include <glm/geometric.hpp>

namespace inkedge::lines {
namespace {

bool isSpeck(const Line& line) {
    double length = line.closed ? glm::distance(line.points.back().pixel, line.points.front().pixel) : 0.0;
    for (std::size_t i = 0; i + 1 < line.points.size() && length < minLineLength; ++i)
        length += glm::distance(line.points[i].pixel, line.points[i + 1].pixel);
    return length < minLineLength;
}

}  // namespace

void leaveOutSpecks(std::vector<Line>& lines) { std::erase_if(lines, isSpeck); }

}  // namespace inkedge::lines
