#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include <inkedge/camera.h>
#include <inkedge/error.h>
#include <inkedge/renderer.h>
#include <inkedge/sheet.h>

#include "scene/extent.h"
#include "settings/lengths.h"
#include "settings/text.h"
#include "sheet/arrange.h"
#include "sheet/ink.h"
#include "sheet/page.h"
#include "sheet/pens.h"
#include "sheet/title_block.h"

namespace inkedge {
namespace sheet {
namespace {

// How a view looks at the model, and the rectangle in view space that the model fills.
struct Seen {
    Camera camera;
    glm::dvec2 low;
    glm::dvec2 high;
};

Seen seen(const Scene& scene, NamedView view) {
    CameraSettings settings;
    settings.view = view;
    settings.orthographicHeight = 0.0;
    Seen result{frameCamera(scene, settings, {1024, 1024}), {}, {}};
    const glm::dmat4& toView = result.camera.view;
    for (const int axis : {0, 1}) {
        const glm::dvec3 along{toView[0][axis], toView[1][axis], toView[2][axis]};
        result.low[axis] = toView[3][axis] - scene::support(scene, -along);
        result.high[axis] = toView[3][axis] + scene::support(scene, along);
    }
    return result;
}

// Puts the middle of what is seen in the middle of a picture that holds it, and some pixels around it.
Size frame(Seen& view, double pixelsPerUnit) {
    constexpr double margin = 20.0;  // pixels: more than any pen's half width
    const glm::dvec2 middle = 0.5 * (view.low + view.high);
    view.camera.view[3] -= glm::dvec4{middle, 0.0, 0.0};
    const glm::dvec2 pixels = pixelsPerUnit * (view.high - view.low);
    const Size size{static_cast<int>(std::ceil(pixels.x + 2.0 * margin)),
                    static_cast<int>(std::ceil(pixels.y + 2.0 * margin))};
    view.camera.orthographicHeight = size.height / pixelsPerUnit;
    return size;
}

Space spaceOf(const SheetPage& page) {
    constexpr double gap = 15.0;       // between views
    constexpr double smallGap = 10.0;  // on A4
    return {framed(page), titleBlock(page), page.series == 4 ? smallGap : gap};
}

[[noreturn]] void refuseScale(const std::vector<ViewExtent>& extents, const SheetSettings& settings) {
    const std::string page = nameOf(settings.page);
    if (const auto largest = arranged(extents, settings.projection, spaceOf(settings.page), {}))
        throw Error{Error::Kind::Usage,
                    fmt::format("--scale: expected views that fit on {}, found them too large at {}; {} fits", page,
                                settings::textOfScale(*settings.scale), settings::textOfScale(largest->scale))};
    throw Error{Error::Kind::Usage,
                fmt::format("--views: expected views that fit on {} at a scale of ISO 5455, found none; ask for fewer "
                            "of them, a larger --page, or say the model's --unit",
                            page)};
}

Settings drawnSettings(const Settings& given, const SheetSettings& sheet) {
    Settings settings = given;
    settings.picture = sheetPens(given.picture, sheet.page);
    settings.lines.from = LinesFrom::Object;
    settings.lines.hidden = sheet.hidden;
    settings.lines.strokeWidth = StrokeWidth::Constant;
    settings.lines.strokeTaper = 0.0;
    settings.lines.brush.clear();
    settings.style.style = Style::Ink;
    settings.shade.shade = Shade::None;
    settings.detector.functions.clear();
    settings.maps.clear();
    return settings;
}

void expectUsable(const SheetSettings& settings) {
    if (settings.views.empty()) throw Error{Error::Kind::Usage, "--views: expected at least one view, found none"};
    if (settings.page.series < 0 || settings.page.series > 4)
        throw Error{Error::Kind::Usage, fmt::format("--page: expected A0 to A4, found A{}", settings.page.series)};
    if (settings.scale && !(*settings.scale > 0.0 && std::isfinite(*settings.scale)))
        throw Error{Error::Kind::Usage, fmt::format("--scale: expected a scale over 0, found {}", *settings.scale)};
}

}  // namespace
}  // namespace sheet

Sheet drawSheet(Renderer& renderer, const Scene& scene, const Settings& given, const SheetSettings& settings,
                const std::stop_token& stop) {
    using namespace sheet;
    expectUsable(settings);
    Sheet sheet;
    sheet.settings = settings;
    sheet.drawn = drawnSettings(given, settings);
    sheet.model = scene.source().name;
    if (given.picture.dpi) sheet.dpi = *given.picture.dpi;
    const double unit = settings::millimetresOf(scene.source().unit);
    std::vector<Seen> seenViews;
    std::vector<ViewExtent> extents;
    for (const NamedView view : settings.views) {
        seenViews.push_back(seen(scene, view));
        extents.push_back({view, unit * (seenViews.back().high - seenViews.back().low)});
    }
    const auto found = arranged(extents, settings.projection, spaceOf(settings.page), settings.scale);
    if (!found) refuseScale(extents, settings);
    sheet.scale = found->scale;
    for (std::size_t i = 0; i < extents.size(); ++i) {
        Settings own = sheet.drawn;
        own.picture.size = frame(seenViews[i], found->scale * unit * pixelsPerMillimetre);
        if (!isPrincipal(extents[i].view)) own.lines.hidden = HiddenLines::None;
        sheet.views.push_back({extents[i].view, found->middles[i], found->scale * extents[i].size,
                               renderer.lines(scene, seenViews[i].camera, own, stop)});
    }
    sheet.warnings = sheet.views.front().lines.warnings;
    for (std::string& warning : titleBlockWarnings(sheet)) sheet.warnings.push_back(std::move(warning));
    return sheet;
}

}  // namespace inkedge
