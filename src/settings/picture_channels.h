#pragma once

#include <algorithm>

#include <inkedge/settings.h>

namespace inkedge {

/// Channels of Maps::picture: 1 if the background and every line are grey, 3 (RGB), or 4 (RGBA) on a transparent
/// background.
[[nodiscard]] inline int pictureChannels(const PictureSettings& picture) {
    if (!picture.background) return 4;
    const bool grey = picture.background->grey() && picture.lineColor.grey() &&
                      std::ranges::all_of(picture.lineStyles,
                                          [](const LineStyle& style) { return !style.color || style.color->grey(); });
    return grey ? 1 : 3;
}

}  // namespace inkedge
