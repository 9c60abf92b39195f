#include "io/page.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

#include "settings/lengths.h"

namespace inkedge::io {
namespace {

using settings::millimetresPerInch;

bool hasMillimetres(const PictureSettings& picture) {
    const auto inMillimetres = [](const std::optional<PictureLength>& length) { return length && length->millimetres; };
    return picture.dpi || picture.lineWidth.millimetres || inMillimetres(picture.hiddenPen.width) ||
           std::ranges::any_of(picture.pens, [&](const PenSettings& pen) { return inMillimetres(pen.width); });
}

// The size in millimetres that is asked for, of which the picture's whole pixels fall short or reach beyond by half a
// pixel.
PageSize paperOf(const Settings& settings, Size size, double dpi) {
    const double perPixel = millimetresPerInch / dpi;
    PageSize paper{size.width * perPixel, size.height * perPixel};
    const auto& wanted = settings.frame.size;
    const auto take = [&](double length, double& side) {
        if (std::abs(length - side) < perPixel) side = length;
    };
    if (wanted && wanted->millimetres) {
        take(wanted->width, paper.width);
        take(wanted->height, paper.height);
    }
    return paper;
}

}  // namespace

Page pageOf(const Settings& settings, Size size) {
    const PictureSettings& picture = settings.picture;
    const glm::dvec2 pixels{size.width, size.height};
    double dpi = picture.pixelsPerInch();
    const bool onPaper = settings::isSizedOnPaper(settings.frame);
    if (!picture.page && !onPaper && !hasMillimetres(picture)) return {pixels, {0.0, 0.0}, dpi, {}};
    if (picture.page && !onPaper)
        dpi = millimetresPerInch / std::min(picture.page->width / size.width, picture.page->height / size.height);
    const PageSize paper = picture.page ? *picture.page : paperOf(settings, size, dpi);
    const bool fills = !picture.page && !(settings.frame.size && settings.frame.size->millimetres);
    const glm::dvec2 whole = fills ? pixels : dpi / millimetresPerInch * glm::dvec2{paper.width, paper.height};
    // A picture in millimetres may reach over the page by half a pixel, which is not drawn then.
    const glm::dvec2 margin = 0.5 * (whole - pixels);
    return {whole, onPaper ? margin : glm::max(margin, 0.0), dpi, paper};
}

}  // namespace inkedge::io
