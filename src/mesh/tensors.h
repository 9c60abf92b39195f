#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace inkedge::mesh {

/// A symmetric tensor of two axes: 11, 12, 22. And of three: 111, 112, 122, 222.
using Tensor2 = std::array<double, 3>;
using Tensor3 = std::array<double, 4>;

struct Frame {
    glm::dvec3 u;
    glm::dvec3 v;
    glm::dvec3 normal;
};

/// Any two axes at right angles to a normal: Duff et al. 2017.
inline Frame frameOf(glm::dvec3 n) {
    const double sign = std::copysign(1.0, n.z);
    const double a = -1.0 / (sign + n.z);
    const double b = n.x * n.y * a;
    return {{1.0 + sign * n.x * n.x * a, sign * b, -sign * n.x}, {b, sign + n.y * n.y * a, -n.y}, n};
}

/// The axes of one frame turned, the shortest way, into the plane of another, as coordinates there.
struct Turned {
    glm::dvec2 u;
    glm::dvec2 v;
};
inline std::optional<Turned> turnedInto(const Frame& from, const Frame& to) {
    const double cosine = glm::dot(from.normal, to.normal);
    if (cosine < -0.99) return std::nullopt;  // there is no shortest way
    const auto turned = [&](glm::dvec3 axis) {
        const glm::dvec3 there = axis - glm::dot(to.normal, axis) / (1.0 + cosine) * (from.normal + to.normal);
        return glm::dvec2{glm::dot(there, to.u), glm::dot(there, to.v)};
    };
    return Turned{turned(from.u), turned(from.v)};
}

inline double along(const Tensor2& t, glm::dvec2 x, glm::dvec2 y) {
    return t[0] * x.x * y.x + t[1] * (x.x * y.y + x.y * y.x) + t[2] * x.y * y.y;
}
inline double along(const Tensor3& t, glm::dvec2 x, glm::dvec2 y, glm::dvec2 z) {
    return along(Tensor2{t[0] * x.x + t[1] * x.y, t[1] * x.x + t[2] * x.y, t[2] * x.x + t[3] * x.y}, y, z);
}

/// The same tensors of the axes of space, which can be averaged where frames differ: xx, xy, xz, yy, yz, zz; and xxx,
/// xxy, xxz, xyy, xyz, xzz, yyy, yyz, yzz, zzz.
using SpaceTensor2 = std::array<float, 6>;
using SpaceTensor3 = std::array<float, 10>;

/// The coordinates of the axes of space in a frame.
inline std::array<glm::dvec2, 3> axesIn(const Frame& frame) {
    return {{{frame.u.x, frame.v.x}, {frame.u.y, frame.v.y}, {frame.u.z, frame.v.z}}};
}

inline SpaceTensor2 inSpaceOf(const Tensor2& tensor, const Frame& frame) {
    const std::array<glm::dvec2, 3> axes = axesIn(frame);
    SpaceTensor2 inSpace{};
    std::size_t next = 0;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = i; j < 3; ++j) inSpace[next++] = static_cast<float>(along(tensor, axes[i], axes[j]));
    return inSpace;
}

inline SpaceTensor3 inSpaceOf(const Tensor3& tensor, const Frame& frame) {
    const std::array<glm::dvec2, 3> axes = axesIn(frame);
    SpaceTensor3 inSpace{};
    std::size_t next = 0;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = i; j < 3; ++j)
            for (std::size_t k = j; k < 3; ++k)
                inSpace[next++] = static_cast<float>(along(tensor, axes[i], axes[j], axes[k]));
    return inSpace;
}

/// What of a tensor lies in a frame's plane.
inline Tensor2 inFrame(const SpaceTensor2& inSpace, const Frame& frame) {
    const std::array<glm::dvec2, 3> axes = axesIn(frame);
    Tensor2 sum{};
    std::size_t next = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = i; j < 3; ++j) {
            const double value = (i == j ? 1.0 : 2.0) * static_cast<double>(inSpace[next++]);
            sum[0] += value * axes[i].x * axes[j].x;
            sum[1] += value * 0.5 * (axes[i].x * axes[j].y + axes[i].y * axes[j].x);
            sum[2] += value * axes[i].y * axes[j].y;
        }
    }
    return sum;
}

inline Tensor3 inFrame(const SpaceTensor3& inSpace, const Frame& frame) {
    constexpr std::array<std::array<std::size_t, 9>, 3> components{
        {{0, 1, 2, 1, 3, 4, 2, 4, 5}, {1, 3, 4, 3, 6, 7, 4, 7, 8}, {2, 4, 5, 4, 7, 8, 5, 8, 9}}};
    const std::array<glm::dvec2, 3> axes = axesIn(frame);
    Tensor3 sum{};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t jk = 0; jk < 9; ++jk) {
            const auto value = static_cast<double>(inSpace[components[i][jk]]);
            const glm::dvec2 a = axes[i];
            const glm::dvec2 b = axes[jk / 3];
            const glm::dvec2 c = axes[jk % 3];
            sum[0] += value * a.x * b.x * c.x;
            sum[1] += value * a.x * b.x * c.y;
            sum[2] += value * a.x * b.y * c.y;
            sum[3] += value * a.y * b.y * c.y;
        }
    }
    return sum;
}

/// Solves the normal equations of a symmetric tensor's differences along edges: off the diagonal only the neighbours.
template <std::size_t n>
std::array<double, n> solveTridiagonal(std::array<double, n> diagonal, double beside, std::array<double, n> right) {
    for (std::size_t i = 1; i < n; ++i) {
        if (diagonal[i - 1] == 0.0) return {};
        const double factor = beside / diagonal[i - 1];
        diagonal[i] -= factor * beside;
        right[i] -= factor * right[i - 1];
    }
    if (!(diagonal[n - 1] > 1e-12 * diagonal[0])) return {};  // the edges have one direction
    for (std::size_t i = n; i-- > 0;) {
        if (i + 1 < n) right[i] -= beside * right[i + 1];
        right[i] /= diagonal[i];
    }
    return right;
}

/// The shares of a triangle's area that are nearest to its corners: Meyer et al. 2002.
inline std::array<double, 3> voronoiShares(const std::array<glm::dvec3, 3>& p, double area) {
    std::array<double, 3> squares{};
    for (std::size_t k = 0; k < 3; ++k) {
        const glm::dvec3 opposite = p[(k + 2) % 3] - p[(k + 1) % 3];
        squares[k] = glm::dot(opposite, opposite);
    }
    std::array<double, 3> shares{};
    for (std::size_t k = 0; k < 3; ++k) {
        if (squares[k] >= squares[(k + 1) % 3] + squares[(k + 2) % 3]) {  // an obtuse angle
            shares.fill(0.25 * area);
            shares[k] = 0.5 * area;
            return shares;
        }
    }
    for (std::size_t k = 0; k < 3; ++k) {
        const auto cotangent = [&](std::size_t at) {
            return (squares[(at + 1) % 3] + squares[(at + 2) % 3] - squares[at]) / (4.0 * area);
        };
        const std::size_t a = (k + 1) % 3;
        const std::size_t b = (k + 2) % 3;
        shares[k] = (squares[a] * cotangent(a) + squares[b] * cotangent(b)) / 8.0;
    }
    return shares;
}

}  // namespace inkedge::mesh
