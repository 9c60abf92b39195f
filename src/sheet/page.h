#pragma once

#include <string>

#include <inkedge/sheet.h>

#include "sheet/rect.h"

namespace inkedge::sheet {

/// Of a page, millimetres; the longer side first if it lies.
[[nodiscard]] glm::dvec2 sizeOf(const SheetPage&) noexcept;

/// "A3", or "A4-landscape" where it does not stand as it does by default.
[[nodiscard]] std::string nameOf(const SheetPage&);

/// A4 stands, the larger ones lie.
[[nodiscard]] SheetPage pageOfSeries(int series) noexcept;

/// What the frame encloses: 20 mm from the left edge, to be bound, 10 mm from the others. ISO 5457.
[[nodiscard]] Rect framed(const SheetPage&) noexcept;

/// The title block, in the lower right corner of the frame.
[[nodiscard]] Rect titleBlock(const SheetPage&) noexcept;

/// The width of visible lines, millimetres, which half is the width of others: ISO 128-20, 0.7 mm from A1 on.
[[nodiscard]] double wideLine(const SheetPage&) noexcept;

}  // namespace inkedge::sheet
