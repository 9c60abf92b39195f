#include "trace/thin_lines.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "trace/components.h"

namespace inkedge::trace {
namespace {

constexpr double besidePixels = 0.75;  // from a thin part to where it is looked at what lies beside it

glm::dvec2 middleOf(const ThinStretch& s) { return 0.5 * (s.ends[0] + s.ends[1]); }

double thicknessOf(const ThinStretch& s) { return 0.5 * (s.thickness[0] + s.thickness[1]); }

SamplePosition sampleAt(glm::dvec2 p, const raster::Tile& tile) {
    return {static_cast<int>(std::floor(p.x)) - tile.drawn.x, static_cast<int>(std::floor(p.y)) - tile.drawn.y};
}

glm::dvec2 centreOf(SamplePosition s, const raster::Tile& tile) {
    return {s.x + tile.drawn.x + 0.5, s.y + tile.drawn.y + 0.5};
}

bool isIn(SamplePosition s, const raster::Tile& tile) {
    return s.x >= 0 && s.y >= 0 && s.x < tile.drawn.size.width && s.y < tile.drawn.size.height;
}

// Points beside a stretch, on both sides.
std::array<glm::dvec2, 2> pointsBeside(const ThinStretch& s, int samplesPerPixel) {
    const glm::dvec2 step = (0.5 * thicknessOf(s) + besidePixels * samplesPerPixel) * s.across;
    return {middleOf(s) - step, middleOf(s) + step};
}

class ThinLineFinder {
public:
    ThinLineFinder(const LineBuffers& buffers, const ScreenTriangles& triangles, const Camera& camera,
                   int samplesPerPixel)
        : buffers_{buffers},
          triangles_{triangles},
          orthographic_{camera.orthographic()},
          focalLength_{camera.focalLength(buffers.tile.whole)},
          samplesPerPixel_{samplesPerPixel} {}

    [[nodiscard]] std::optional<ThinLine> see(const ThinStretch& stretch, Components& components) const {
        const SamplePosition at = sampleAt(middleOf(stretch), buffers_.tile);
        if (!isIn(at, buffers_.tile)) return {};
        const ScreenTriangles::Plane& own = stretch.plane;
        if (!std::isfinite(own.w)) return {};
        const auto seen = face(at);
        if (seen && isFarther(own, triangles_.plane(*seen, centre(at)))) return {};
        if (stretch.isGap) return seeGap(stretch, components);
        bool outline = false;
        bool object = false;
        for (const glm::dvec2 beside : pointsBeside(stretch, samplesPerPixel_)) {
            const SamplePosition s = sampleAt(beside, buffers_.tile);
            const auto other = isIn(s, buffers_.tile) ? face(s) : std::nullopt;
            if (!other) {
                outline = true;
                continue;
            }
            if (!isFarther(triangles_.plane(*other, beside), own) && !isThin(s, stretch) &&
                (components.connect(stretch.face, *other) || !liesOn(stretch, *other)))
                return {};
            object = object || other->instance != stretch.face.instance;
        }
        LineTypes types = outline ? LineType::Outline : LineType::Occlusion;
        if (stretch.atBorder) types |= LineType::Boundary;
        if (object && !outline) types |= LineType::Object;
        const auto w = static_cast<float>(own.w);
        return ThinLine{stretch, types, {w, w}};
    }

