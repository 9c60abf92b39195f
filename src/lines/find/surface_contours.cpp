#include "lines/find/surface_contours.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace inkedge::lines {
namespace {

glm::dvec3 acrossOf(const SurfacePoint& point) { return glm::cross(point.du, point.dv); }

}  // namespace

double SurfaceContours::viewDot(std::uint32_t face, glm::dvec2 parameters, glm::dvec3& position) const {
    const SurfacePoint point = mesh_.surfaces->at(face, parameters);
    position = point.position - mesh_.origin;
    return glm::dot(acrossOf(point), view_.eye.view(position));
}

SurfaceContours::Point SurfaceContours::crossing(std::uint32_t triangle, std::array<std::uint32_t, 2> ends,
                                                 glm::dvec3 linear) const {
    const std::uint32_t face = mesh_.faces[triangle];
    std::ranges::sort(ends);  // the same point from both triangles of the edge
    const std::array<glm::dvec2, 2> uv{mesh_.parameters[ends[0]], mesh_.parameters[ends[1]]};
    Point point{linear, 0.5 * (uv[0] + uv[1])};
    if (!mesh_.surfaces->knows(face)) return point;
    // The false position, where an end that stays counts half: Illinois.
    constexpr int maxSteps = 30;
    constexpr double enough = 1e-12;
    double low = 0.0;
    double high = 1.0;
    double atLow = viewDot(face, uv[0], point.position);
    double atHigh = viewDot(face, uv[1], point.position);
    const double scale = std::max(std::abs(atLow), std::abs(atHigh));
    point.position = linear;
    if (!(atLow * atHigh < 0.0)) return point;
    int last = 0;
    for (int i = 0; i < maxSteps; ++i) {
        const double at = low + (high - low) * atLow / (atLow - atHigh);
        point.parameters = uv[0] + at * (uv[1] - uv[0]);
        const double found = viewDot(face, point.parameters, point.position);
        if (std::abs(found) <= enough * scale || high - low < enough) break;
        if ((found < 0.0) == (atLow < 0.0)) {
            low = at;
            atLow = found;
            if (last < 0) atHigh *= 0.5;
            last = -1;
        } else {
            high = at;
            atHigh = found;
            if (last > 0) atLow *= 0.5;
            last = 1;
        }
    }
    point.exact = true;
    return point;
}

// Newton's method on f(u, v) = (x_u x x_v) . (x - C), each step the shortest on the surface.
SurfaceContours::Point SurfaceContours::moved(std::uint32_t face, glm::dvec2 parameters, double reach) const {
    constexpr int maxSteps = 8;
    constexpr double enough = 1e-6;  // of the reach
    Point result{{}, parameters};
    double way = 0.0;
    for (int i = 0; i < maxSteps; ++i) {
        const SurfacePoint p = mesh_.surfaces->at(face, result.parameters);
        result.position = p.position - mesh_.origin;
        const glm::dvec3 seen = view_.eye.view(result.position);
        const double f = glm::dot(acrossOf(p), seen);
        // x - C grows along the surface only, across its normal.
        const glm::dvec2 gradient{glm::dot(glm::cross(p.duu, p.dv) + glm::cross(p.du, p.duv), seen),
                                  glm::dot(glm::cross(p.duv, p.dv) + glm::cross(p.du, p.dvv), seen)};
        const double e = glm::dot(p.du, p.du);
        const double m = glm::dot(p.du, p.dv);
        const double g = glm::dot(p.dv, p.dv);
        const double determinant = e * g - m * m;
        if (!(determinant > 0.0)) return result;
        const glm::dvec2 direction =
            glm::dvec2{g * gradient.x - m * gradient.y, e * gradient.y - m * gradient.x} / determinant;
        const double slope = glm::dot(gradient, direction);
        if (!(slope > 0.0)) return result;
        const glm::dvec2 step = -f / slope * direction;
        const double length = glm::length(step.x * p.du + step.y * p.dv);
        if (length <= enough * reach) {
            result.exact = true;
            return result;
        }
        way += length;
        if (!(way <= reach)) return result;
        result.parameters += step;
    }
    return result;
}

void SurfaceContours::divide(std::uint32_t face, const Point& from, const Point& to, int depth,
                             std::vector<glm::dvec3>& points) const {
    constexpr int maxDepth = 6;
    const glm::dvec3 a = view_.world(from.position);
    const glm::dvec3 b = view_.world(to.position);
    if (depth >= maxDepth || screen_.depth(a) <= screen_.near() || screen_.depth(b) <= screen_.near()) return;
    const Point middle =
        moved(face, 0.5 * (from.parameters + to.parameters), glm::distance(from.position, to.position));
    if (!middle.exact) return;
    const glm::dvec3 m = view_.world(middle.position);
    if (screen_.depth(m) <= screen_.near()) return;
    const glm::dvec2 p = screen_.project(a).pixel;
    const glm::dvec2 along = screen_.project(b).pixel - p;
    const glm::dvec2 off = screen_.project(m).pixel - p;
    const double length = glm::length(along);
    const double stray = length > 0.0 ? std::abs(along.x * off.y - along.y * off.x) / length : glm::length(off);
    if (stray <= maxStray) return;
    divide(face, from, middle, depth + 1, points);
    points.push_back(middle.position);
    divide(face, middle, to, depth + 1, points);
}

std::vector<glm::dvec3> SurfaceContours::between(std::uint32_t triangle, const Point& from, const Point& to) const {
    std::vector<glm::dvec3> points{from.position};
    if (from.exact && to.exact) divide(mesh_.faces[triangle], from, to, 0, points);
    points.push_back(to.position);
    return points;
}

}  // namespace inkedge::lines
