#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <inkedge/mesh.h>

namespace inkedge::curved {

/// A cube of n x n squares a side, blown up to a sphere of radius 1 and stretched: triangles of about one size, welded
/// by position.
inline Mesh ellipsoid(glm::dvec3 axes, int n) {
    Mesh mesh;
    mesh.name = "ellipsoid";
    const auto onSphere = [&](int side, int i, int j) {
        // Equal angles rather than equal lengths: squares in the corners are not much smaller.
        const auto at = [&](int k) { return std::tan(0.25 * std::numbers::pi * (2.0 * k - n) / n); };
        const double out = side < 3 ? 1.0 : -1.0;
        const int axis = side % 3;
        glm::dvec3 p{0.0};
        p[axis] = out;
        p[(axis + 1) % 3] = at(i) * out;
        p[(axis + 2) % 3] = at(j);
        return axes * glm::normalize(p);
    };
    for (int side = 0; side < 6; ++side) {
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        for (int i = 0; i <= n; ++i)
            for (int j = 0; j <= n; ++j) mesh.positions.emplace_back(onSphere(side, i, j));
        const auto vertex = [&](int i, int j) { return first + static_cast<std::uint32_t>(i * (n + 1) + j); };
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j)
                mesh.indices.insert(mesh.indices.end(), {vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1),
                                                         vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
    }
    return mesh;
}

/// A sheet z = height(x, y) over -1..1 along x and y, of n x n squares, its front up.
template <class Height>
Mesh sheet(int n, Height&& height) {
    Mesh mesh;
    mesh.name = "sheet";
    for (int i = 0; i <= n; ++i) {
        for (int j = 0; j <= n; ++j) {
            const glm::dvec2 p{2.0 * i / n - 1.0, 2.0 * j / n - 1.0};
            mesh.positions.emplace_back(p.x, p.y, height(p.x, p.y));
        }
    }
    const auto vertex = [&](int i, int j) { return static_cast<std::uint32_t>(i * (n + 1) + j); };
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            if ((i + j) % 2 == 0)
                mesh.indices.insert(mesh.indices.end(), {vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1),
                                                         vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
            else
                mesh.indices.insert(mesh.indices.end(), {vertex(i, j), vertex(i + 1, j), vertex(i, j + 1),
                                                         vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
        }
    }
    return mesh;
}

/// The curvature tensor of the surface F = 0 in space, over 0 where it bulges towards F > 0.
inline glm::dmat3 tensorOf(glm::dvec3 gradient, const glm::dmat3& hessian) {
    const double length = glm::length(gradient);
    const glm::dvec3 n = gradient / length;
    const glm::dmat3 tangent = glm::dmat3{1.0} - glm::outerProduct(n, n);
    return tangent * hessian * tangent / length;
}

/// Of the ellipsoid through p of given axes.
struct EllipsoidAt {
    glm::dvec3 axes;
    [[nodiscard]] glm::dvec3 normal(glm::dvec3 p) const { return glm::normalize(p / (axes * axes)); }
    [[nodiscard]] glm::dmat3 tensor(glm::dvec3 p) const {
        glm::dmat3 hessian{0.0};
        for (int k = 0; k < 3; ++k) hessian[k][k] = 1.0 / (axes[k] * axes[k]);
        return tensorOf(p / (axes * axes), hessian);
    }
    /// How fast a component of the tensor, along two tangent directions, grows along a third.
    [[nodiscard]] double derivative(glm::dvec3 p, glm::dvec3 along, glm::dvec3 x, glm::dvec3 y) const {
        constexpr double step = 1e-4;
        const auto at = [&](double way) {
            glm::dvec3 q = p + way * along;
            q /= glm::length(q / axes);  // back onto the surface: by the square of the step
            return glm::dot(x, tensor(q) * y);
        };
        return (at(step) - at(-step)) / (2.0 * step);
    }
};

}  // namespace inkedge::curved
