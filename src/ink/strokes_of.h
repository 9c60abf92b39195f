#pragma once

#include <array>
#include <vector>

#include <glm/vec2.hpp>

#include <inkedge/lines.h>
#include <inkedge/settings.h>

#include "ink/pens.h"
#include "ink/stroke.h"
#include "ink/stroke_widths.h"

namespace inkedge {

/// Makes strokes of the lines of one view, which must outlive it.
class StrokeMaker {
public:
    /// @param tolerance  pixels by which strokes may stray from lines
    StrokeMaker(const Lines&, const PictureSettings&, const LineSettings&, double tolerance);

    /// Adds a line's strokes: none if it is not drawn.
    void add(const Line&, std::vector<Stroke>&) const;

private:
    const PictureSettings& picture_;
    const LineSettings& settings_;
    double tolerance_;
    std::array<Pen, penCount> pens_;
    StrokeWidths widths_;
    glm::dvec2 size_;
};

/// Lines as strokes of pens(), so that paintStrokes() draws what linesSvg() does: the types of settings.lines, hidden
/// lines dashed, solid or not at all; a closed line's last point joins its first. Lines are cut half a width beyond the
/// edges of the picture, and simplified by less than paint shows.
[[nodiscard]] std::vector<Stroke> strokesOf(const Lines&, const PictureSettings&, const LineSettings&);

}  // namespace inkedge
