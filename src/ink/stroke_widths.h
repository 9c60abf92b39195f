#pragma once

#include <optional>
#include <vector>

#include <glm/vec2.hpp>

#include <inkedge/lines.h>
#include <inkedge/settings.h>

#include "ink/free_ends.h"

namespace inkedge {

/// A place on a stroke's centre line, and its width there as a share of its pen's.
struct StrokePoint {
    glm::dvec2 place;
    double width = 1.0;
};

/// Widths that vary along the lines of one view, as LineSettings::strokeWidth and ::strokeTaper ask for.
class StrokeWidths {
public:
    /// Looks at how near and how far the lines lie, and where they end.
    StrokeWidths(const Lines&, const PictureSettings&, const LineSettings&);

    [[nodiscard]] bool vary() const noexcept;

    /// The line's points, of a closed one the first again at the end, and as many between them as the widths need.
    /// Between two the width changes evenly.
    /// @param whole  the line that it is a part of: only free ends of that one taper, not where it was cut
    [[nodiscard]] std::vector<StrokePoint> along(const Line&, const Line& whole) const;

private:
    [[nodiscard]] double nearness(const LinePoint&) const;
    void setByDepth(const Line&, std::vector<StrokePoint>&) const;

    const Camera& camera_;
    StrokeWidth kind_;
    double taper_;
    std::optional<FreeEnds> freeEnds_;  // where lines taper
    double least_ = 0.0;                // nearness of the furthest point, and of the nearest
    double most_ = 0.0;
};

}  // namespace inkedge
