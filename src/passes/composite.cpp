#include "passes/composite.h"

namespace inkedge::passes {

Image<std::uint8_t> composite(const EdgeMarks& marks, const PictureSettings& settings, settings::Paper paper) {
    const Color line = settings.lineColor;
    // A transparent background keeps the line's colour, so that scaling the picture later mixes in no other.
    const std::optional<Color> background = settings::colorOf(paper, settings);
    const Color behind = background.value_or(line);
    const std::array<std::uint8_t, 4> edge{line.red, line.green, line.blue, 255};
    const std::array<std::uint8_t, 4> none{behind.red, behind.green, behind.blue,
                                           static_cast<std::uint8_t>(background ? 255 : 0)};
    return paintMarks(marks, {none, edge, edge, edge}, settings::pictureChannels(settings, paper));
}

}  // namespace inkedge::passes
