#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <inkedge/setting_table.h>
#include <inkedge/views.h>

#include "base/message.h"
#include "camera/drawn_part.h"
#include "camera/framing.h"
#include "scene/extent.h"
#include "settings/lengths.h"

namespace inkedge {
namespace camera {
namespace {

constexpr double rounding = 1e-6;  // pixels: a length that is a whole number but for rounding

// What is asked of all pictures, in pixels.
struct Wanted {
    int width = 0;                        // 0: as what is drawn asks for
    int height = 0;                       // likewise
    std::optional<double> margin;         // around what is drawn; none: the picture is not cropped
    std::optional<double> pixelsPerUnit;  // of the scene
    double dpi = 0.0;
    bool onPaper = false;  // something is given in millimetres, or the scale

    [[nodiscard]] bool cuts() const noexcept { return margin || height == 0; }
    [[nodiscard]] double pixels(double millimetres) const noexcept { return settings::pixelsOf(millimetres, dpi); }
    // A picture of a size that is not known yet stands on a square one.
    [[nodiscard]] Size first() const noexcept {
        const int side = width > 0 ? width : 1024;
        return {side, height > 0 ? height : side};
    }
};

int side(const Wanted& wanted, const PictureExtent& extent, double length) {
    const double pixels = extent.millimetres ? std::max(std::round(wanted.pixels(length)), 1.0) : length;
    if (pixels > PictureSettings::maxSide)
        base::refuseUse(fmt::format("--size: expected at most {} pixels along each side, found {} mm at {} dpi",
                                    PictureSettings::maxSide, length, wanted.dpi));
    return static_cast<int>(pixels);
}

std::optional<PictureExtent> extentOf(const Settings& settings) {
    const FrameSettings& frame = settings.frame;
    const auto& page = settings.picture.page;
    const bool inPixels = frame.size && !frame.size->millimetres && frame.size->height > 0.0;
    if (frame.size && !inPixels) return frame.size;
    if (!frame.size && frame.scale && page) return PictureExtent{page->width, page->height, true};
    if (!frame.size && frame.scale) return {};
    return PictureExtent{static_cast<double>(settings.picture.size.width),
                         static_cast<double>(settings.picture.size.height), false};
}

Wanted wantedOf(const Settings& settings, const Scene& scene) {
    const FrameSettings& frame = settings.frame;
    Wanted wanted;
    wanted.dpi = settings.picture.pixelsPerInch();
    if (const auto extent = extentOf(settings)) {
        wanted.width = side(wanted, *extent, extent->width);
        wanted.height = extent->height > 0.0 ? side(wanted, *extent, extent->height) : 0;
        wanted.onPaper = extent->millimetres;
    }
    if (frame.crop) {
        wanted.margin = (frame.crop->millimetres ? wanted.pixels(frame.crop->value) : frame.crop->value) +
                        settings::inkReach(settings);
        wanted.onPaper = wanted.onPaper || frame.crop->millimetres;
    }
    if (frame.scale) {
        wanted.pixelsPerUnit = *frame.scale * wanted.pixels(settings::millimetresOf(scene.source().unit));
        wanted.onPaper = true;
    }
    return wanted;
}

// Whether a view says itself how much of the scene it shows.
bool isFixed(const CameraSettings& view) {
    return view.position || view.focalPoint || view.index || view.orthographicHeight.value_or(0.0) > 0.0 ||
           view.zoomFactor != 1.0;
}

Camera firstCamera(const Scene& scene, CameraSettings view, const Wanted& wanted) {
    const Size size = wanted.first();
    if (!wanted.pixelsPerUnit) return frameCamera(scene, view, size);
    const auto exclude = [](bool both, std::string_view other) {
        if (both) base::refuseUse(fmt::format("--scale: expected it without {}, found both", other));
    };
    exclude(view.viewAngle.has_value(), "--camera-view-angle, for it takes an orthographic view");
    exclude(view.index.has_value(), "--camera-index");
    exclude(view.orthographicHeight.value_or(0.0) > 0.0, "the height of --camera-orthographic");
    exclude(view.zoomFactor != 1.0, "--camera-zoom-factor");
    view.orthographicHeight = size.height / *wanted.pixelsPerUnit;
    return frameCamera(scene, view, size);
}

// A view on its way to its picture: what a camera sees that shows it in a picture of the size Wanted::first().
struct Laid {
    Camera camera;
    bool fixed = false;   // it says itself how much of the scene it shows
    bool joined = false;  // it is framed together with others
};

// The middle of the scene's extents along its own axes.
glm::dvec3 middleOf(const Scene& scene) {
    const glm::dvec3 up = scene.up();
    const glm::dvec3 front = scene.front();
    glm::dvec3 middle{0.0};
    for (const glm::dvec3& axis : {up, front, glm::cross(up, front)})
        middle += 0.5 * (scene::support(scene, axis) - scene::support(scene, -axis)) * axis;
    return middle;
}

// Joins the views that do not say themselves how much they show; where some are orthographic, these alone: a picture in
// perspective has no scale.
void joinFree(std::vector<Laid>& views) {
    const auto isParallel = [](const Laid& view) { return !view.fixed && view.camera.orthographic(); };
    const bool parallel = std::ranges::any_of(views, isParallel);
    for (Laid& view : views) view.joined = !view.fixed && view.camera.orthographic() == parallel;
}

// What a picture shows of the plane of the first one, after this has been magnified.
struct Window {
    double magnification = 1.0;
    glm::dvec2 middle{0.0};
    Size size;
};

int wholeSide(double pixels, const char* name) {
    const double side = std::max(std::ceil(pixels - rounding), 1.0);
    if (side > PictureSettings::maxSide)
        base::refuseUse(
            fmt::format("--size: expected a picture of at most {} pixels along each side, found a {} of {:.0f}, which "
                        "what is drawn asks for; give both sides, a smaller --scale or --dpi, or the model's --unit",
                        PictureSettings::maxSide, name, side));
    return static_cast<int>(side);
}

double room(int side, double margin) {
    const double inner = side - 2.0 * margin;
    if (inner >= 1.0) return inner;
    base::refuseUse(
        fmt::format("--crop: expected room between two margins in {} pixels, found margins of {:.4g} with the lines' "
                    "width",
                    side, margin));
}

void expectToFit(const PicturePart& drawn, Size size, const Wanted& wanted) {
    const glm::dvec2 found = 2.0 * glm::max(glm::abs(drawn.low), glm::abs(drawn.high));
    if (found.x <= size.width + 1.0 && found.y <= size.height + 1.0) return;
    const double perPixel = 1.0 / wanted.pixels(1.0);
    base::refuseUse(
        fmt::format("--scale: expected what is drawn, {:.4g} x {:.4g} mm at this scale, to fit into a picture of "
                    "{:.4g} x {:.4g} mm, found it larger; make the scale smaller or the picture larger, or say the "
                    "model's --unit",
                    found.x * perPixel, found.y * perPixel, size.width * perPixel, size.height * perPixel));
}

// A picture whose size is given and stays.
Window wholeWindow(const PicturePart& drawn, bool fixed, const Wanted& wanted) {
    Window window{.size = {wanted.width, wanted.height}};
    if (fixed || drawn.empty()) return window;
    if (wanted.pixelsPerUnit) {
        expectToFit(drawn, window.size, wanted);
        return window;
    }
    const glm::dvec2 reach = glm::max(glm::abs(drawn.low), glm::abs(drawn.high));
    const glm::dvec2 fitting = 0.5 * frameShare * glm::dvec2{wanted.width, wanted.height} / reach;
    const double magnification = std::min(fitting.x, fitting.y);
    if (std::isfinite(magnification)) window.magnification = magnification;
    return window;
}

// How much larger than in the first picture what is drawn becomes.
double magnificationOf(glm::dvec2 drawn, double margin, const Wanted& wanted) {
    double magnification = room(wanted.width, margin) / drawn.x;
    if (wanted.height > 0) magnification = std::min(magnification, room(wanted.height, margin) / drawn.y);
    return std::isfinite(magnification) ? magnification : 1.0;
}

// A picture that is cut to what is drawn, on all sides or above and below.
Window cutWindow(PicturePart drawn, bool fixed, const Wanted& wanted) {
    const glm::dvec2 half = 0.5 * glm::dvec2{wanted.first().width, wanted.first().height};
    if (fixed) {  // what lies beyond the picture is not meant to be seen
        drawn.low.x = std::max(drawn.low.x, -half.x);
        drawn.high.x = std::min(drawn.high.x, half.x);
        if (wanted.height > 0) {
            drawn.low.y = std::max(drawn.low.y, -half.y);
            drawn.high.y = std::min(drawn.high.y, half.y);
        }
    }
    if (drawn.empty()) return {.size = wanted.first()};
    const glm::dvec2 extent = drawn.size();
    const double framed = wanted.width > 0 ? wanted.width : std::max(extent.x, extent.y) / frameShare;
    const double margin = wanted.margin.value_or(0.5 * (1.0 - frameShare) * framed);
    const bool fillsWidth = wanted.width > 0 && wanted.height == 0;
    Window window;
    if (!wanted.pixelsPerUnit && wanted.width > 0 && (!fixed || (fillsWidth && wanted.margin)))
        window.magnification = magnificationOf(extent, margin, wanted);
    const glm::dvec2 filled = window.magnification * extent + 2.0 * margin;
    window.middle = window.magnification * drawn.middle();
    if (fixed && fillsWidth && !wanted.margin) window.middle.x = 0.0;
    window.size = {fillsWidth ? wanted.width : wholeSide(filled.x, "width"), wholeSide(filled.y, "height")};
    if (wanted.pixelsPerUnit && wanted.width > 0 && !fixed) {
        const glm::dvec2 inked = fillsWidth ? extent : glm::dvec2{window.size.width, window.size.height};
        expectToFit({-0.5 * inked, 0.5 * inked},
                    {wanted.width, wanted.height > 0 ? wanted.height : PictureSettings::maxSide}, wanted);
    }
    return window;
}

Window windowFor(const PicturePart& drawn, bool fixed, const Wanted& wanted) {
    return wanted.cuts() ? cutWindow(drawn, fixed, wanted) : wholeWindow(drawn, fixed, wanted);
}

// Moves the cameras of joined views so that all see the middle of the scene in the middle of the picture, at one scale
// and from one distance, and finds the window that shows what any of them sees.
Window sharedWindow(const Scene& scene, std::vector<Laid>& views, const Wanted& wanted) {
    if (std::ranges::none_of(views, &Laid::joined)) return {};
    const glm::dvec4 middle{middleOf(scene), 1.0};
    double distance = 0.0;
    double height = 0.0;  // of orthographic views
    for (const Laid& view : views) {
        if (!view.joined) continue;
        distance = std::max(distance, -(view.camera.view * middle).z);
        height = std::max(height, view.camera.orthographicHeight);
    }
    PicturePart drawn;
    for (Laid& view : views) {
        if (!view.joined) continue;
        const glm::dvec3 found{view.camera.view * middle};
        view.camera.view[3] -= glm::dvec4{found.x, found.y, found.z + distance, 0.0};
        view.camera.orthographicHeight = height;
        fitNearAndFar(view.camera, scene.bounds());
        drawn.add(drawnPart(scene, view.camera, wanted.first()));
    }
    return windowFor(drawn, false, wanted);
}

// A view that needs nothing else is in the window that frameCamera() framed it in.
Window ownWindow(const Scene& scene, const Laid& view, const Wanted& wanted) {
    if (!wanted.cuts() && !wanted.pixelsPerUnit) return wholeWindow({}, true, wanted);
    return windowFor(drawnPart(scene, view.camera, wanted.first()), view.fixed, wanted);
}

void expectOnPage(Size size, const Wanted& wanted, const std::optional<PageSize>& page) {
    if (!page || !wanted.onPaper) return;
    const double perPixel = 1.0 / wanted.pixels(1.0);
    if ((size.width - 1) * perPixel <= page->width && (size.height - 1) * perPixel <= page->height) return;
    base::refuseUse(
        fmt::format("--page-size: expected a page that holds the picture, {:.4g} x {:.4g} mm, found {} x {} mm",
                    size.width * perPixel, size.height * perPixel, page->width, page->height));
}

FramedView framed(Camera camera, Size first, const Window& window, const Wanted& wanted, const Settings& settings) {
    const glm::dvec2 size{window.size.width, window.size.height};
    const double focalLength = camera.focalLength(first) * window.magnification;  // or pixels a scene unit
    const bool same = window.size == first && window.magnification == 1.0 && window.middle == glm::dvec2{0.0};
    if (same) {
        // Nothing is to be rounded.
    } else if (camera.orthographic()) {
        camera.orthographicHeight = size.y / focalLength;
        camera.view[3] -= glm::dvec4{window.middle / focalLength, 0.0, 0.0};
    } else {
        camera.viewAngle = glm::degrees(2.0 * std::atan(0.5 * size.y / focalLength));
        camera.axis = -window.middle / (0.5 * size);
    }
    expectOnPage(window.size, wanted, settings.picture.page);
    FramedView view{camera, settings.picture};
    view.picture.size = window.size;
    if (wanted.onPaper) view.picture.dpi = wanted.dpi;
    return view;
}

}  // namespace
}  // namespace camera

bool framedTogether(std::span<const View> views) noexcept {
    const auto together = [&](const View& view) {
        return view.camera.framing == Framing::Together || (view.camera.framing == Framing::Auto && view.camera.view);
    };
    return views.size() > 1 && std::ranges::any_of(views, together);
}

std::vector<FramedView> frameViews(const Scene& scene, std::span<const View> views, const Settings& settings) {
    using namespace camera;
    validate(settings.frame);
    const Wanted wanted = wantedOf(settings, scene);
    std::vector<Laid> laid;
    for (const View& view : views) laid.push_back({firstCamera(scene, view.camera, wanted), isFixed(view.camera)});
    if (framedTogether(views)) joinFree(laid);
    const Size first = wanted.first();
    const Window shared = sharedWindow(scene, laid, wanted);
    std::vector<FramedView> result;
    for (const Laid& view : laid) {
        const Window window = view.joined ? shared : ownWindow(scene, view, wanted);
        result.push_back(framed(view.camera, first, window, wanted, settings));
    }
    return result;
}

}  // namespace inkedge
