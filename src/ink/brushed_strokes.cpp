#include "ink/brushed_strokes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace inkedge::ink {
namespace {

// The pixels of some rows that strokes may cover.
PixelBox boxIn(Rows rows, std::span<const BoxedStroke> strokes) {
    PixelBox all = strokes.front().box;
    for (const BoxedStroke& s : strokes) {
        all = {std::min(all.x0, s.box.x0), std::min(all.y0, s.box.y0), std::max(all.x1, s.box.x1),
               std::max(all.y1, s.box.y1)};
    }
    return boxIn(rows, all);
}

}  // namespace

BrushedStrokes::BrushedStrokes(const Brush& brush, std::span<const Stroke> strokes,
                               const std::array<settings::Pen, settings::penCount>& pens, Size rows)
    : strokes_{strokes}, inLine_{linesOf(strokes)}, coverage_{rows, 1}, distance_{rows, 1}, ink_{rows, 1} {
    for (const Stroke& stroke : strokes) {
        auto& fitted = brushes_[stroke.pen];
        if (fitted) continue;
        const double width = pens[stroke.pen].width;
        for (std::size_t other = 0; other < settings::penCount && !fitted; ++other)
            if (brushes_[other] && pens[other].width == width) fitted = brushes_[other];
        if (!fitted) fitted.emplace(brush, width);
    }
}

std::vector<BrushedStrokes::InLine> BrushedStrokes::linesOf(std::span<const Stroke> strokes) {
    std::vector<InLine> lines(strokes.size());
    std::size_t begin = 0;  // of the line
    for (std::size_t end = 1; end <= strokes.size(); ++end) {
        if (end < strokes.size() && strokes[end].arc != 0.0F) continue;
        const std::size_t count = end - begin;
        const Stroke& last = strokes[end - 1];
        const bool closed = last.to == strokes[begin].from;
        const float around = closed ? last.arc + glm::distance(last.from, last.to) : 0.0F;
        for (std::size_t i = 0; i < count; ++i) {
            const Stroke& stroke = strokes[begin + i];
            const Stroke& before = strokes[begin + (i + count - 1) % count];  // of a closed line the last
            const Stroke& after = strokes[begin + (i + 1) % count];
            lines[begin + i] = {static_cast<std::uint32_t>(begin), before.to != stroke.from, after.from != stroke.to,
                                around};
        }
        begin = end;
    }
    return lines;
}

void BrushedStrokes::cover(Image<float>& coverage, Rows rows, std::span<const BoxedStroke> shown,
                           const std::bitset<settings::penCount>& pens) {
    for (std::size_t begin = 0; begin < shown.size();) {
        std::size_t end = begin + 1;
        while (end < shown.size() && lineOf(shown[end]).line == lineOf(shown[begin]).line) ++end;
        if (pens.test(shown[begin].stroke->pen)) coverLine(coverage, rows, shown.subspan(begin, end - begin));
        begin = end;
    }
}

void BrushedStrokes::coverLine(Image<float>& coverage, Rows rows, std::span<const BoxedStroke> strokes) {
    const PixelBox all = boxIn(rows, strokes);
    clear(all, rows);
    for (const BoxedStroke& stroke : strokes) add(stroke, rows);
    for (int y = all.y0 - rows.first; y <= all.y1 - rows.first; ++y) {
        for (int x = all.x0; x <= all.x1; ++x) {
            const float ofLine = coverage_(x, y);
            float& covered = coverage(x, y);
            if (ofLine > 0.0F) covered = std::max(covered, ofLine * ink_(x, y));
        }
    }
}

void BrushedStrokes::clear(PixelBox box, Rows rows) {
    for (int y = box.y0 - rows.first; y <= box.y1 - rows.first; ++y) {
        std::fill(&coverage_(box.x0, y), &coverage_(box.x1, y) + 1, 0.0F);
        std::fill(&distance_(box.x0, y), &distance_(box.x1, y) + 1, std::numeric_limits<float>::infinity());
    }
}

// Adds a stroke to its line.
void BrushedStrokes::add(const BoxedStroke& boxed, Rows rows) {
    const Stroke& stroke = *boxed.stroke;
    const InLine& inLine = lineOf(boxed);
    const FittedBrush& brush = *brushes_[stroke.pen];
    const EndWidths ends = widthsOf(stroke, boxed.width);
    const CentreLine line = measuredInPixels(stroke);
    const float stretch = brush.stretchAround(inLine.around);
    const float reach = reachOf(std::max(ends.from, ends.to));
    forEachNear(line, reach, coverage_, rows, boxed.box, [&](float& covered, int x, int y, const NearPixel& pixel) {
        const float distance = std::sqrt(pixel.distanceSquared);
        const float width = line.end > 0.0F ? glm::mix(ends.from, ends.to, pixel.nearest / line.end) : ends.from;
        covered = std::max(covered, BandShare{pixel.across(line, distance), width}.at(distance));
        float& nearest = distance_(x, y - rows.first);
        if (distance >= nearest) return;
        nearest = distance;
        const float side = glm::dot(pixel.centre, line.normal);
        const bool beyond = (pixel.along < 0.0F && inLine.opensFrom) || (pixel.along > line.end && inLine.opensTo);
        ink_(x, y - rows.first) =
            brush.inkAt(stretch * (stroke.arc + (beyond ? pixel.along : pixel.nearest)),
                        (beyond ? side : std::copysign(distance, side)) / std::max(width, shortestOffset));
    });
}

}  // namespace inkedge::ink
