#include "ink/strokes_of.h"

#include <algorithm>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "curves/clip.h"
#include "curves/simplify.h"

namespace inkedge::ink {
namespace {

constexpr double paintTolerance = 0.02;  // pixels: at most 5 of 255 levels where a line runs along a pixel's side

// @param way  length along the line to a
Stroke strokeBetween(const StrokePoint& a, const StrokePoint& b, std::uint8_t pen, double way) {
    return {glm::vec2{a.pixel}, glm::vec2{b.pixel}, pen, levelOf(a.width), levelOf(b.width), static_cast<float>(way)};
}

void addSolid(const std::vector<StrokePoint>& points, std::uint8_t pen, std::vector<Stroke>& strokes) {
    double way = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        strokes.push_back(strokeBetween(points[i - 1], points[i], pen, way));
        way += glm::distance(points[i - 1].pixel, points[i].pixel);
    }
}

// Adds dashes along a line, beginning with a whole one.
void addDashes(const std::vector<StrokePoint>& points, std::uint8_t pen, double dash, double gap,
               std::vector<Stroke>& strokes) {
    const double period = dash + gap;
    double begin = 0.0;  // of the edge, as a length along the line
    for (std::size_t i = 1; i < points.size(); ++i) {
        const StrokePoint& a = points[i - 1];
        const StrokePoint& b = points[i];
        const double length = glm::distance(a.pixel, b.pixel);
        const double end = begin + length;
        const auto at = [&](double way) {
            const double share = length > 0.0 ? (way - begin) / length : 0.0;
            return StrokePoint{glm::mix(a.pixel, b.pixel, share), glm::mix(a.width, b.width, share)};
        };
        for (double k = std::floor(begin / period); k * period < end || length == 0.0; ++k) {
            const double from = std::max(begin, k * period);
            const double to = std::min(end, k * period + dash);
            if (from <= to) strokes.push_back(strokeBetween(at(from), at(to), pen, from));
            if (length == 0.0) break;
        }
        begin = end;
    }
}

}  // namespace

StrokeMaker::StrokeMaker(const Lines& lines, const PictureSettings& picture, const LineSettings& settings,
                         double tolerance)
    : picture_{picture},
      settings_{settings},
      tolerance_{tolerance},
      pens_{settings::pens(picture)},
      widths_{lines, picture, settings},
      size_{lines.size.width, lines.size.height} {}

void StrokeMaker::add(const Line& line, std::vector<Stroke>& strokes) const {
    if (!settings::isDrawn(line, picture_, settings_)) return;
    const std::uint8_t pen = settings::penOf(line);
    const double width = pens_[pen].width;
    const double margin = widths_.vary() ? width : 0.5 * width;  // up to twice as wide
    for (const Line& part : curves::clip(line, glm::dvec2{-margin}, size_ + margin)) {
        // What fades does so along straight lines, too.
        const bool fades = settings_.strokeWidth == StrokeWidth::Strength && formLineTypes.contains(line.type);
        std::vector<StrokePoint> points = widths_.along(fades ? part : curves::simplify(part, tolerance_), line);
        for (StrokePoint& point : points) point.width *= line.width;
        if (!line.visible && settings_.hidden == HiddenLines::Dashed) {
            addDashes(points, pen, pens_[pen].dash, pens_[pen].gap, strokes);
        } else {
            addSolid(points, pen, strokes);
        }
    }
}

std::vector<Stroke> strokesOf(const Lines& lines, const PictureSettings& picture, const LineSettings& settings) {
    const StrokeMaker maker{lines, picture, settings, paintTolerance};
    std::vector<Stroke> strokes;
    for (const Line& line : lines.lines) maker.add(line, strokes);
    return strokes;
}

std::vector<Stroke> strokesOf(std::span<const trace::TracedPiece> pieces) {
    std::vector<Stroke> strokes;
    strokes.reserve(pieces.size());
    for (const trace::TracedPiece& piece : pieces) {
        const std::uint8_t width = levelOf(static_cast<double>(piece.width));
        strokes.push_back(
            {piece.ends[0], piece.ends[1], static_cast<std::uint8_t>(bitIndex(piece.type)), width, width, 0.0F});
    }
    return strokes;
}

}  // namespace inkedge::ink
