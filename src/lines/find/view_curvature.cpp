#include "lines/find/view_curvature.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/mat2x2.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>

namespace inkedge::lines {
namespace {

constexpr double headOn = 1e-6;  // a sine: under it the surface lies across the view, and w has no direction

// The tangent axes along the view, and across it.
struct ViewAxes {
    glm::dvec3 normal;
    glm::dvec3 along;  // w / |w|
    glm::dvec3 across;
    double cosine;
    double sine;
};

ViewAxes axesOf(const mesh::PointForm& point, glm::dvec3 toEye) {
    ViewAxes axes;
    axes.normal = glm::dvec3{point.normal};
    const glm::dvec3 v = glm::normalize(toEye);
    axes.cosine = glm::dot(axes.normal, v);
    const glm::dvec3 w = v - axes.cosine * axes.normal;
    axes.sine = glm::length(w);
    axes.along = axes.sine > headOn ? w / axes.sine : glm::dvec3{point.first};
    axes.across = glm::cross(axes.normal, axes.along);
    return axes;
}

// The tensor and its derivative along the axes of the view.
struct Tensors {
    std::array<double, 3> curvature;   // 11, 12, 22
    std::array<double, 4> derivative;  // 111, 112, 122, 222
};

Tensors tensorsOf(const mesh::PointForm& point, const ViewAxes& axes) {
    const double c = glm::dot(axes.along, glm::dvec3{point.first});
    const double s = glm::dot(axes.along, glm::cross(axes.normal, glm::dvec3{point.first}));
    const auto k1 = static_cast<double>(point.curvatures[0]);
    const auto k2 = static_cast<double>(point.curvatures[1]);
    std::array<double, 4> d{};
    std::ranges::transform(point.derivative, d.begin(), [](float v) { return static_cast<double>(v); });
    const auto cubic = [&](glm::dvec2 x, glm::dvec2 y, glm::dvec2 z) {
        return d[0] * x.x * y.x * z.x + d[1] * (x.x * y.x * z.y + x.x * y.y * z.x + x.y * y.x * z.x) +
               d[2] * (x.x * y.y * z.y + x.y * y.x * z.y + x.y * y.y * z.x) + d[3] * x.y * y.y * z.y;
    };
    const glm::dvec2 a{c, s};
    const glm::dvec2 b{-s, c};
    return {{k1 * c * c + k2 * s * s, (k2 - k1) * c * s, k1 * s * s + k2 * c * c},
            {cubic(a, a, a), cubic(a, a, b), cubic(a, b, b), cubic(b, b, b)}};
}

}  // namespace

RadialCurvature radialCurvature(const mesh::PointForm& point, glm::dvec3 toEye) {
    const ViewAxes axes = axesOf(point, toEye);
    const Tensors tensors = tensorsOf(point, axes);
    return {axes.cosine, axes.sine, tensors.curvature[0], tensors.curvature[1], tensors.derivative[0]};
}

// C(w, w, w) + 2 K cot(theta); where the radial curvature is 0, K is the torsion's square below 0.
double growthTowardsEye(const RadialCurvature& radial) {
    const double sign = radial.cosine < 0.0 ? -1.0 : 1.0;
    const double cotangent = std::abs(radial.cosine) / std::max(radial.sine, headOn);
    return sign * radial.derivative - 2.0 * radial.torsion * radial.torsion * cotangent;
}

// Q = S P^-1: S the curvature tensor, P the projection of the tangent plane to the picture. Its greatest singular value
// is the curvature, whose derivative follows from those of S, of the angle to the view, and of the direction w.
ApparentCurvature apparentCurvature(const mesh::PointForm& point, glm::dvec3 toEye, bool orthographic) {
    constexpr double edgeOn = 1e-3;
    const ViewAxes axes = axesOf(point, toEye);
    const auto& [curvature, derivative] = tensorsOf(point, axes);
    const double cosine = std::max(std::abs(axes.cosine), edgeOn);
    const double sign = axes.cosine < 0.0 ? -1.0 : 1.0;
    const double secant = 1.0 / cosine;
    const glm::dmat2 s{curvature[0], curvature[1], curvature[1], curvature[2]};
    const glm::dmat2 stretch{secant, 0.0, 0.0, 1.0};
    const glm::dmat2 q = s * stretch;
    const glm::dmat2 square = glm::transpose(q) * q;
    const double angle = 0.5 * std::atan2(2.0 * square[1][0], square[0][0] - square[1][1]);
    const glm::dvec2 t{std::cos(angle), std::sin(angle)};
    const glm::dvec2 turned = q * t;
    ApparentCurvature seen{std::max(axes.cosine * sign, 0.0), glm::length(turned), {}, 0.0};
    const glm::dvec2 x = stretch * t;
    seen.direction = glm::normalize(x.x * axes.along + x.y * axes.across);
    if (seen.curvature == 0.0) return seen;
    const double perLength = orthographic ? 0.0 : 1.0 / glm::length(toEye);
    const glm::dvec2 bends = s * x;
    const double cosineGrowth = sign * axes.sine * (bends.x + axes.cosine * perLength * x.x);
    const double secantGrowth = -cosineGrowth * secant * secant;
    const double turn = axes.sine > headOn ? -(axes.cosine * bends.y + perLength * x.y) / axes.sine : 0.0;
    const double aside = (secant - 1.0) * turn;
    const glm::dmat2 stretchGrowth{secantGrowth, aside, aside, 0.0};
    const auto& d = derivative;
    const glm::dmat2 growth{d[0] * x.x + d[1] * x.y, d[1] * x.x + d[2] * x.y, d[1] * x.x + d[2] * x.y,
                            d[2] * x.x + d[3] * x.y};
    seen.derivative = glm::dot(turned / seen.curvature, (growth * stretch + s * stretchGrowth) * t);
    return seen;
}

}  // namespace inkedge::lines
