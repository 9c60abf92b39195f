#include "trace/join_cells.h"

#include <algorithm>
#include <iterator>

#include <glm/geometric.hpp>

namespace inkedge::trace {

DrawnTypes drawnTypes(const PictureSettings& settings) {
    DrawnTypes types{settings.lines, {}};
    for (std::size_t i = 0; i < settings.pens.size(); ++i) {
        if (settings.pens[i] != PenSettings{}) types.withPens |= static_cast<LineType>(1U << i);
    }
    return types;
}

LineType drawnType(LineTypes types, DrawnTypes which) {
    const LineTypes drawn = types & which.drawn;
    const LineTypes withPens = drawn & which.withPens;
    return (withPens.empty() ? drawn : withPens).first();
}

CellJoiner::CellJoiner(DrawnTypes types, int samplesPerPixel, const raster::Tile& tile,
                       std::vector<TracedPiece>& pieces)
    : types_{types}, scale_{1.0F / static_cast<float>(samplesPerPixel)}, tile_{tile}, pieces_{pieces} {}

void CellJoiner::join(int y, const CrossingRow& above, const CrossingRow& below) {
    const raster::Rectangle kept = tile_.keptInDrawn();
    const int end = std::min(kept.x + kept.size.width, tile_.drawn.size.width - 1);
    findCells(above.columns, below.columns);
    for (const int x : cells_) {
        if (x < kept.x || x >= end) continue;
        const auto column = static_cast<std::size_t>(x);
        const auto drawn = [&](std::span<const StepCrossing*, 4> sides) {
            const auto drawnEnd = std::remove_if(
                sides.begin(), sides.end(), [&](const StepCrossing* c) { return (c->types & types_.drawn).empty(); });
            return std::span<const StepCrossing*>{sides.begin(), drawnEnd};
        };
        const StepCrossing* sides[4]{&above.right[column], &below.right[column], &above.down[column],
                                     &above.down[column + 1]};
        const StepCrossing* strips[4]{&above.rightStrips[column], &below.rightStrips[column], &above.downStrips[column],
                                      &above.downStrips[column + 1]};
        const std::span<const StepCrossing*> lines = drawn(sides);
        joinCell(joinStrips(drawn(strips), lines, x + tile_.drawn.x, y), x + tile_.drawn.x, y);
    }
}

// The cells that crossings lie on, counted by their left column in the tile; -1 and the last column among them.
void CellJoiner::findCells(const std::vector<int>& above, const std::vector<int>& below) {
    upper_.clear();
    for (const int column : above) {
        if (upper_.empty() || upper_.back() < column - 1) upper_.push_back(column - 1);
        upper_.push_back(column);
    }
    cells_.clear();
    std::ranges::set_union(upper_, below, std::back_inserter(cells_));
}

void CellJoiner::add(glm::vec2 from, glm::vec2 to, const StepCrossing& crossing, float inverseDepthTo) {
    pieces_.push_back({{from * scale_, to * scale_},
                       {crossing.inverseDepth, inverseDepthTo},
                       typeOf(crossing),
                       crossing.face,
                       crossing.width});
}

void CellJoiner::addBetween(const StepCrossing& a, const StepCrossing& b, int x, int y) {
    add(toBorder(a, b, x, y), toBorder(b, a, x, y), a, b.inverseDepth);
}

// Where a strip has become as wide as a sample its crease goes on as any other.
std::span<const StepCrossing*> CellJoiner::joinStrips(std::span<const StepCrossing*> strips,
                                                      std::span<const StepCrossing*> lines, int x, int y) {
    if (strips.size() == 2) addBetween(*strips[0], *strips[1], x, y);
    if (strips.size() != 1) return lines;
    const auto isCrease = [](const StepCrossing* c) { return c->types == LineType::Crease; };
    const auto crease = std::ranges::find_if(lines, isCrease);
    if (crease == lines.end()) return lines;
    addBetween(*strips[0], **crease, x, y);
    std::rotate(crease, crease + 1, lines.end());
    return lines.first(lines.size() - 1);
}

void CellJoiner::joinCell(std::span<const StepCrossing*> crossings, int x, int y) {
    if (crossings.empty()) return;
    if (crossings.size() == 2 && typeOf(*crossings[0]) == typeOf(*crossings[1])) {
        addBetween(*crossings[0], *crossings[1], x, y);
        return;
    }
    glm::vec2 centre{0.0F};
    for (const StepCrossing* c : crossings) centre += c->position / static_cast<float>(crossings.size());
    for (const StepCrossing* c : crossings) add(c->position, centre, *c, c->inverseDepth);
}

// The end of a piece, carried on beyond the picture's edge if its cell is the last before it.
glm::vec2 CellJoiner::toBorder(const StepCrossing& end, const StepCrossing& other, int x, int y) const {
    constexpr float longestReach = 2.0F;  // of the piece's length: lines along the edge never reach it
    constexpr float farBeyond = 17.0F;    // pixels: half the widest stroke, and its cap's edge
    const glm::vec2 along = end.position - other.position;
    const auto beyond = [&](float position, float step, float border) {
        const float further = step != 0.0F ? (border - position) / step : -1.0F;
        if (further < 0.0F) return end.position;
        // The stroke's far side leaves the picture after its centre line.
        const glm::vec2 overshoot =
            further < longestReach ? farBeyond / scale_ * glm::normalize(along) : glm::vec2{0.0F};
        return end.position + std::min(further, longestReach) * along + overshoot;
    };
    const auto width = static_cast<float>(tile_.whole.width);
    const auto height = static_cast<float>(tile_.whole.height);
    const glm::vec2 at = end.position;
    if (y == 0 && at.y == 0.5F) return beyond(at.y, along.y, 0.0F);
    if (x == 0 && at.x == 0.5F) return beyond(at.x, along.x, 0.0F);
    if (y + 2 == tile_.whole.height && at.y == height - 0.5F) return beyond(at.y, along.y, height);
    if (x + 2 == tile_.whole.width && at.x == width - 0.5F) return beyond(at.x, along.x, width);
    return at;
}

}  // namespace inkedge::trace
