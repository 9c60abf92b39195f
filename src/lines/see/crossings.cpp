#include "lines/see/crossings.h"

#include <algorithm>

#include <glm/common.hpp>

#include "base/parallel.h"
#include "lines/picture_grid.h"

namespace inkedge::lines {
namespace {

constexpr double minStep = 0.05;  // footprints: an occluder that is nearer by less lies on the same surface

constexpr std::size_t segmentsOfPart = 256;  // that one thread looks at

double cross(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

bool meet(const Segment& a, const Segment& b) {
    for (const Key ka : a.keys)
        for (const Key kb : b.keys)
            if (ka == kb && ka != noKey) return true;
    return false;
}

}  // namespace

std::vector<Crossing> findCrossings(std::span<const Segment> segments, std::span<const ScreenSegment> screenSegments,
                                    const Screen& screen, const SurfaceComponents* components) {
    const PictureGrid grid{screen.size()};
    const CellLists occluders{grid, segments.size(), [&](std::uint32_t s, auto&& visit) {
                                  const auto& ends = screenSegments[s].ends;
                                  if (segments[s].occludes) grid.forEachCell(ends[0].pixel, ends[1].pixel, 0.0, visit);
                              }};

    const auto addCrossings = [&](std::uint32_t s, std::vector<Crossing>& crossings) {
        if (!segments[s].drawn) return;
        const ScreenSegment& own = screenSegments[s];
        const glm::dvec2 along = own.ends[1].pixel - own.ends[0].pixel;
        const double footprint = screen.footprint(own.world[0]);
        const Slack slack = slackOf(segments[s], footprint, components);
        const std::size_t before = crossings.size();
        grid.forEachCell(own.ends[0].pixel, own.ends[1].pixel, 0.0, [&](std::size_t cell) {
            for (const std::uint32_t occluder : occluders.in(cell)) {
                const ScreenSegment& other = screenSegments[occluder];
                const glm::dvec2 step = other.ends[1].pixel - other.ends[0].pixel;
                const glm::dvec2 between = other.ends[0].pixel - own.ends[0].pixel;
                const double area = cross(along, step);
                const double u = cross(between, step) / area;
                const double v = cross(between, along) / area;
                if (!(u > 0.0 && u < 1.0 && v >= 0.0 && v <= 1.0)) continue;
                if (grid.cellOf(own.ends[0].pixel + u * along) != cell) continue;  // each crossing once
                const double ownInverseDepth =
                    own.ends[0].inverseDepth + u * (own.ends[1].inverseDepth - own.ends[0].inverseDepth);
                const double otherInverseDepth =
                    other.ends[0].inverseDepth + v * (other.ends[1].inverseDepth - other.ends[0].inverseDepth);
                if (screen.footprintsBefore(otherInverseDepth, ownInverseDepth) <=
                    minStep + slack.of(segments[occluder].faces[0]) / footprint)
                    continue;
                if (!meet(segments[s], segments[occluder])) crossings.push_back({s, u});
            }
        });
        std::sort(crossings.begin() + static_cast<std::ptrdiff_t>(before), crossings.end(),
                  [](const Crossing& a, const Crossing& b) { return a.at < b.at; });
    };
    std::vector<std::vector<Crossing>> parts((segments.size() + segmentsOfPart - 1) / segmentsOfPart);
    base::onEach(parts.size(), [&](std::size_t part) {
        const std::size_t end = std::min(segments.size(), (part + 1) * segmentsOfPart);
        for (std::size_t s = part * segmentsOfPart; s < end; ++s)
            addCrossings(static_cast<std::uint32_t>(s), parts[part]);
    });
    std::vector<Crossing> crossings;
    for (const std::vector<Crossing>& part : parts) crossings.insert(crossings.end(), part.begin(), part.end());
    return crossings;
}

}  // namespace inkedge::lines
