#include "settings/pens.h"

namespace inkedge::settings {
namespace {

constexpr double millimetresPerInch = 25.4;

double pixels(const PictureLength& length, double dpi) {
    return length.millimetres ? length.value / millimetresPerInch * dpi : length.value;
}

}  // namespace

std::array<Pen, penCount> pens(const PictureSettings& settings) {
    std::array<Pen, penCount> all{};
    for (std::size_t i = 0; i < lineTypeCount; ++i) {
        const PenSettings& pen = settings.pens[i];
        const Pen seen{pixels(pen.width.value_or(settings.lineWidth), settings.dpi),
                       pen.color.value_or(settings.lineColor)};
        all[i] = seen;
        all[i + lineTypeCount] = {hiddenWidth * seen.width, seen.color};
    }
    return all;
}

std::uint8_t penOf(const Line& line) noexcept {
    const int type = bitIndex(line.type);
    return static_cast<std::uint8_t>(line.visible ? type : type + lineTypeCount);
}

bool isDrawn(const Line& line, const PictureSettings& picture, const LineSettings& lines) noexcept {
    return picture.lines.contains(line.type) && (line.visible || lines.hidden != HiddenLines::None);
}

}  // namespace inkedge::settings
