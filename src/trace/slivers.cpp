#include "trace/slivers.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include <glm/common.hpp>
#include <glm/trigonometric.hpp>

#include "raster/plane_pairs.h"

namespace inkedge::trace {
namespace {

constexpr double narrow = 0.02;  // samples: several steps of the grid of 1/256 that vertices snap to
constexpr unsigned rightMarks = 0x0F;
constexpr unsigned belowMarks = 0xF0;

struct Sample {
    int x;
    int y;
};

class SliverFilter {
public:
    SliverFilter(LineBuffers& buffers, const ScreenTriangles& triangles, const Camera& camera, double unit,
                 double creaseAngle)
        : buffers_{buffers},
          triangles_{triangles},
          view_{camera.focalLength(buffers.tile.whole) * (camera.orthographic() ? unit : 1.0), camera.orthographic(),
                std::cos(glm::radians(creaseAngle))} {}

    void apply() {
        const Size size = buffers_.marks.size();
        for (int y = 1; y + 1 < size.height; ++y) {
            forEachMarked(buffers_.marks, y, 1, size.width - 1, [&](int x) {
                if (const std::optional<Sample> beside = besideSliver({x, y})) found_.push_back({{x, y}, *beside});
            });
        }
        // All are found before the first is changed, so that their order does not matter.
        for (const auto& [sliver, beside] : found_) values_.push_back(valuesBeside(sliver, beside));
        for (std::size_t i = 0; i < found_.size(); ++i) set(found_[i].sliver, values_[i]);
        for (const auto& [sliver, beside] : found_) markAgain(sliver);
    }

private:
    struct Sliver {
        Sample sliver;
        Sample beside;  // sees the surface that the sliver counts for
    };
    struct Values {
        float plane[4];
        std::uint32_t triangle;
    };

    [[nodiscard]] bool isBackground(Sample s) const { return buffers_.triangles(s.x, s.y) == 0; }

    [[nodiscard]] glm::dvec2 centre(Sample s) const {
        const raster::Rectangle& drawn = buffers_.tile.drawn;
        return {s.x + drawn.x + 0.5, s.y + drawn.y + 0.5};
    }

    // Where the patch seen at a sample ends on the way to a neighbour, or little beyond: a share of the way. None: it
    // goes on.
    [[nodiscard]] std::optional<double> end(Sample from, Sample to) const {
        if (isBackground(from)) return {};
        constexpr double way = 1.0 + narrow;
        const scene::SceneFace face = triangles_.locate(buffers_.triangles(from.x, from.y) - 1);
        const auto exit = triangles_.walk(face, centre(from), glm::mix(centre(from), centre(to), way)).exit;
        return exit ? std::optional{way * exit->t} : std::nullopt;
    }

    // How far a sample's surface can be seen towards its neighbour: to its own end, or to that of a surface before it.
    [[nodiscard]] double reach(Sample s, Sample neighbour) const {
        const double own = end(s, neighbour).value_or(1.0);
        if (own < narrow) return own;
        const std::optional<double> other = end(neighbour, s);
        return other ? std::min(own, std::max(1.0 - *other, 0.0)) : own;
    }

    [[nodiscard]] std::optional<Sample> besideSliver(Sample s) const {
        const unsigned own = buffers_.marks(s.x, s.y);
        const auto between = [&](Sample before, Sample after) -> std::optional<Sample> {
            const double first = reach(s, before);
            if (first >= narrow || first + reach(s, after) >= narrow) return {};
            if (isBackground(before)) return after;
            const bool afterIsNearer =
                !isBackground(after) && buffers_.planes(after.x, after.y) > buffers_.planes(before.x, before.y);
            return afterIsNearer ? after : before;
        };
        if ((own & rightMarks) != 0 && (buffers_.marks(s.x - 1, s.y) & rightMarks) != 0) {
            if (const auto beside = between({s.x - 1, s.y}, {s.x + 1, s.y})) return beside;
        }
        if ((own & belowMarks) != 0 && (buffers_.marks(s.x, s.y - 1) & belowMarks) != 0)
            return between({s.x, s.y - 1}, {s.x, s.y + 1});
        return {};
    }

    // What the surface seen at one sample would show at its neighbour.
    [[nodiscard]] Values valuesBeside(Sample s, Sample beside) const {
        const float* const p = &buffers_.planes(beside.x, beside.y);
        const auto dx = static_cast<float>(s.x - beside.x);
        const auto dy = static_cast<float>(s.y - beside.y);
        return {{p[0] + dx * p[1] + dy * p[2], p[1], p[2], p[3]}, buffers_.triangles(beside.x, beside.y)};
    }

    void set(Sample s, const Values& values) {
        std::copy_n(values.plane, 4, &buffers_.planes(s.x, s.y));
        buffers_.triangles(s.x, s.y) = values.triangle;
    }

    [[nodiscard]] raster::SeenPlane seen(Sample s) const {
        const float* const p = &buffers_.planes(s.x, s.y);
        const Size whole = buffers_.tile.whole;
        return {static_cast<double>(p[0]),
                {p[1], p[2]},
                static_cast<double>(p[3]),
                centre(s) - 0.5 * glm::dvec2{whole.width, whole.height}};
    }

    void markAgain(Sample s) {
        const auto right = [&](Sample p) { return pairMarks(seen(p), seen({p.x + 1, p.y}), 0, view_); };
        const auto below = [&](Sample p) { return pairMarks(seen(p), seen({p.x, p.y + 1}), 1, view_) << 4U; };
        const auto put = [&](Sample p, unsigned which, unsigned marks) {
            std::uint8_t& at = buffers_.marks(p.x, p.y);
            at = static_cast<std::uint8_t>((at & ~which) | marks);
        };
        put(s, rightMarks | belowMarks, right(s) | below(s));
        put({s.x - 1, s.y}, rightMarks, right({s.x - 1, s.y}));
        put({s.x, s.y - 1}, belowMarks, below({s.x, s.y - 1}));
    }

    LineBuffers& buffers_;
    const ScreenTriangles& triangles_;
    raster::PlaneView view_;
    std::vector<Sliver> found_;
    std::vector<Values> values_;
};

}  // namespace

void removeSlivers(LineBuffers& buffers, const ScreenTriangles& triangles, const Camera& camera, double unit,
                   double creaseAngle) {
    SliverFilter{buffers, triangles, camera, unit, creaseAngle}.apply();
}

}  // namespace inkedge::trace
