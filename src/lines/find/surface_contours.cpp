#include "lines/find/surface_contours.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace inkedge::lines {
namespace {

bool isPole(glm::dvec3 parameters) { return std::isnan(parameters.x) || std::isnan(parameters.y); }

// At a pole all values of a parameter are one point: it takes that of the other.
std::pair<glm::dvec3, glm::dvec3> together(glm::dvec3 a, glm::dvec3 b) {
    for (int i = 0; i < 2; ++i) {
        if (std::isnan(a[i])) a[i] = b[i];
        if (std::isnan(b[i])) b[i] = a[i];
    }
    return {a, b};
}

}  // namespace

// A curve on a surface, linear in its parameters.
struct SurfaceContours::Edge {
    std::uint32_t face;
    std::pair<glm::dvec3, glm::dvec3> parameters;
    [[nodiscard]] glm::dvec3 at(double share) const { return glm::mix(parameters.first, parameters.second, share); }
};

// n . (x - C) there, and x.
struct SurfaceContours::Sample {
    double share;
    double viewDot;
    glm::dvec3 position;
};

SurfaceContours::Sample SurfaceContours::sample(const Edge& edge, double share) const {
    const SurfacePoint point = surfaces_.at(edge.face, edge.at(share));
    const glm::dvec3 position = point.position - origin_;
    return {share, glm::dot(point.normal, view_.eye.view(position)), position};
}

SurfaceContours::Point SurfaceContours::crossing(const SurfaceTriangle& triangle, std::uint32_t corner,
                                                 const std::array<glm::dvec3, 3>& corners, glm::dvec3 linear) const {
    constexpr double aside = 1e-6;    // of the edge: a pole itself has no normal
    constexpr double believed = 0.3;  // of the edge: a surface that is farther from its ends is not theirs
    std::array<std::size_t, 2> ends{corner, (corner + 1) % 3};
    const auto order = [&](std::size_t k) { return std::tuple{corners[k].x, corners[k].y, corners[k].z}; };
    if (order(ends[1]) < order(ends[0])) std::swap(ends[0], ends[1]);  // the same point from both triangles of the edge
    const std::array<bool, 2> poles{isPole(triangle.corners[ends[0]]), isPole(triangle.corners[ends[1]])};
    const Edge edge{triangle.face, together(triangle.corners[ends[0]], triangle.corners[ends[1]])};
    const Sample low = sample(edge, poles[0] ? aside : 0.0);
    const Sample high = sample(edge, poles[1] ? 1.0 - aside : 1.0);
    const double reach = glm::distance(corners[ends[0]], corners[ends[1]]);
    Point point{linear, edge.at(0.5)};
    const bool isTheirs = glm::distance(low.position, corners[ends[0]]) <= believed * reach &&
                          glm::distance(high.position, corners[ends[1]]) <= believed * reach;
    if (!isTheirs) return point;
    if (low.viewDot * high.viewDot < 0.0) {
        narrow(edge, low, high, point);
        return point;
    }
    // It passes through an end: a pole, around which the normal turns at once, or beside one where rounding decides.
    if (poles[0] != poles[1]) {
        const std::size_t end = ends[poles[1] ? 1 : 0];
        return {corners[end], triangle.corners[end], true};
    }
    const double nearest = std::abs(low.viewDot) < std::abs(high.viewDot) ? 0.0 : 1.0;
    const Point beside = moved(edge.face, edge.at(nearest), reach);
    return beside.exact && areTogether(beside.position, corners[ends[nearest == 0.0 ? 0 : 1]]) ? beside : point;
}

