#pragma once

#include <algorithm>
#include <optional>

#include <inkedge/settings.h>

namespace inkedge::settings {

/// What a picture is painted on.
enum class Paper {
    Background,   ///< PictureSettings::background, which may be none
    Transparent,  ///< nothing, whatever the settings say: for a drawing that is worked on further
};

/// The colour of the paper; none: transparent.
[[nodiscard]] inline std::optional<Color> colorOf(Paper paper, const PictureSettings& picture) {
    return paper == Paper::Background ? picture.background : std::nullopt;
}

/// Channels of Maps::picture: 1 if the paper and every line are grey, 3 (RGB), or 4 (RGBA) on transparent paper.
[[nodiscard]] inline int pictureChannels(const PictureSettings& picture, Paper paper = Paper::Background) {
    const std::optional<Color> behind = colorOf(paper, picture);
    if (!behind) return 4;
    const bool grey =
        behind->grey() && picture.lineColor.grey() && picture.hiddenPen.color.value_or(Color{}).grey() &&
        std::ranges::all_of(picture.pens, [](const PenSettings& pen) { return !pen.color || pen.color->grey(); });
    return grey ? 1 : 3;
}

}  // namespace inkedge::settings
