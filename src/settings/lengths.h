#pragma once

#include <inkedge/settings.h>

namespace inkedge::settings {

inline constexpr double millimetresPerInch = 25.4;

[[nodiscard]] constexpr double pixelsOf(double millimetres, double dpi) noexcept {
    return millimetres / millimetresPerInch * dpi;
}

/// In output pixels.
[[nodiscard]] constexpr double pixelsOf(const PictureLength& length, double dpi) noexcept {
    return length.millimetres ? pixelsOf(length.value, dpi) : length.value;
}

/// Of one unit of a model; LengthUnit::None counts as millimetres.
[[nodiscard]] double millimetresOf(LengthUnit) noexcept;

/// Output pixels that ink may lie beyond the line that it draws: half the widest pen, and what the style adds.
[[nodiscard]] double inkReach(const RenderSettings&);

/// Whether the size of a picture on paper is given: in millimetres, or by a scale.
[[nodiscard]] bool isSizedOnPaper(const FrameSettings&) noexcept;

}  // namespace inkedge::settings
