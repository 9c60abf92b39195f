#pragma once

#include <array>
#include <cstdint>

#include <inkedge/lines.h>
#include <inkedge/settings.h>

namespace inkedge::settings {

/// How strokes are drawn. Lengths are output pixels.
struct Pen {
    double width;
    Color color;
    double dash = 0.0;  ///< of hidden lines, where they are dashed: the length of a dash's centre line
    double gap = 0.0;   ///< between two dashes
};

/// One pen for the visible lines of each type, in the order of LineType's bits, then one for the hidden lines of each.
inline constexpr int penCount = 2 * lineTypeCount;

/// Hidden lines are half as wide as visible ones: ISO 128's narrow and wide lines.
inline constexpr double hiddenWidth = 0.5;

/// Lines of form are narrower than the edges beside which they are drawn.
inline constexpr double formWidth = 0.6;

/// Where faces go on into each other lines are narrow beside wide edges: ISO 128.
inline constexpr double tangentWidth = 0.5;

/// All pens: the line width and colour of the settings, with the overrides of PictureSettings::pens and ::hiddenPen.
[[nodiscard]] std::array<Pen, penCount> pens(const PictureSettings&);

/// The index into pens() of a line's pen.
[[nodiscard]] std::uint8_t penOf(const Line&) noexcept;

/// Dashes where nothing else is said, in widths of the pen. The round caps make a dash longer by one width.
inline constexpr double dashLength = 6.0;
inline constexpr double gapLength = 4.0;

/// Whether a line is drawn: its type is drawn, and it is visible or hidden lines are drawn.
[[nodiscard]] bool isDrawn(const Line&, const PictureSettings&, const LineSettings&) noexcept;

}  // namespace inkedge::settings
