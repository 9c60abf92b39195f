#pragma once

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <glm/geometric.hpp>

#include "mesh/subdivide.h"
#include "mesh/topology.h"
#include "scenes.h"

namespace inkedge::control_meshes {

inline constexpr double smoothAngle = 179.0;  // coarse control meshes bend by more than the usual crease angle

inline LoadSettings levels(int n, double creaseAngle = 30.0) {
    LoadSettings settings;
    settings.subdivide = n;
    settings.creaseAngle = creaseAngle;
    return settings;
}

inline Scene refined(const Mesh& mesh, const LoadSettings& settings) {
    return scenes::sceneOf({{mesh, glm::dmat4{1.0}}}, settings);
}

inline void addQuadsEdges(Mesh& mesh) {
    constexpr EdgeKinds outer;
    constexpr EdgeKinds inner = EdgeKind::Inner;
    mesh.edges.insert(mesh.edges.end(), {outer, outer, inner, inner, outer, outer});
}

inline void addQuad(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    mesh.indices.insert(mesh.indices.end(), {a, b, c, a, c, d});
    addQuadsEdges(mesh);
}

inline Mesh asTriangles(Mesh mesh) {
    mesh.edges.clear();
    return mesh;
}

inline Mesh quadCube() {
    Mesh mesh = scenes::cube();
    for (std::size_t face = 0; face < 6; ++face) addQuadsEdges(mesh);
    return mesh;
}

// Of n x n squares, from -1 to 1 in x and y.
inline Mesh grid(std::uint32_t n) {
    Mesh mesh;
    for (std::uint32_t y = 0; y <= n; ++y)
        for (std::uint32_t x = 0; x <= n; ++x) mesh.positions.emplace_back(2.0 * x / n - 1.0, 2.0 * y / n - 1.0, 0.0);
    for (std::uint32_t y = 0; y < n; ++y)
        for (std::uint32_t x = 0; x < n; ++x)
            addQuad(mesh, y * (n + 1) + x, y * (n + 1) + x + 1, (y + 1) * (n + 1) + x + 1, (y + 1) * (n + 1) + x);
    return mesh;
}

inline constexpr double torusRadius = 1.0;
inline constexpr double tubeRadius = 0.4;

// Vertices on the torus around the z axis, n around it and m around the tube.
inline Mesh torus(std::uint32_t n, std::uint32_t m) {
    Mesh mesh;
    for (std::uint32_t i = 0; i < n; ++i) {
        for (std::uint32_t j = 0; j < m; ++j) {
            const double u = 2.0 * std::numbers::pi * i / n;
            const double v = 2.0 * std::numbers::pi * j / m;
            const double r = torusRadius + tubeRadius * std::cos(v);
            mesh.positions.emplace_back(r * std::cos(u), r * std::sin(u), tubeRadius * std::sin(v));
        }
    }
    for (std::uint32_t i = 0; i < n; ++i)
        for (std::uint32_t j = 0; j < m; ++j)
            addQuad(mesh, i * m + j, (i + 1) % n * m + j, (i + 1) % n * m + (j + 1) % m, i * m + (j + 1) % m);
    return mesh;
}

// Vertices on the unit sphere: an octahedron whose edges are cut into n.
inline Mesh ball(std::uint32_t n) {
    Mesh mesh;
    for (int side = 0; side < 8; ++side) {
        const glm::dvec3 sign{(side & 1) != 0 ? -1 : 1, (side & 2) != 0 ? -1 : 1, (side & 4) != 0 ? -1 : 1};
        const bool mirrored = sign.x * sign.y * sign.z < 0.0;
        const auto add = [&](std::uint32_t i, std::uint32_t j) {
            mesh.indices.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
            mesh.positions.emplace_back(sign * glm::normalize(glm::dvec3{i, j, n - i - j}));
        };
        const auto triangle = [&](glm::uvec2 a, glm::uvec2 b, glm::uvec2 c) {
            if (mirrored) std::swap(b, c);
            for (const glm::uvec2 p : {a, b, c}) add(p.x, p.y);
        };
        for (std::uint32_t i = 0; i < n; ++i)
            for (std::uint32_t j = 0; i + j < n; ++j) {
                triangle({i, j}, {i + 1, j}, {i, j + 1});
                if (i + j + 1 < n) triangle({i + 1, j}, {i + 1, j + 1}, {i, j + 1});
            }
    }
    return mesh;
}

inline glm::dvec3 corner(const Mesh& mesh, std::size_t c) { return glm::dvec3{mesh.positions[mesh.indices[c]]}; }

}  // namespace inkedge::control_meshes
