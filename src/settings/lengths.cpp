#include "settings/lengths.h"

#include <algorithm>

#include "settings/idle.h"

namespace inkedge::settings {
namespace {

constexpr double widestStroke = 1.5;  // of its pen, where widths vary

}  // namespace

double millimetresOf(LengthUnit unit) noexcept {
    switch (unit) {
        case LengthUnit::Metre:
            return 1000.0;
        case LengthUnit::Centimetre:
            return 10.0;
        case LengthUnit::Inch:
            return 25.4;
        case LengthUnit::Foot:
            return 304.8;
        case LengthUnit::Millimetre:
        case LengthUnit::None:
            break;
    }
    return 1.0;
}

double inkReach(const RenderSettings& settings) {
    const PictureSettings& picture = settings.picture;
    if (settings.style.style == Style::Sumi) return settings.style.sumiWidth;
    if (settings.style.style == Style::None) return 0.0;
    if (settings.detector.detector == Detector::RaskarCohen && !drawsMeshLines(settings))
        return pixelsOf(picture.lineWidth, picture.pixelsPerInch());
    double widest = 0.0;
    for (std::size_t i = 0; i < lineTypeCount; ++i) {
        if (!picture.lines.contains(static_cast<LineType>(1U << i))) continue;
        widest = std::max(widest, pixelsOf(picture.pens[i].width.value_or(picture.lineWidth), picture.pixelsPerInch()));
    }
    const StrokeWidth kind = settings.lines.strokeWidth;
    if (kind != StrokeWidth::Constant && kind != StrokeWidth::Strength) widest *= widestStroke;
    return 0.5 * widest + (settings.style.style == Style::Pencil ? settings.style.pencilLooseness : 0.0);
}

bool isSizedOnPaper(const FrameSettings& frame) noexcept {
    return frame.scale || (frame.size && frame.size->millimetres) || (frame.crop && frame.crop->millimetres);
}

}  // namespace inkedge::settings
