#include "mesh/clip_polygon.h"

#include <cstddef>
#include <limits>
#include <utility>

#include <glm/common.hpp>

namespace inkedge::mesh {
namespace {

struct Box2 {
    glm::dvec2 low;
    glm::dvec2 high;
};

Box2 boxOf(std::span<const Polygon> loops) {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    Box2 box{glm::dvec2{infinite}, glm::dvec2{-infinite}};
    for (const Polygon& loop : loops)
        for (const glm::dvec2& corner : loop) box = {glm::min(box.low, corner), glm::max(box.high, corner)};
    return box;
}

double areaOf(const Box2& box) { return (box.high.x - box.low.x) * (box.high.y - box.low.y); }

bool apart(const Box2& a, const Box2& b) {
    return a.high.x < b.low.x || b.high.x < a.low.x || a.high.y < b.low.y || b.high.y < a.low.y;
}

}  // namespace

// Sutherland and Hodgman.
Polygon withinBox(Polygon polygon, glm::dvec2 low, glm::dvec2 high) {
    for (const int axis : {0, 1}) {
        for (const auto& [border, sign] : {std::pair{low[axis], 1.0}, std::pair{high[axis], -1.0}}) {
            Polygon part;
            for (std::size_t i = 0; i < polygon.size(); ++i) {
                const glm::dvec2 a = polygon[i];
                const glm::dvec2 b = polygon[(i + 1) % polygon.size()];
                const double da = sign * (a[axis] - border);
                const double db = sign * (b[axis] - border);
                if (da >= 0.0) part.push_back(a);
                if ((da > 0.0 && db < 0.0) || (da < 0.0 && db > 0.0)) {
                    glm::dvec2 crossing = a + (da / (da - db)) * (b - a);
                    crossing[axis] = border;
                    part.push_back(crossing);
                }
            }
            polygon = std::move(part);
        }
    }
    return polygon;
}

std::vector<Polygon> beside(const Polygon& polygon, std::span<const Polygon> outline) {
    constexpr double margin = 4.0;  // texels: most edges that meet the polygon keep both ends, and so their rounding
    constexpr double smallPart = 1.0 / 16.0;  // of the outline's box: a larger polygon meets most of it anyway
    std::size_t corners = 0;
    for (const Polygon& loop : outline) corners += loop.size();
    const Box2 box = boxOf({&polygon, 1});
    if (corners <= longOutline || areaOf(box) > smallPart * areaOf(boxOf(outline)))
        return {outline.begin(), outline.end()};
    const Box2 around{box.low - margin, box.high + margin};
    std::vector<Polygon> near;
    for (const Polygon& loop : outline)
        if (!apart(boxOf({&loop, 1}), around)) near.push_back(withinBox(loop, around.low, around.high));
    return near;
}

}  // namespace inkedge::mesh