// The false position, where an end that stays counts half: Illinois (Dowell and Jarratt 1971).
void SurfaceContours::narrow(const Edge& edge, Sample low, Sample high, Point& point) const {
    constexpr int maxSteps = 30;
    constexpr double enough = 1e-10;
    const double scale = std::max(std::abs(low.viewDot), std::abs(high.viewDot));
    int last = 0;
    for (int i = 0; i < maxSteps; ++i) {
        const double share = low.share + (high.share - low.share) * low.viewDot / (low.viewDot - high.viewDot);
        const Sample found = sample(edge, share);
        point = {found.position, edge.at(share), true};
        if (std::abs(found.viewDot) <= enough * scale || high.share - low.share < enough) return;
        const bool isLow = (found.viewDot < 0.0) == (low.viewDot < 0.0);
        if (last == (isLow ? -1 : 1)) (isLow ? high : low).viewDot *= 0.5;
        (isLow ? low : high) = found;
        last = isLow ? -1 : 1;
    }
}

// Newton's method on f(u, v) = n . (x - C), each step the shortest on the surface.
SurfaceContours::Point SurfaceContours::moved(std::uint32_t face, glm::dvec3 parameters, double reach) const {
    constexpr int maxSteps = 8;
    constexpr double enough = 1e-6;  // of the reach
    Point result{{}, parameters};
    double way = 0.0;
    for (int i = 0; i < maxSteps; ++i) {
        const SurfacePoint p = surfaces_.at(face, result.parameters);
        result.position = p.position - origin_;
        const glm::dvec3 seen = view_.eye.view(result.position);
        const double f = glm::dot(p.normal, seen);
        // x - C grows along the surface only, across its normal.
        const glm::dvec2 gradient{glm::dot(p.normalDu, seen), glm::dot(p.normalDv, seen)};
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
        result.parameters = surfaces_.moved(result.parameters, p, step);
    }
    return result;
}

// Whether two points are a pixel apart or less. A cylinder seen along its axis is edge-on all round, but for rounding:
// its contour may be anywhere then.
bool SurfaceContours::areTogether(glm::dvec3 a, glm::dvec3 b) const {
    const glm::dvec3 worldA = view_.world(a);
    const glm::dvec3 worldB = view_.world(b);
    if (std::min(screen_.depth(worldA), screen_.depth(worldB)) <= screen_.near()) return false;
    return glm::distance(screen_.project(worldA).pixel, screen_.project(worldB).pixel) <= 1.0;
}

// How far the middle lies from the straight piece in the picture, pixels; 0: some of it is not before the camera.
double SurfaceContours::stray(const Point& from, const Point& to, const Point& middle) const {
    std::array<glm::dvec2, 3> pixels{};
    for (std::size_t i = 0; const Point* const point : {&from, &to, &middle}) {
        const glm::dvec3 world = view_.world(point->position);
        if (screen_.depth(world) <= screen_.near()) return 0.0;
        pixels[i++] = screen_.project(world).pixel;
    }
    const glm::dvec2 along = pixels[1] - pixels[0];
    const glm::dvec2 off = pixels[2] - pixels[0];
    const double square = glm::dot(along, along);
    // Where the contour runs towards the eye its picture turns back in a cusp, beyond both ends.
    const double share = square > 0.0 ? std::clamp(glm::dot(off, along) / square, 0.0, 1.0) : 0.0;
    return glm::length(off - share * along);
}

void SurfaceContours::divide(std::uint32_t face, const Point& from, const Point& to, int depth,
                             std::vector<glm::dvec3>& points) const {
    constexpr int maxDepth = 6;
    if (depth >= maxDepth) return;
    const auto [a, b] = together(from.parameters, to.parameters);
    const Point middle = moved(face, 0.5 * (a + b), glm::distance(from.position, to.position));
    if (!middle.exact || stray(from, to, middle) <= maxStray) return;
    divide(face, from, middle, depth + 1, points);
    points.push_back(middle.position);
    divide(face, middle, to, depth + 1, points);
}

std::vector<glm::dvec3> SurfaceContours::between(std::uint32_t face, const Point& from, const Point& to) const {
    std::vector<glm::dvec3> points{from.position};
    if (from.exact && to.exact) divide(face, from, to, 0, points);
    points.push_back(to.position);
    return points;
}

}  // namespace inkedge::lines
