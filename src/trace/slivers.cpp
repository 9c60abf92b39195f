#include "trace/slivers.h"

#include <algorithm>
#include <optional>

#include <glm/common.hpp>

namespace inkedge::trace {
namespace {

constexpr double narrow = 0.02;  // samples: several steps of the grid of 1/256 that vertices snap to

class SliverFinder {
public:
    SliverFinder(const LineBuffers& buffers, const ScreenTriangles& triangles)
        : buffers_{buffers}, triangles_{triangles} {}

    [[nodiscard]] std::vector<Replacement> find() const {
        std::vector<Replacement> found;
        const Size size = buffers_.marks.size();
        for (int y = 1; y + 1 < size.height; ++y) {
            forEachMarked(buffers_.marks, y, 1, size.width - 1, [&](int x) {
                if (const std::optional<SamplePosition> beside = besideSliver({x, y}))
                    found.push_back({{x, y}, *beside});
            });
        }
        return found;
    }

private:
    [[nodiscard]] bool isBackground(SamplePosition s) const { return buffers_.triangles(s.x, s.y) == 0; }

    [[nodiscard]] glm::dvec2 centre(SamplePosition s) const {
        const raster::Rectangle& drawn = buffers_.tile.drawn;
        return {s.x + drawn.x + 0.5, s.y + drawn.y + 0.5};
    }

    // Where the patch seen at a sample ends on the way to a neighbour, or little beyond: a share of the way. None: it
    // goes on.
    [[nodiscard]] std::optional<double> end(SamplePosition from, SamplePosition to) const {
        if (isBackground(from)) return {};
        constexpr double way = 1.0 + narrow;
        const scene::SceneFace face = triangles_.locate(buffers_.triangles(from.x, from.y) - 1);
        const auto exit = triangles_.walk(face, centre(from), glm::mix(centre(from), centre(to), way)).exit;
        return exit ? std::optional{way * exit->t} : std::nullopt;
    }

    // How far a sample's surface can be seen towards its neighbour: to its own end, or to that of a surface before it.
    [[nodiscard]] double reach(SamplePosition s, SamplePosition neighbour) const {
        const double own = end(s, neighbour).value_or(1.0);
        if (own < narrow) return own;
        const std::optional<double> other = end(neighbour, s);
        return other ? std::min(own, std::max(1.0 - *other, 0.0)) : own;
    }

    [[nodiscard]] std::optional<SamplePosition> besideSliver(SamplePosition s) const {
        const unsigned own = buffers_.marks(s.x, s.y);
        const auto between = [&](SamplePosition before, SamplePosition after) -> std::optional<SamplePosition> {
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

    const LineBuffers& buffers_;
    const ScreenTriangles& triangles_;
};

}  // namespace

std::vector<Replacement> findSlivers(const LineBuffers& buffers, const ScreenTriangles& triangles) {
    return SliverFinder{buffers, triangles}.find();
}

}  // namespace inkedge::trace
