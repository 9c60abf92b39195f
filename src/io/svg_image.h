#pragma once

#include <string>

#include <inkedge/image.h>

namespace inkedge::io {

/// A picture as an element <image> of SVG, with a PNG in it, a pixel of the picture wide a unit: for documents that
/// know the prefix xlink, because most readers do not know href alone.
/// @param picture     1, 3 or 4 channels
/// @param attributes  more of them, each with a blank before it
[[nodiscard]] std::string svgImage(const Image<std::uint8_t>& picture, const std::string& attributes);

}  // namespace inkedge::io
