#include "formats/gltf/shape.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "base/message.h"
#include "formats/gltf/attributes.h"

namespace inkedge::gltf {

namespace {

void addScaled(std::vector<glm::dvec3>& vectors, const std::vector<glm::dvec3>& offsets, double weight) {
    for (std::size_t i = 0; i < offsets.size() && i < vectors.size(); ++i) vectors[i] += weight * offsets[i];
}

// The joint matrix of a vertex, glTF 2.0, section 3.7.3.3: the weighted sum of its joints' matrices.
glm::dmat4 blend(const std::vector<glm::dmat4>& joints, const glm::dvec4& chosen, const glm::dvec4& weights) {
    const double sum = weights.x + weights.y + weights.z + weights.w;
    const glm::dvec4 shares = sum > 0.0 && std::isfinite(sum) ? weights / sum : glm::dvec4{1, 0, 0, 0};
    glm::dmat4 matrix{0.0};
    for (int i = 0; i < 4; ++i) {
        if (shares[i] == 0.0) continue;
        if (chosen[i] >= static_cast<double>(joints.size()))
            base::refuse(fmt::format("JOINTS_0: expected joints below {}, found {}", joints.size(), chosen[i]));
        matrix += shares[i] * joints[static_cast<std::size_t>(chosen[i])];
    }
    return matrix;
}

// The inverse transpose up to a positive scale, which also exists for a determinant of 0.
glm::dmat3 normalTransform(const glm::dmat3& matrix) {
    const glm::dmat3 cofactors{glm::cross(matrix[1], matrix[2]), glm::cross(matrix[2], matrix[0]),
                               glm::cross(matrix[0], matrix[1])};
    return glm::dot(matrix[0], cofactors[0]) < 0.0 ? -cofactors : cofactors;
}

// Appends values. If only one of the two lists has any, the other's become zero.
template <class T>
void appendOrFill(std::vector<T>& all, std::size_t countBefore, const std::vector<T>& more, std::size_t count) {
    if (all.empty() && more.empty()) return;
    all.resize(countBefore);
    all.insert(all.end(), more.begin(), more.end());
    all.resize(countBefore + count);
}

glm::dvec3 centreOf(const std::vector<glm::dvec3>& positions) {
    glm::dvec3 low = positions.front();
    glm::dvec3 high = low;
    for (const glm::dvec3& position : positions) {
        low = glm::min(low, position);
        high = glm::max(high, position);
    }
    return 0.5 * (low + high);
}

}  // namespace

void morph(const tinygltf::Model& model, const tinygltf::Primitive& primitive, const std::vector<double>& weights,
           Shape& part) {
    for (std::size_t i = 0; i < weights.size() && i < primitive.targets.size(); ++i) {
        if (weights[i] == 0.0) continue;
        base::within(base::label("target", i), [&] {
            const std::size_t count = part.positions.size();
            const auto read = [&](const char* attribute, const Expected& expected) {
                return readAttribute<glm::dvec3>(model, primitive.targets[i], attribute, expected, count);
            };
            addScaled(part.positions, read("POSITION", anyPosition), weights[i]);
            if (part.authored) addScaled(part.normals, read("NORMAL", anyNormal), weights[i]);
        });
    }
}

void skin(const tinygltf::Model& model, const tinygltf::Primitive& primitive, const std::vector<glm::dmat4>& joints,
          Shape& part) {
    const std::size_t count = part.positions.size();
    const auto chosen = readAttribute<glm::dvec4>(model, primitive.attributes, "JOINTS_0", anyJoints, count);
    const auto weights = readAttribute<glm::dvec4>(model, primitive.attributes, "WEIGHTS_0", anyWeights, count);
    if (chosen.size() != count || weights.size() != count)
        base::refuse("expected JOINTS_0 and WEIGHTS_0 in a mesh with a skin, found one of them missing");
    for (std::size_t i = 0; i < count; ++i) {
        const glm::dmat4 toWorld = blend(joints, chosen[i], weights[i]);
        part.positions[i] = glm::dvec3{toWorld * glm::dvec4{part.positions[i], 1.0}};
        part.normals[i] = normalTransform(glm::dmat3{toWorld}) * part.normals[i];
    }
}

void checkPositions(const std::vector<glm::dvec3>& positions) {
    constexpr double largest = std::numeric_limits<float>::max();
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const glm::dvec3& p = positions[i];
        if (!(std::abs(p.x) <= largest && std::abs(p.y) <= largest && std::abs(p.z) <= largest))
            base::refuse(fmt::format("expected finite positions, found ({}, {}, {}) at vertex {}", p.x, p.y, p.z, i));
    }
}

void normalize(std::vector<glm::dvec3>& normals) {
    for (glm::dvec3& normal : normals) {
        const double length = glm::length(normal);
        normal = length > 0.0 && std::isfinite(length) ? normal / length : glm::dvec3{0.0};
    }
}

void append(Shape& shape, Shape part) {
    shape.lines.insert(shape.lines.end(), part.lines.begin(), part.lines.end());
    if (shape.positions.empty()) {
        part.lines = std::move(shape.lines);
        shape = std::move(part);
        return;
    }
    const auto first = static_cast<std::uint32_t>(shape.positions.size());
    appendOrFill(shape.coordinates, shape.positions.size(), part.coordinates, part.positions.size());
    appendOrFill(shape.paint, shape.positions.size(), part.paint, part.positions.size());
    appendOrFill(shape.edges, shape.indices.size(), part.edges, part.indices.size());
    shape.positions.insert(shape.positions.end(), part.positions.begin(), part.positions.end());
    shape.normals.insert(shape.normals.end(), part.normals.begin(), part.normals.end());
    for (const std::uint32_t index : part.indices) shape.indices.push_back(first + index);
    shape.materials.insert(shape.materials.end(), part.materials.begin(), part.materials.end());
    shape.authored = shape.authored || part.authored;
}

Mesh meshOf(Shape shape, const std::string& name) {
    Mesh mesh;
    mesh.name = name;
    mesh.origin = centreOf(shape.positions.empty() ? shape.lines : shape.positions);
    mesh.indices = std::move(shape.indices);
    mesh.positions.reserve(shape.positions.size());
    for (const glm::dvec3& position : shape.positions) mesh.positions.emplace_back(position - mesh.origin);
    mesh.lines.reserve(shape.lines.size());
    for (const glm::dvec3& position : shape.lines) mesh.lines.emplace_back(position - mesh.origin);
    if (shape.authored) mesh.normals.assign(shape.normals.begin(), shape.normals.end());
    if (std::ranges::any_of(shape.materials, [](std::uint32_t material) { return material != 0; }))
        mesh.materials = std::move(shape.materials);
    mesh.textureCoordinates = std::move(shape.coordinates);
    mesh.paint = std::move(shape.paint);
    mesh.edges = std::move(shape.edges);
    return mesh;
}

}  // namespace inkedge::gltf
