#pragma once

#include <vector>

#include <inkedge/image.h>

namespace inkedge::diff {

/// How much of each pixel is line: 0 to 1, where 1 is as dark on its surroundings, or as light, as the strongest lines.
/// One channel, of the picture's size; empty where nothing stands out.
/// @param picture  as comparedLines() takes it
[[nodiscard]] Image<float> inkOfPicture(const Image<float>& picture);

}  // namespace inkedge::diff
