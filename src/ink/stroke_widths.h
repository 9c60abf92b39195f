#pragma once

#include <optional>
#include <vector>

#include <glm/vec2.hpp>

#include <inkedge/lines.h>
#include <inkedge/settings.h>

#include "ink/free_ends.h"

namespace inkedge::ink {

/// A point of a stroke's centre line, and the width there as a share of the pen's width.
struct StrokePoint {
    glm::dvec2 pixel;  ///< as LinePoint::pixel
    double width = 1.0;
};

/// Widths that vary along the lines of one view, as LineSettings::strokeWidth and ::strokeTaper ask for.
class StrokeWidths {
public:
    /// Finds the range of the lines' depths and their free ends, as far as the settings need them.
    StrokeWidths(const Lines&, const PictureSettings&, const LineSettings&);

    [[nodiscard]] bool vary() const noexcept;

    /// The points of a line, of a closed line the first again at the end, with as many between them as the widths need.
    /// Between two points the width changes evenly.
    /// @param whole  the line of which the line is a part: its free ends taper, not the ends where it was cut
    [[nodiscard]] std::vector<StrokePoint> along(const Line&, const Line& whole) const;

private:
    // 1 / depth, or -depth in an orthographic view: linear along straight lines of the picture.
    [[nodiscard]] double inverseDepth(const LinePoint&) const;
    void setByDepth(const Line&, std::vector<StrokePoint>&) const;

    const Camera& camera_;
    StrokeWidth kind_;
    double taper_;
    std::optional<FreeEnds> freeEnds_;  // where lines taper
    double furthest_ = 0.0;             // the inverse depth of the furthest point
    double nearest_ = 0.0;              // and that of the nearest
};

}  // namespace inkedge::ink
