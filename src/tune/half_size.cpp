#include "tune/half_size.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <inkedge/setting_table.h>

namespace inkedge::tune {
namespace {

constexpr double minPen = 0.5;        // pixels: PictureSettings::lineWidth
constexpr double minDashPart = 0.01;  // pixels: a dash and its gap are over 0

int halved(int side) { return std::max((side + 1) / 2, 1); }

void halve(PictureLength& length, double min = 0.0) {
    if (!length.millimetres) length.value = std::max(length.value / 2.0, min);
}
void halve(std::optional<PictureLength>& length, double min = 0.0) {
    if (length) halve(*length, min);
}

// A number of pixels that its row of the table limits.
void halve(std::string_view name, double& pixels) {
    pixels = std::max(pixels / 2.0, std::get<Number>(findSetting(name)->constraint).min);
}

void halve(FrameSettings& frame) {
    if (frame.size && !frame.size->millimetres) {
        frame.size->width = std::max(std::ceil(frame.size->width / 2.0), 1.0);
        frame.size->height = std::ceil(frame.size->height / 2.0);  // 0 stays: as what is drawn asks for
    }
    halve(frame.crop);
}

void halve(PictureSettings& picture) {
    picture.dpi = std::max(picture.pixelsPerInch() / 2.0, std::get<Number>(findSetting("dpi")->constraint).min);
    picture.size = {halved(picture.size.width), halved(picture.size.height)};
    picture.supersampling = 1;
    halve(picture.lineWidth, minPen);
    for (PenSettings& pen : picture.pens) halve(pen.width, minPen);
    halve(picture.hiddenPen.width, minPen);
    if (picture.hiddenPen.dash) {
        halve(picture.hiddenPen.dash->dash, minDashPart);
        halve(picture.hiddenPen.dash->gap, minDashPart);
    }
}

}  // namespace

Settings halfSize(Settings settings) {
    halve(settings.frame);
    halve(settings.picture);
    halve("stroke-taper", settings.lines.strokeTaper);
    halve("hatch-width", settings.style.hatchWidth);
    halve("sumi-width", settings.style.sumiWidth);
    halve("sumi-length", settings.style.sumiLength);
    halve("pencil-looseness", settings.style.pencilLooseness);
    return settings;
}

}  // namespace inkedge::tune
