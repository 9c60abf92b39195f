#pragma once

#include <inkedge/settings.h>

#include "passes/edge_marks.h"
#include "settings/picture_channels.h"

namespace inkedge::passes {

/// The outline picture: the line colour where a mark is not 0, the background elsewhere (Hertzmann 1999, section 2.2,
/// first sentence). Runs on the CPU: of the marks there are 2 bits a pixel to read back, of the picture 8 to 32. CPU
/// definition: reference::composite(), which it equals.
/// @return  1, 3 or 4 channels, as Maps::picture
[[nodiscard]] Image<std::uint8_t> composite(const EdgeMarks&, const PictureSettings&,
                                            settings::Paper = settings::Paper::Background);

}  // namespace inkedge::passes
