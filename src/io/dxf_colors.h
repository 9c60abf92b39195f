#pragma once

#include <inkedge/settings.h>

namespace inkedge::io {

/// The nearest of DXF's 255 colours. Black and white are 7, which readers draw as what is not their background.
[[nodiscard]] int dxfColor(Color) noexcept;

/// The nearest width of lines that DXF knows, in hundredths of a millimetre.
[[nodiscard]] int dxfLineWidth(double millimetres) noexcept;

}  // namespace inkedge::io
