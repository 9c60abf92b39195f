#pragma once

#include <inkedge/settings.h>
#include <inkedge/sheet.h>

namespace inkedge::sheet {

/// The settings' pens, those that are not given by ISO 128-20: wide and narrow lines of the page's group. What is
/// finer than the common width by default is narrow, and so are hidden lines, whose dashes are 12 widths long, 3 apart.
[[nodiscard]] PictureSettings sheetPens(PictureSettings, const SheetPage&);

}  // namespace inkedge::sheet
