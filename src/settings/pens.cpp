#include "settings/pens.h"

#include "settings/lengths.h"

namespace inkedge::settings {
namespace {

double shareOf(LineType type) {
    if (type == LineType::Tangent) return tangentWidth;
    return formLineTypes.contains(type) ? formWidth : 1.0;
}

}  // namespace

std::array<Pen, penCount> pens(const PictureSettings& picture) {
    std::array<Pen, penCount> all{};
    const double dpi = picture.pixelsPerInch();
    const auto& [hiddenPenWidth, hiddenPenColor, hiddenPenDash] = picture.hiddenPen;
    for (std::size_t i = 0; i < lineTypeCount; ++i) {
        const PenSettings& pen = picture.pens[i];
        const double share = shareOf(static_cast<LineType>(1U << i));
        const Pen seen{pen.width ? pixelsOf(*pen.width, dpi) : share * pixelsOf(picture.lineWidth, dpi),
                       pen.color.value_or(picture.lineColor)};
        const double width = hiddenPenWidth ? pixelsOf(*hiddenPenWidth, dpi) : hiddenWidth * seen.width;
        all[i] = seen;
        all[i + lineTypeCount] = {width, hiddenPenColor.value_or(seen.color),
                                  hiddenPenDash ? pixelsOf(hiddenPenDash->dash, dpi) : dashLength * width,
                                  hiddenPenDash ? pixelsOf(hiddenPenDash->gap, dpi) : gapLength * width};
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
