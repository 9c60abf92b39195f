#include "ink/strokes_of.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "curves/clip.h"
#include "curves/simplify.h"

namespace inkedge {
namespace {

constexpr double tolerance = 0.02;  // pixels: 5 of 255 at most where a line runs along a pixel's side

using Places = std::vector<glm::dvec2>;

Places placesOf(const Line& line) {
    Places places;
    for (const LinePoint& p : simplify(line, tolerance).points) places.push_back(p.place);
    if (line.closed && !places.empty()) places.push_back(places.front());
    return places;
}

void addSolid(const Places& places, std::uint8_t style, std::vector<Stroke>& strokes) {
    for (std::size_t i = 1; i < places.size(); ++i) {
        strokes.push_back({glm::vec2{places[i - 1]}, glm::vec2{places[i]}, style});
    }
}

// Dashes along the way, beginning with a whole one.
void addDashes(const Places& places, std::uint8_t style, double width, std::vector<Stroke>& strokes) {
    const double period = (dashLength + gapLength) * width;
    const double dash = dashLength * width;
    double begin = 0.0;  // of the edge, along the way
    for (std::size_t i = 1; i < places.size(); ++i) {
        const double length = glm::distance(places[i - 1], places[i]);
        const double end = begin + length;
        const auto at = [&](double way) {
            return glm::vec2{glm::mix(places[i - 1], places[i], length > 0.0 ? (way - begin) / length : 0.0)};
        };
        for (double k = std::floor(begin / period); k * period < end || length == 0.0; ++k) {
            const double from = std::max(begin, k * period);
            const double to = std::min(end, k * period + dash);
            if (from <= to) strokes.push_back({at(from), at(to), style});
            if (length == 0.0) break;
        }
        begin = end;
    }
}

}  // namespace

std::vector<Stroke> strokesOf(const Lines& lines, const PictureSettings& picture, const LineSettings& settings) {
    const auto allPens = pens(picture);
    const glm::dvec2 size{lines.size.width, lines.size.height};
    std::vector<Stroke> strokes;
    for (const Line& line : lines.lines) {
        if (!isDrawn(line, picture, settings)) continue;
        const std::uint8_t pen = penOf(line);
        const double width = allPens[pen].width;
        for (const Line& part : clip(line, glm::dvec2{-0.5 * width}, size + 0.5 * width)) {
            if (!line.visible && settings.hidden == HiddenLines::Dashed) {
                addDashes(placesOf(part), pen, width, strokes);
            } else {
                addSolid(placesOf(part), pen, strokes);
            }
        }
    }
    return strokes;
}

}  // namespace inkedge
