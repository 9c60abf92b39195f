#include "sheet/symbol.h"

#include <glm/geometric.hpp>

namespace inkedge::sheet {
namespace {

// A centre line: long dashes with short ones between them, a long one at both ends.
void centreLine(Ink& ink, glm::dvec2 from, glm::dvec2 to, double unit, double width) {
    const double length = glm::distance(from, to);
    const glm::dvec2 along = (to - from) / length;
    const double gap = 0.3 * unit;
    const double mark = 0.15 * unit;
    const double dash = 0.5 * (length - 2.0 * gap - mark);
    ink.line(from, from + dash * along, width);
    ink.line(from + (dash + gap) * along, from + (dash + gap + mark) * along, width);
    ink.line(to - dash * along, to, width);
}

}  // namespace

void drawSymbol(Ink& ink, Projection projection, glm::dvec2 middle, double height) {
    const double wide = lineWidthOf(height);
    const double narrow = 0.5 * wide;
    const double apart = 1.5 * height;  // of the middles of cone and circles from the symbol's
    const double side = projection == Projection::First ? -1.0 : 1.0;  // of the cone
    const glm::dvec2 cone = middle + glm::dvec2{side * apart, 0.0};
    const glm::dvec2 circles = middle - glm::dvec2{side * apart, 0.0};
    // The narrow end is on the left: from there it hides nothing of the wide one. The view from the left lies on the
    // right in first-angle projection, on the left in third-angle projection.
    const glm::dvec2 a = cone + height * glm::dvec2{-1.0, -0.5};
    const glm::dvec2 b = cone + height * glm::dvec2{1.0, -1.0};
    const glm::dvec2 c = cone + height * glm::dvec2{1.0, 1.0};
    const glm::dvec2 d = cone + height * glm::dvec2{-1.0, 0.5};
    ink.line(a, b, wide);
    ink.line(b, c, wide);
    ink.line(c, d, wide);
    ink.line(d, a, wide);
    ink.circle(circles, 0.5 * height, wide);
    ink.circle(circles, height, wide);
    const double reach = 1.25 * height;
    centreLine(ink, cone - glm::dvec2{reach, 0.0}, cone + glm::dvec2{reach, 0.0}, height, narrow);
    centreLine(ink, circles - glm::dvec2{reach, 0.0}, circles + glm::dvec2{reach, 0.0}, height, narrow);
    centreLine(ink, circles - glm::dvec2{0.0, reach}, circles + glm::dvec2{0.0, reach}, height, narrow);
}

}  // namespace inkedge::sheet
