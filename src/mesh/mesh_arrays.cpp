#include <inkedge/mesh_arrays.h>

#include <cmath>
#include <limits>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/message.h"
#include "mesh/number_array.h"

namespace inkedge {
namespace {

using mesh::NumberArray;

constexpr std::uint64_t allNumbers = std::uint64_t{1} << 32U;

void readPositions(const NumberArray& positions, Mesh& mesh) {
    positions.expectReal();
    positions.expectColumns(3);
    if (positions.rows() >= allNumbers)
        base::refuseUse(fmt::format("positions: expected fewer than {}, found {}", allNumbers, positions.rows()));
    glm::dvec3 low{std::numeric_limits<double>::max()};
    glm::dvec3 high{std::numeric_limits<double>::lowest()};
    for (std::size_t i = 0; i < positions.rows(); ++i) {
        const glm::dvec3 p = positions.vector(i);
        const double size = glm::max(glm::abs(p.x), glm::max(glm::abs(p.y), glm::abs(p.z)));
        if (!(size <= double{std::numeric_limits<float>::max()}) || std::isnan(p.x + p.y + p.z))
            base::refuseUse(
                fmt::format("positions: expected finite numbers, found ({}, {}, {}) in row {}", p.x, p.y, p.z, i));
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    if (!positions.empty()) mesh.origin = 0.5 * (low + high);
    mesh.positions.reserve(positions.rows());
    for (std::size_t i = 0; i < positions.rows(); ++i) mesh.positions.emplace_back(positions.vector(i) - mesh.origin);
}

void readIndices(const NumberArray& indices, Mesh& mesh) {
    const std::size_t vertices = mesh.positions.size();
    if (indices.empty()) {
        for (std::uint32_t i = 0; i < vertices; ++i) mesh.indices.push_back(i);
        if (vertices % 3 != 0)
            base::refuseUse(
                fmt::format("positions: expected three a triangle, as there are no indices, found {}", vertices));
        return;
    }
    indices.expectWhole();
    if (indices.columns() != 1) indices.expectColumns(3);
    mesh.indices.reserve(indices.rows() * indices.columns());
    for (std::size_t row = 0; row < indices.rows(); ++row)
        for (std::size_t column = 0; column < indices.columns(); ++column)
            mesh.indices.push_back(indices.whole(row, column, vertices));
    if (mesh.indices.size() % 3 != 0)
        base::refuseUse(fmt::format("indices: expected three a triangle, found {}", mesh.indices.size()));
}

void readNormals(const NumberArray& normals, Mesh& mesh) {
    normals.expectReal();
    normals.expectColumns(3);
    normals.expectRows(mesh.positions.size(), "a position");
    mesh.normals.reserve(normals.rows());
    for (std::size_t i = 0; i < normals.rows(); ++i) {
        const glm::dvec3 n = normals.vector(i);
        const double length = glm::length(n);
        if (!std::isfinite(length))
            base::refuseUse(
                fmt::format("normals: expected finite numbers, found ({}, {}, {}) in row {}", n.x, n.y, n.z, i));
        mesh.normals.emplace_back(length > 0.0 ? n / length : glm::dvec3{0.0});
    }
}

void readCoordinates(const NumberArray& coordinates, Mesh& mesh) {
    coordinates.expectReal();
    coordinates.expectColumns(2);
    coordinates.expectRows(mesh.positions.size(), "a position");
    mesh.textureCoordinates.reserve(coordinates.rows());
    for (std::size_t i = 0; i < coordinates.rows(); ++i) {
        const glm::dvec2 c{coordinates.real(i, 0), coordinates.real(i, 1)};
        if (const glm::vec2 f{c}; !std::isfinite(f.x) || !std::isfinite(f.y))
            base::refuseUse(
                fmt::format("texture coordinates: expected finite numbers, found ({}, {}) in row {}", c.x, c.y, i));
        mesh.textureCoordinates.emplace_back(c);
    }
}

void readColors(const NumberArray& colors, Mesh& mesh) {
    colors.expectReal();
    if (colors.columns() != 3) colors.expectColumns(4);
    colors.expectRows(mesh.positions.size(), "a position");
    mesh.paint.resize(colors.rows());
    for (std::size_t i = 0; i < colors.rows(); ++i)
        for (std::size_t c = 0; c < colors.columns(); ++c) {
            const double value = colors.real(i, c);
            if (!(value >= 0.0 && value <= 1.0))
                base::refuseUse(fmt::format("colors: expected numbers from 0 to 1, found {} in row {}", value, i));
            mesh.paint[i].color[static_cast<int>(c)] = static_cast<float>(value);
        }
}

// One number a triangle, or an index.
std::vector<std::uint32_t> readNumbers(const NumberArray& numbers, std::size_t count, std::string_view each,
                                       std::uint64_t end) {
    numbers.expectWhole();
    numbers.expectColumns(1);
    numbers.expectRows(count, each);
    std::vector<std::uint32_t> all;
    all.reserve(numbers.rows());
    for (std::size_t i = 0; i < numbers.rows(); ++i) all.push_back(numbers.whole(i, 0, end));
    return all;
}

EdgeKinds kindsOf(std::uint32_t bits) {
    EdgeKinds kinds;
    for (const EdgeKind kind :
         {EdgeKind::Inner, EdgeKind::Sharp, EdgeKind::Tangent, EdgeKind::Seam, EdgeKind::Free, EdgeKind::Marked})
        if ((bits & static_cast<std::uint32_t>(kind)) != 0) kinds |= kind;
    return kinds;
}

}  // namespace

Mesh makeMesh(const MeshArrays& arrays) {
    constexpr std::uint64_t allKinds = 2 * static_cast<std::uint64_t>(EdgeKind::Marked);
    Mesh mesh;
    mesh.name = arrays.name;
    readPositions({arrays.positions, "positions"}, mesh);
    readIndices({arrays.indices, "indices"}, mesh);
    readNormals({arrays.normals, "normals"}, mesh);
    readCoordinates({arrays.textureCoordinates, "texture coordinates"}, mesh);
    readColors({arrays.colors, "colors"}, mesh);
    const std::size_t triangles = mesh.indices.size() / 3;
    mesh.materials = readNumbers({arrays.materials, "materials"}, triangles, "a triangle", allNumbers);
    mesh.faces = readNumbers({arrays.faces, "faces"}, triangles, "a triangle", allNumbers);
    for (const std::uint32_t bits : readNumbers({arrays.edges, "edges"}, 3 * triangles, "an index", allKinds))
        mesh.edges.push_back(kindsOf(bits));
    return mesh;
}

}  // namespace inkedge