    // Whether a sample sees through a gap, or a surface that ends within a thin part's thickness to both sides.
    [[nodiscard]] bool isThin(SamplePosition s, const ThinStretch& stretch) const {
        const auto seen = face(s);
        if (stretch.isGap) return !seen || isFarther(triangles_.plane(*seen, middleOf(stretch)), stretch.plane);
        if (!seen) return false;
        double width = 0.0;
        for (const double sign : {-1.0, 1.0}) {
            const glm::dvec2 goal = centre(s) + sign * samplesPerPixel_ * stretch.across;
            const auto exit = triangles_.walk(*seen, centre(s), goal, ScreenTriangles::Over::Surface).exit;
            if (!exit || exit->end == ScreenTriangles::End::Crease) return false;
            width += exit->t;
        }
        return width <= 1.0 + snapping;
    }

private:
    // Beyond either border the surface goes on, so that it is no outline.
    [[nodiscard]] std::optional<ThinLine> seeGap(const ThinStretch& stretch, Components& components) const {
        for (const glm::dvec2 beside : pointsBeside(stretch, samplesPerPixel_)) {
            const SamplePosition s = sampleAt(beside, buffers_.tile);
            const auto other = isIn(s, buffers_.tile) ? face(s) : std::nullopt;
            if (!other || !components.connect(stretch.face, *other)) return {};
            const ScreenTriangles::Plane plane = triangles_.plane(*other, beside);
            if (isFarther(plane, stretch.plane) || isFarther(stretch.plane, plane)) return {};
        }
        const auto w = static_cast<float>(stretch.plane.w);
        return ThinLine{stretch, LineType::Boundary, {w, w}};
    }

    // Whether a thin part's middle lies in front of a face that is seen beside it, or on its plane.
    [[nodiscard]] bool liesOn(const ThinStretch& stretch, scene::SceneFace face) const {
        constexpr double rounding = 1e-6;  // of positions: vertices are floats
        const glm::dvec2 middle = middleOf(stretch);
        const glm::dvec2 contour = middle - 0.5 * thicknessOf(stretch) * stretch.across;
        const auto arrivedAt = triangles_.walk(stretch.face, contour, middle, ScreenTriangles::Over::Surface).arrivedAt;
        if (!arrivedAt) return false;
        const double own = triangles_.plane({stretch.face.instance, *arrivedAt}, middle).w;
        const double other = triangles_.plane(face, middle).w;
        return own >= other - rounding * std::abs(other);
    }

    static constexpr double snapping = 1.0 / 128;  // vertices snap to a grid of 1/256

    [[nodiscard]] glm::dvec2 centre(SamplePosition s) const { return centreOf(s, buffers_.tile); }

    [[nodiscard]] std::optional<scene::SceneFace> face(SamplePosition s) const {
        const std::uint32_t number = buffers_.triangles(s.x, s.y);
        return number == 0 ? std::nullopt : std::optional{triangles_.locate(number - 1)};
    }

    // As surfaces jump between samples: reference::detectLines().
    [[nodiscard]] bool isFarther(const ScreenTriangles::Plane& one, const ScreenTriangles::Plane& other) const {
        const auto slope = [](const ScreenTriangles::Plane& p) { return std::hypot(p.dx, p.dy); };
        const double perUnit = orthographic_ ? focalLength_ : focalLength_ / std::max(one.w, other.w);
        return (other.w - one.w) * perUnit > 1.0 + std::min(slope(one), slope(other)) * perUnit;
    }

