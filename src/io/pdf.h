#pragma once

#include <cstdint>
#include <vector>

#include "io/drawing.h"

namespace inkedge::io {

/// A drawing as a PDF of one page, without a date.
/// @throws Error  (Kind::Output) if the module of vector formats cannot be opened, or Cairo fails
[[nodiscard]] std::vector<std::uint8_t> pdfOf(const Drawing&);

/// A drawing as a picture of RGB, of the page's shape.
/// @throws Error  as pdfOf()
[[nodiscard]] Image<std::uint8_t> pictureOf(const Drawing&, Size);

}  // namespace inkedge::io
