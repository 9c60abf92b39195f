#include "lines/find/surface_contours.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <glm/geometric.hpp>

namespace inkedge::lines {
namespace {

glm::dvec3 acrossOf(const SurfacePoint& point) { return glm::cross(point.du, point.dv); }

// A field's value at a position, its gradient and its second derivatives, by differences.
struct FieldPoint {
    double value;
    glm::dvec3 gradient;
    glm::dmat3 hessian;
};
FieldPoint fieldAt(const ScalarField& field, glm::dvec3 p, double step) {
    // The middle, both ways along each axis, and both ways along each two axes together.
    constexpr std::array<glm::dvec3, 6> ways{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {1, 0, 1}, {0, 1, 1}}};
    std::array<glm::dvec3, 13> at{};
    std::array<double, 13> v{};
    at[0] = p;
    for (std::size_t i = 0; i < ways.size(); ++i) {
        at[2 * i + 1] = p + step * ways[i];
        at[2 * i + 2] = p - step * ways[i];
    }
    field.evaluate(at, v);
    FieldPoint point{v[0], {}, {}};
    const auto second = [&](std::size_t i) { return (v[2 * i + 1] - 2.0 * v[0] + v[2 * i + 2]) / (step * step); };
    for (int k = 0; k < 3; ++k) {
        const auto i = static_cast<std::size_t>(k);
        point.gradient[k] = (v[2 * i + 1] - v[2 * i + 2]) / (2.0 * step);
        point.hessian[k][k] = second(i);
    }
    constexpr int pairs[3][2]{{0, 1}, {0, 2}, {1, 2}};
    for (std::size_t i = 0; i < 3; ++i) {
        const auto [a, b] = pairs[i];
        point.hessian[a][b] = point.hessian[b][a] = 0.5 * (second(i + 3) - point.hessian[a][a] - point.hessian[b][b]);
    }
    return point;
}

}  // namespace

double SurfaceContours::viewDot(std::uint32_t face, glm::dvec2 parameters, glm::dvec3& position) const {
    const SurfacePoint point = mesh_.surfaces->at(face, parameters);
    position = point.position - mesh_.origin;
    return glm::dot(acrossOf(point), view_.eye.view(position));
}

SurfaceContours::Point SurfaceContours::crossing(std::uint32_t triangle, std::array<std::uint32_t, 2> ends,
                                                 glm::dvec3 linear) const {
    if (mesh_.field)
        return movedInField(linear,
                            glm::distance(glm::dvec3{mesh_.positions[ends[0]]}, glm::dvec3{mesh_.positions[ends[1]]}));
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

// Newton's method on f = 0 and g . (x - C) = 0, where g is the gradient of f: each step is the shortest that leads to
// both in a linear f. Bremer and Hughes 1998.
SurfaceContours::Point SurfaceContours::movedInField(glm::dvec3 start, double reach) const {
    constexpr int maxSteps = 8;
    constexpr double enough = 1e-6;  // of the reach
    constexpr double ofReach = 1e-3;
    Point result{start, {}};
    if (!(reach > 0.0)) return result;
    glm::dvec3 at = start;
    for (int i = 0; i < maxSteps; ++i) {
        const FieldPoint p = fieldAt(*mesh_.field, at + mesh_.origin, ofReach * reach);
        const glm::dvec3 seen = view_.eye.view(at);
        glm::dvec3 grows = p.hessian * seen;  // g . (x - C)
        if (!view_.eye.orthographic) grows += p.gradient;
        const double gg = glm::dot(p.gradient, p.gradient);
        const double gn = glm::dot(p.gradient, grows);
        const double nn = glm::dot(grows, grows);
        const double determinant = gg * nn - gn * gn;
        if (!(determinant > 1e-12 * gg * nn)) return result;
        const double turn = glm::dot(p.gradient, seen);
        const double a = (nn * p.value - gn * turn) / determinant;
        const double b = (gg * turn - gn * p.value) / determinant;
        const glm::dvec3 step = -a * p.gradient - b * grows;
        at += step;
        if (!(glm::distance(at, start) <= reach)) return result;
        if (glm::length(step) > enough * reach) continue;
        result.position = at;
        result.exact = true;
        return result;
    }
    return result;
}

void SurfaceContours::divide(std::uint32_t face, const Point& from, const Point& to, int depth,
                             std::vector<glm::dvec3>& points) const {
    constexpr int maxDepth = 6;
    const glm::dvec3 a = view_.world(from.position);
    const glm::dvec3 b = view_.world(to.position);
    if (depth >= maxDepth || screen_.depth(a) <= screen_.near() || screen_.depth(b) <= screen_.near()) return;
    const double reach = glm::distance(from.position, to.position);
    const Point middle = mesh_.field ? movedInField(0.5 * (from.position + to.position), reach)
                                     : moved(face, 0.5 * (from.parameters + to.parameters), reach);
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
    if (from.exact && to.exact) divide(mesh_.field ? 0 : mesh_.faces[triangle], from, to, 0, points);
    points.push_back(to.position);
    return points;
}

}  // namespace inkedge::lines
