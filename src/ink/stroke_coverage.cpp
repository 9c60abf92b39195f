#include "ink/stroke_coverage.h"

#include <glm/common.hpp>

namespace inkedge::ink {
namespace {

bool varies(const Stroke& stroke) { return stroke.widthFrom != fullWidth || stroke.widthTo != fullWidth; }

void coverEven(Image<float>& coverage, Rows rows, const BoxedStroke& boxed) {
    const float width = boxed.width;
    const CentreLine line = measuredInShares(*boxed.stroke);
    const BandShare band{line.normal, width};
    forEachNear(line, reachOf(width), coverage, rows, boxed.box, [&](float& covered, int, int, const NearPixel& pixel) {
        if (covered >= 1.0F) return;
        const float distance = std::sqrt(pixel.distanceSquared);
        const bool beside = pixel.isBeside(line, distance);
        covered =
            std::max(covered, beside ? band.at(distance) : BandShare{pixel.offset / distance, width}.at(distance));
    });
}

void coverVarying(Image<float>& coverage, Rows rows, const BoxedStroke& boxed) {
    const EndWidths ends = widthsOf(*boxed.stroke, boxed.width);
    const CentreLine line = measuredInShares(*boxed.stroke);
    const float reach = reachOf(std::max(ends.from, ends.to));
    forEachNear(line, reach, coverage, rows, boxed.box, [&](float& covered, int, int, const NearPixel& pixel) {
        const float distance = std::sqrt(pixel.distanceSquared);
        const float width = glm::mix(ends.from, ends.to, pixel.nearest);
        covered = std::max(covered, BandShare{pixel.across(line, distance), width}.at(distance));
    });
}

}  // namespace

EndWidths widthsOf(const Stroke& stroke, float penWidth) {
    return {penWidth * static_cast<float>(stroke.widthFrom) / fullWidth,
            penWidth * static_cast<float>(stroke.widthTo) / fullWidth};
}

BoxedStroke boxed(const Stroke& stroke, float penWidth, Size picture) {
    const EndWidths ends = widthsOf(stroke, penWidth);
    const float reach = reachOf(std::max(ends.from, ends.to));
    const glm::vec2 low = glm::min(stroke.from, stroke.to) - reach - 0.5F;
    const glm::vec2 high = glm::max(stroke.from, stroke.to) + reach - 0.5F;
    return {&stroke,
            penWidth,
            {std::max(0, static_cast<int>(std::ceil(low.x))), std::max(0, static_cast<int>(std::ceil(low.y))),
             std::min(picture.width - 1, static_cast<int>(std::floor(high.x))),
             std::min(picture.height - 1, static_cast<int>(std::floor(high.y)))}};
}

CentreLine measuredInShares(const Stroke& stroke) {
    const glm::vec2 along = stroke.to - stroke.from;
    const float lengthSquared = glm::dot(along, along);
    if (!(lengthSquared > 0.0F)) return {stroke.from, along, glm::vec2{0.0F}, 1.0F, glm::vec2{1, 0}};
    return {stroke.from, along, along / lengthSquared, 1.0F, glm::vec2{-along.y, along.x} / std::sqrt(lengthSquared)};
}

CentreLine measuredInPixels(const Stroke& stroke) {
    const glm::vec2 along = stroke.to - stroke.from;
    const float length = glm::length(along);
    const glm::vec2 direction = length > 0.0F ? along / length : glm::vec2{1, 0};
    return {stroke.from, direction, direction, length, glm::vec2{-direction.y, direction.x}};
}

void cover(Image<float>& coverage, Rows rows, const BoxedStroke& boxed) {
    (varies(*boxed.stroke) ? coverVarying : coverEven)(coverage, rows, boxed);
}

}  // namespace inkedge::ink
