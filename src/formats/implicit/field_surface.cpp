#include "formats/implicit/field_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include <inkedge/mesh.h>

namespace inkedge::implicit {

// The field's value at a position, its gradient and its second derivatives.
struct FieldSurface::Local {
    double value;
    glm::dvec3 gradient;
    glm::dmat3 hessian;
};

// By differences: of the middle, both ways along each axis, and both ways along each two axes together.
FieldSurface::Local FieldSurface::localAt(glm::dvec3 p) const {
    constexpr std::array<glm::dvec3, 6> ways{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {1, 0, 1}, {0, 1, 1}}};
    std::array<glm::dvec3, 13> at{};
    std::array<double, 13> v{};
    at[0] = p;
    for (std::size_t i = 0; i < ways.size(); ++i) {
        at[2 * i + 1] = p + step_ * ways[i];
        at[2 * i + 2] = p - step_ * ways[i];
    }
    field_->evaluate(at, v);
    Local local{v[0], {}, {}};
    const auto second = [&](std::size_t i) { return (v[2 * i + 1] - 2.0 * v[0] + v[2 * i + 2]) / (step_ * step_); };
    for (int k = 0; k < 3; ++k) {
        const auto i = static_cast<std::size_t>(k);
        local.gradient[k] = (v[2 * i + 1] - v[2 * i + 2]) / (2.0 * step_);
        local.hessian[k][k] = second(i);
    }
    constexpr int pairs[3][2]{{0, 1}, {0, 2}, {1, 2}};
    for (std::size_t i = 0; i < 3; ++i) {
        const auto [a, b] = pairs[i];
        local.hessian[a][b] = local.hessian[b][a] = 0.5 * (second(i + 3) - local.hessian[a][a] - local.hessian[b][b]);
    }
    return local;
}

std::optional<SurfaceTriangle> FieldSurface::under(const Mesh& mesh, std::uint32_t triangle) const {
    SurfaceTriangle part;
    for (std::size_t k = 0; k < 3; ++k)
        part.corners[k] = mesh.origin + glm::dvec3{mesh.positions[mesh.indices[3 * std::size_t{triangle} + k]]};
    return part;
}

SurfacePoint FieldSurface::at(std::uint32_t, glm::dvec3 position) const {
    constexpr int maxSteps = 3;
    constexpr double straight = 1e-3;  // by which the gradient turns on the way: what is left is its square
    SurfacePoint point;
    for (int i = 0; i < maxSteps; ++i) {
        const Local local = localAt(position);
        const double steepness = glm::length(local.gradient);
        if (!(steepness > 0.0)) return {};
        const glm::dvec3 up = local.gradient / steepness;
        const glm::dvec3 turn = local.hessian * up;
        // The field along the gradient is a parabola.
        const double first = -local.value / steepness;
        const double way = first - 0.5 * glm::dot(turn, up) * first * first / steepness;
        position += way * up;
        point.position = position;
        point.normal = local.gradient + way * turn;
        const glm::dvec3 n = glm::normalize(point.normal);
        point.du = glm::normalize(glm::cross(n, std::abs(n.x) < 0.6 ? glm::dvec3{1, 0, 0} : glm::dvec3{0, 1, 0}));
        point.dv = glm::cross(n, point.du);
        point.normalDu = local.hessian * point.du;
        point.normalDv = local.hessian * point.dv;
        if (std::abs(way) * glm::length(turn) <= straight * steepness) break;
    }
    return point;
}

glm::dvec3 FieldSurface::moved(glm::dvec3, const SurfacePoint& point, glm::dvec2 step) const {
    return point.position + step.x * point.du + step.y * point.dv;
}

}  // namespace inkedge::implicit
