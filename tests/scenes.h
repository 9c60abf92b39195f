#pragma once

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

#include <inkedge/camera.h>
#include <inkedge/scene.h>

/// Small scenes whose pictures can be worked out by hand.
namespace inkedge::scenes {

/// Meshes instances once each, by their transforms.
inline Scene sceneOf(const std::vector<std::pair<Mesh, glm::dmat4>>& instances, const LoadSettings& settings = {}) {
    Scene::Data data;
    for (const auto& [mesh, transform] : instances) {
        data.instances.push_back({mesh.name, static_cast<std::uint32_t>(data.meshes.size()), transform});
        data.meshes.push_back(mesh);
    }
    return Scene{std::move(data), settings};
}

inline Scene sceneOf(const Mesh& mesh, const glm::dmat4& transform = glm::dmat4{1.0}) {
    return sceneOf({{mesh, transform}});
}

/// An axis-aligned box around the origin, welded, without normals. Corner i has its x, y, z on the positive side where
/// bits 0, 1, 2 of i are set.
inline Mesh box(glm::dvec3 sides) {
    Mesh mesh;
    mesh.name = "box";
    for (int i = 0; i < 8; ++i) {
        const glm::dvec3 sign{(i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1, (i & 4) != 0 ? 1 : -1};
        mesh.positions.emplace_back(0.5 * sign * sides);
    }
    mesh.indices = {0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4,
                    2, 6, 7, 2, 7, 3, 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6};
    return mesh;
}

inline Mesh cube(double side = 2.0) { return box({side, side, side}); }

/// A sphere about the origin with its exact normals; poles on the y axis. segments around, segments / 2 from pole to
/// pole.
inline Mesh sphere(double radius = 1.0, std::uint32_t segments = 64) {
    Mesh mesh;
    mesh.name = "sphere";
    const std::uint32_t rings = segments / 2;
    for (std::uint32_t r = 0; r <= rings; ++r) {
        for (std::uint32_t s = 0; s <= segments; ++s) {
            const double polar = std::numbers::pi * r / rings;
            const double around = 2.0 * std::numbers::pi * s / segments;
            const glm::dvec3 n{std::sin(polar) * std::sin(around), std::cos(polar), std::sin(polar) * std::cos(around)};
            mesh.positions.emplace_back(radius * n);
            mesh.normals.emplace_back(n);
        }
    }
    const auto vertex = [&](std::uint32_t r, std::uint32_t s) { return r * (segments + 1) + s; };
    for (std::uint32_t r = 0; r < rings; ++r) {
        for (std::uint32_t s = 0; s < segments; ++s) {
            const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
                mesh.indices.insert(mesh.indices.end(), {a, b, c});
            };
            if (r > 0) add(vertex(r, s), vertex(r + 1, s), vertex(r, s + 1));
            if (r + 1 < rings) add(vertex(r + 1, s), vertex(r + 1, s + 1), vertex(r, s + 1));
        }
    }
    return mesh;
}

/// Two triangles a, b, c and a, c, d without normals.
inline Mesh quad(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c, glm::dvec3 d) {
    Mesh mesh;
    mesh.name = "quad";
    for (const glm::dvec3& p : {a, b, c, d}) mesh.positions.emplace_back(p);
    mesh.indices = {0, 1, 2, 0, 2, 3};
    return mesh;
}

/// One flag per index: whether the edge from there to its triangle's next is of a kind.
inline std::vector<bool> edgesOfKind(const Mesh& mesh, EdgeKind kind) {
    std::vector<bool> flags;
    for (const EdgeKinds kinds : mesh.edges) flags.push_back(kinds.has(kind));
    return flags;
}

inline glm::dmat4 translation(glm::dvec3 by) { return glm::translate(glm::dmat4{1.0}, by); }
inline glm::dmat4 scaling(glm::dvec3 by) { return glm::scale(glm::dmat4{1.0}, by); }
inline glm::dmat4 rotation(double degrees, glm::dvec3 axis) {
    return glm::rotate(glm::dmat4{1.0}, degrees * std::numbers::pi / 180.0, glm::normalize(axis));
}

/// Every vertex that is drawn, in world space.
inline std::vector<glm::dvec3> drawnVertices(const Scene& scene) {
    std::vector<glm::dvec3> points;
    for (const Instance& instance : scene.instances()) {
        const Mesh& mesh = scene.meshes()[instance.mesh];
        for (const std::uint32_t i : mesh.indices) {
            points.emplace_back(instance.transform * glm::dvec4{mesh.origin + glm::dvec3{mesh.positions[i]}, 1.0});
        }
    }
    return points;
}

/// Normalised device coordinates: -1..1 inside the picture, y up.
inline glm::dvec3 project(const Camera& camera, Size size, glm::dvec3 point) {
    const glm::dvec4 clip = camera.projection(size) * (camera.view * glm::dvec4{point, 1.0});
    return glm::dvec3{clip} / clip.w;
}

/// Where a point stands in the picture: pixels from the top left corner; pixel centres are at + 0.5.
inline glm::dvec2 pixel(const Camera& camera, Size size, glm::dvec3 point) {
    const glm::dvec3 ndc = project(camera, size, point);
    return {(ndc.x * 0.5 + 0.5) * size.width, (0.5 - ndc.y * 0.5) * size.height};
}

}  // namespace inkedge::scenes
