#pragma once

#include <array>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include <inkedge/lines.h>
#include <inkedge/settings.h>

#include "ink/stroke.h"
#include "ink/stroke_widths.h"
#include "settings/pens.h"
#include "trace/traced_piece.h"

namespace inkedge::ink {

/// Makes strokes of the lines of one view. The lines must outlive this.
class StrokeMaker {
public:
    /// @param tolerance  pixels by which strokes may deviate from lines
    StrokeMaker(const Lines&, const PictureSettings&, const LineSettings&, double tolerance);

    /// Adds the strokes of a line; none if the line is not drawn.
    void add(const Line&, std::vector<Stroke>&) const;

private:
    const PictureSettings& picture_;
    const LineSettings& settings_;
    double tolerance_;
    std::array<settings::Pen, settings::penCount> pens_;
    StrokeWidths widths_;
    glm::dvec2 size_;
};

/// Lines as strokes of pens(), so that paintStrokes() draws the same as linesSvg(): the types of settings.lines, hidden
/// lines dashed, solid or not at all; the last point of a closed line is joined to its first. Lines are cut half a
/// width beyond the edges of the picture, and simplified by less than can be seen.
[[nodiscard]] std::vector<Stroke> strokesOf(const Lines&, const PictureSettings&, const LineSettings&);

/// Pieces as strokes, one each: the short way, for pictures. By way of joinPieces() a whole PNG of the gear takes about
/// 5 % longer, one of the torus knot 1 %, and 0.7 % of the gear's pixels change, for lines are simplified.
[[nodiscard]] std::vector<Stroke> strokesOf(std::span<const trace::TracedPiece>);

}  // namespace inkedge::ink
