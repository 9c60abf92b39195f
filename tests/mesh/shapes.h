#pragma once

#include <cmath>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <inkedge/mesh.h>

namespace inkedge::mesh {

/// Flat strips side by side along z, each as wide as the next and two high, that bend by given angles at the edges
/// between them. Each strip is two triangles with four vertices of its own; without normals.
/// @param bends  degrees, one an edge: over 0 where the strips bend away from +y
inline Mesh strips(const std::vector<double>& bends, float width = 1.0F) {
    Mesh mesh;
    double angle = 0.0;
    glm::dvec3 start{0.0};
    for (std::size_t i = 0; i <= bends.size(); ++i) {
        const glm::dvec3 end = start + static_cast<double>(width) * glm::dvec3{std::cos(angle), -std::sin(angle), 0.0};
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        for (const glm::dvec3& p : {start, end, end - glm::dvec3{0, 0, 2}, start - glm::dvec3{0, 0, 2}})
            mesh.positions.emplace_back(p);
        for (const std::uint32_t k : {0U, 1U, 2U, 0U, 2U, 3U}) mesh.indices.push_back(first + k);
        start = end;
        if (i < bends.size()) angle += glm::radians(bends[i]);
    }
    return mesh;
}

/// A prism around +y whose sides are two triangles each with four vertices of their own, with caps, radius 1; without
/// normals.
inline Mesh prism(int sides, double height = 2.0) {
    Mesh mesh;
    const auto at = [&](int i, double y) {
        const double a = 2.0 * glm::radians(180.0) * i / sides;
        return glm::vec3{glm::dvec3{std::cos(a), y, -std::sin(a)}};
    };
    const auto add = [&](std::initializer_list<glm::vec3> corners) {
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        mesh.positions.insert(mesh.positions.end(), corners);
        for (std::uint32_t k = 2; k < corners.size(); ++k)
            for (const std::uint32_t i : {0U, k - 1, k}) mesh.indices.push_back(first + i);
    };
    for (int i = 0; i < sides; ++i) {
        add({at(i, 0), at(i + 1, 0), at(i + 1, height), at(i, height)});
        add({at(i + 1, 0), at(i, 0), {0, 0, 0}});
        add({at(i, height), at(i + 1, height), {0, static_cast<float>(height), 0}});
    }
    return mesh;
}

/// A torus around +y of radius 1, its tube of radius 0.4, with the true surface's normals.
/// @param around  facets around the axis
/// @param tube    facets around the tube
inline Mesh torus(std::uint32_t around = 48, std::uint32_t tube = 24) {
    Mesh mesh;
    for (std::uint32_t i = 0; i < around; ++i) {
        for (std::uint32_t k = 0; k < tube; ++k) {
            const double a = glm::radians(360.0 * i / around);
            const double b = glm::radians(360.0 * k / tube);
            const glm::dvec3 out{std::cos(a), 0.0, -std::sin(a)};
            const glm::dvec3 normal = std::cos(b) * out + glm::dvec3{0.0, std::sin(b), 0.0};
            mesh.positions.emplace_back(out + 0.4 * normal);
            mesh.normals.emplace_back(normal);
            const auto at = [&](std::uint32_t j, std::uint32_t l) { return j % around * tube + l % tube; };
            for (const std::uint32_t v :
                 {at(i, k), at(i + 1, k), at(i + 1, k + 1), at(i, k), at(i + 1, k + 1), at(i, k + 1)})
                mesh.indices.push_back(v);
        }
    }
    return mesh;
}

/// The unit normal of each triangle's winding, at each of its vertices; later triangles win.
inline std::vector<glm::vec3> facetNormals(const Mesh& mesh) {
    std::vector<glm::vec3> normals(mesh.positions.size());
    for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
        const glm::vec3 a = mesh.positions[mesh.indices[t]];
        const glm::vec3 area =
            glm::cross(mesh.positions[mesh.indices[t + 1]] - a, mesh.positions[mesh.indices[t + 2]] - a);
        for (std::size_t k = 0; k < 3; ++k) normals[mesh.indices[t + k]] = glm::normalize(area);
    }
    return normals;
}

}  // namespace inkedge::mesh
