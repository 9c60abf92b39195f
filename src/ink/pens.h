#pragma once

#include <array>
#include <cstdint>

#include <inkedge/lines.h>
#include <inkedge/settings.h>

namespace inkedge {

/// Width in output pixels and colour of one kind of stroke.
struct Pen {
    double width;
    Color color;
};

/// One pen for each line type where it is seen, in the order of LineType's bits, then one for each where it is hidden.
inline constexpr int penCount = 2 * lineTypeCount;

/// Hidden lines are drawn with half the width of seen ones: ISO 128's narrow and wide lines.
inline constexpr double hiddenWidth = 0.5;

/// Pens with the overrides of PictureSettings::pens applied.
[[nodiscard]] std::array<Pen, penCount> pens(const PictureSettings&);

/// Which of pens() draws a line.
[[nodiscard]] std::uint8_t penOf(const Line&) noexcept;

/// A dashed line: strokes with round caps whose centre lines have the length dash, gap apart; in widths of the pen. The
/// caps make a dash longer by one width.
inline constexpr double dashLength = 6.0;
inline constexpr double gapLength = 4.0;

/// Whether a line is drawn at all: its type is, and it is seen or hidden lines are drawn.
[[nodiscard]] bool isDrawn(const Line&, const PictureSettings&, const LineSettings&) noexcept;

}  // namespace inkedge