    const LineBuffers& buffers_;
    const ScreenTriangles& triangles_;
    bool orthographic_;
    double focalLength_;
    int samplesPerPixel_;
};

// How far the lines of a thin part have parted. 0: its middle line, 1: its contours. @param thickness  pixels
double partedAt(double thickness) { return std::clamp(2.0 * thickness - 1.0, 0.0, 1.0); }

// Calls visit for the samples whose centres lie on a stretch.
template <class Visit>
void forEachSampleOn(const ThinStretch& s, const raster::Tile& tile, Visit visit) {
    constexpr double margin = 0.1;  // samples: vertices snap to a grid, and stretches of a bent part leave gaps
    const glm::dvec2 along{-s.across.y, s.across.x};
    const double halfLength = 0.5 * std::abs(glm::dot(s.ends[1] - s.ends[0], along)) + margin;
    const double halfWidth = 0.5 * thicknessOf(s) + margin;
    const double reach = halfLength + halfWidth;
    const SamplePosition low = sampleAt(middleOf(s) - reach, tile);
    const SamplePosition high = sampleAt(middleOf(s) + reach, tile);
    for (int y = std::max(low.y, 0); y <= std::min(high.y, tile.drawn.size.height - 1); ++y) {
        for (int x = std::max(low.x, 0); x <= std::min(high.x, tile.drawn.size.width - 1); ++x) {
            const glm::dvec2 from = centreOf({x, y}, tile) - middleOf(s);
            if (std::abs(glm::dot(from, along)) <= halfLength && std::abs(glm::dot(from, s.across)) <= halfWidth)
                visit(SamplePosition{x, y});
        }
    }
}

}  // namespace

Image<std::uint8_t> withThinParts(Image<std::uint8_t> marks, std::span<const ThinStretch> stretches,
                                  const raster::Tile& tile, int samplesPerPixel) {
    for (const ThinStretch& stretch : stretches) {
        const auto mark = [&](glm::dvec2 p) {
            const SamplePosition s = sampleAt(p, tile);
            if (isIn(s, tile)) marks(s.x, s.y) |= 1;
        };
        mark(middleOf(stretch));
        for (const glm::dvec2 beside : pointsBeside(stretch, samplesPerPixel)) mark(beside);
    }
    return marks;
}

std::vector<ThinLine> seeThinParts(const LineBuffers& buffers, std::span<const ThinStretch> stretches,
                                   const Scene& scene, const ScreenTriangles& triangles, const Camera& camera,
                                   int samplesPerPixel) {
    const ThinLineFinder finder{buffers, triangles, camera, samplesPerPixel};
    Components components{scene};
    std::vector<ThinLine> lines;
    for (const ThinStretch& stretch : stretches)
        if (const std::optional<ThinLine> line = finder.see(stretch, components)) lines.push_back(*line);
    return lines;
}

std::vector<Replacement> samplesOn(std::span<const ThinLine> lines, const LineBuffers& buffers,
                                   const ScreenTriangles& triangles, const Camera& camera, int samplesPerPixel) {
    const ThinLineFinder finder{buffers, triangles, camera, samplesPerPixel};
    const raster::Tile& tile = buffers.tile;
    std::vector<Replacement> found;
    for (const ThinLine& line : lines) {
        const ThinStretch& stretch = line.stretch;
        forEachSampleOn(stretch, tile, [&](SamplePosition s) {
            if (!finder.isThin(s, stretch)) return;
            const glm::dvec2 centre = centreOf(s, tile);
            const double offset = glm::dot(centre - middleOf(stretch), stretch.across);
            const double away = 0.5 * thicknessOf(stretch) + besidePixels * samplesPerPixel;
            const double step = offset < 0.0 ? -away - offset : away - offset;
            const SamplePosition beside = sampleAt(centre + step * stretch.across, tile);
            if (isIn(beside, tile)) found.push_back({s, beside});
        });
    }
    return found;
}

void addThinLines(std::span<const ThinLine> lines, const raster::Tile& tile, DrawnTypes drawn, int samplesPerPixel,
                  Image<std::uint16_t>& types, std::vector<TracedPiece>& pieces) {
    const double scale = 1.0 / samplesPerPixel;
    const raster::Rectangle kept = tile.keptInDrawn();
    for (const ThinLine& line : lines) {
        const ThinStretch& stretch = line.stretch;
        const SamplePosition s = sampleAt(middleOf(stretch), tile);
        types(s.x, s.y) |= static_cast<std::uint16_t>(line.types.bits());
        const bool isKept =
            s.x >= kept.x && s.y >= kept.y && s.x < kept.x + kept.size.width && s.y < kept.y + kept.size.height;
        if (!isKept || (line.types & drawn.drawn).empty()) continue;
        const double thickness = scale * thicknessOf(stretch);
        const double thinnest = stretch.isGap ? 1.0 : thickness;
        const auto width = static_cast<float>(glm::mix(thinnest, 1.0, partedAt(thickness)));
        const auto add = [&](double side) {
            const auto end = [&](std::size_t k) {
                const double own = stretch.thickness[k];
                const glm::dvec2 offset = 0.5 * side * partedAt(scale * own) * own * stretch.across;
                return glm::vec2{scale * (stretch.ends[k] + offset)};
            };
            pieces.push_back({{end(0), end(1)}, line.inverseDepths, drawnType(line.types, drawn), stretch.face, width});
        };
        add(-1.0);
        if (partedAt(thickness) > 0.0) add(1.0);
    }
}

}  // namespace inkedge::trace
