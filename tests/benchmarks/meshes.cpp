#include "meshes.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>
#include <numeric>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <glm/geometric.hpp>

namespace inkedge::benchmarks {
namespace {

// A point of the closed surface; around and across run once round the ring and once round its cross-section, 0..1.
using Surface = glm::dvec3 (*)(double around, double across);

constexpr int teeth = 24;
constexpr int cornersOfTooth = 4;  // root, flank, top, flank
constexpr int sidesOfSection = 4;  // of a rectangle

// Straight between corners at whole numbers, which repeat.
template <std::size_t count>
double straight(const double (&corners)[count], double at) {
    const double floor = std::floor(at);
    const auto i = static_cast<std::size_t>(floor);
    return corners[i % count] + (at - floor) * (corners[(i + 1) % count] - corners[i % count]);
}

glm::dvec3 toothedRing(double around, double across) {
    constexpr double outer[cornersOfTooth]{1.0, 1.0, 1.2, 1.2};
    constexpr double onOutside[sidesOfSection]{0.0, 1.0, 1.0, 0.0};
    constexpr double height[sidesOfSection]{-0.15, -0.15, 0.15, 0.15};
    const double outside = straight(onOutside, across * sidesOfSection);
    const double radius = std::lerp(0.6, straight(outer, around * teeth * cornersOfTooth), outside);
    const double angle = around * 2.0 * std::numbers::pi;
    return {radius * std::cos(angle), straight(height, across * sidesOfSection), radius * std::sin(angle)};
}

glm::dvec3 bumpyTorus(double around, double across) {
    const double angle = around * 2.0 * std::numbers::pi;
    const double section = across * 2.0 * std::numbers::pi;
    const double radius = 0.35 + 0.04 * std::sin(9.0 * angle) * std::sin(4.0 * section);
    const double reach = 0.85 + radius * std::cos(section);
    return {reach * std::cos(angle), radius * std::sin(section), reach * std::sin(angle)};
}

struct Grid {
    std::uint32_t around;
    std::uint32_t across;
};

Grid gridFor(Shape shape, std::uint64_t triangles) {
    const auto stepsOf = [](double length, std::uint32_t unit) {
        return unit * static_cast<std::uint32_t>(std::max(1.0, std::round(length / unit)));
    };
    const double quads = static_cast<double>(triangles) / 2.0;
    const std::uint32_t unitAround = shape == Shape::Cad ? teeth * cornersOfTooth : 4;
    const std::uint32_t unitAcross = shape == Shape::Cad ? sidesOfSection : 4;
    constexpr double aroundToAcross = 3.0;  // of the two lengths
    const std::uint32_t across = stepsOf(std::sqrt(quads / aroundToAcross), unitAcross);
    const std::uint32_t around = stepsOf(quads / across, unitAround);
    return {around, stepsOf(quads / around, unitAcross)};
}

void addNormals(Mesh& mesh) {
    std::vector<glm::vec3> sums(mesh.positions.size(), glm::vec3{0.0F});
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const glm::vec3 a = mesh.positions[mesh.indices[i]];
        const glm::vec3 area =
            glm::cross(mesh.positions[mesh.indices[i + 1]] - a, mesh.positions[mesh.indices[i + 2]] - a);
        for (std::size_t corner = 0; corner < 3; ++corner) sums[mesh.indices[i + corner]] += area;
    }
    mesh.normals.reserve(sums.size());
    for (const glm::vec3& sum : sums) mesh.normals.push_back(glm::normalize(sum));
}

// std::shuffle and the standard's distributions differ between libraries.
class Random {
public:
    std::uint32_t below(std::size_t count) { return static_cast<std::uint32_t>(engine_() % count); }
    double around(double reach) { return reach * (2.0 * static_cast<double>(engine_()) / 4294967295.0 - 1.0); }

private:
    std::mt19937 engine_{1};
};

// Moves vertices by a twelfth of an edge's length, and brings vertices and triangles into random order.
void scatter(Mesh& mesh) {
    Random random;
    const float edge = glm::distance(mesh.positions[mesh.indices[0]], mesh.positions[mesh.indices[1]]);
    for (glm::vec3& position : mesh.positions)
        for (int axis = 0; axis < 3; ++axis) position[axis] += static_cast<float>(random.around(1.0 / 12)) * edge;
    std::vector<std::uint32_t> to(mesh.positions.size());
    std::iota(to.begin(), to.end(), 0U);
    for (std::size_t i = to.size(); i-- > 1;) std::swap(to[i], to[random.below(i + 1)]);
    std::vector<glm::vec3> positions(to.size());
    for (std::size_t i = 0; i < to.size(); ++i) positions[to[i]] = mesh.positions[i];
    mesh.positions = std::move(positions);
    for (std::uint32_t& index : mesh.indices) index = to[index];
    for (std::size_t t = mesh.indices.size() / 3; t-- > 1;) {
        const std::uint32_t other = random.below(t + 1);
        std::swap_ranges(&mesh.indices[3 * t], &mesh.indices[3 * t] + 3, &mesh.indices[3 * std::size_t{other}]);
    }
}

std::string floats(glm::vec3 v) { return fmt::format("[{},{},{}]", v.x, v.y, v.z); }

template <class T>
void write(std::ostream& out, const std::vector<T>& values) {
    out.write(reinterpret_cast<const char*>(values.data()), static_cast<std::streamsize>(values.size() * sizeof(T)));
}

void write(std::ostream& out, std::initializer_list<std::uint32_t> words) {
    write(out, std::vector<std::uint32_t>{words});
}

}  // namespace

std::string_view nameOf(Shape shape) {
    switch (shape) {
        case Shape::Cad:
            return "cad";
        case Shape::Smooth:
            return "smooth";
        case Shape::Scan:
            break;
    }
    return "scan";
}

Shape shapeNamed(std::string_view name) {
    if (name == "cad") return Shape::Cad;
    if (name == "smooth") return Shape::Smooth;
    if (name == "scan") return Shape::Scan;
    throw std::runtime_error{fmt::format("expected the shape cad, smooth or scan, found {}", name)};
}

Mesh makeMesh(Shape shape, std::uint64_t triangles) {
    const Surface surface = shape == Shape::Cad ? toothedRing : bumpyTorus;
    const auto [around, across] = gridFor(shape, triangles);
    Mesh mesh;
    mesh.positions.reserve(std::size_t{around} * across);
    mesh.indices.reserve(std::size_t{around} * across * 6);
    for (std::uint32_t i = 0; i < around; ++i) {
        for (std::uint32_t j = 0; j < across; ++j) {
            mesh.positions.emplace_back(surface(static_cast<double>(i) / around, static_cast<double>(j) / across));
            const std::uint32_t here = i * across + j;
            const std::uint32_t up = i * across + (j + 1) % across;
            const std::uint32_t next = (i + 1) % around * across + j;
            const std::uint32_t opposite = (i + 1) % around * across + (j + 1) % across;
            mesh.indices.insert(mesh.indices.end(), {here, up, opposite, here, opposite, next});
        }
    }
    if (shape == Shape::Smooth) addNormals(mesh);
    if (shape == Shape::Scan) scatter(mesh);
    return mesh;
}

void writeGlb(const Mesh& mesh, const std::filesystem::path& file) {
    const std::size_t vectors = mesh.positions.size() * sizeof(glm::vec3);
    const std::size_t indices = mesh.indices.size() * sizeof(std::uint32_t);
    const bool hasNormals = !mesh.normals.empty();
    const std::size_t data = vectors + indices + (hasNormals ? vectors : 0);
    glm::vec3 low = mesh.positions.front();
    glm::vec3 high = low;
    for (const glm::vec3& position : mesh.positions) {
        low = glm::min(low, position);
        high = glm::max(high, position);
    }
    std::string json = fmt::format(
        R"({{"asset":{{"version":"2.0"}},"scene":0,"scenes":[{{"nodes":[0]}}],"nodes":[{{"mesh":0}}],)"
        R"("meshes":[{{"primitives":[{{"attributes":{{"POSITION":0{}}},"indices":1}}]}}],)"
        R"("accessors":[{{"bufferView":0,"componentType":5126,"count":{},"type":"VEC3","min":{},"max":{}}},)"
        R"({{"bufferView":1,"componentType":5125,"count":{},"type":"SCALAR"}})",
        hasNormals ? R"(,"NORMAL":2)" : "", mesh.positions.size(), floats(low), floats(high), mesh.indices.size());
    if (hasNormals) {
        json +=
            fmt::format(R"(,{{"bufferView":2,"componentType":5126,"count":{},"type":"VEC3"}})", mesh.normals.size());
    }
    json += fmt::format(
        R"(],"bufferViews":[{{"buffer":0,"byteLength":{0}}},{{"buffer":0,"byteOffset":{0},"byteLength":{1}}})", vectors,
        indices);
    if (hasNormals) {
        json += fmt::format(R"(,{{"buffer":0,"byteOffset":{},"byteLength":{}}})", vectors + indices, vectors);
    }
    json += fmt::format(R"(],"buffers":[{{"byteLength":{}}}]}})", data);
    json.resize((json.size() + 3) / 4 * 4, ' ');

    std::ofstream out{file, std::ios::binary};
    const auto size = [](std::size_t bytes) { return static_cast<std::uint32_t>(bytes); };
    write(out, {0x46546C67, 2, size(12 + 8 + json.size() + 8 + data), size(json.size()), 0x4E4F534A});
    out << json;
    write(out, {size(data), 0x004E4942});
    write(out, mesh.positions);
    write(out, mesh.indices);
    write(out, mesh.normals);
    out.close();
    if (!out) throw std::runtime_error{fmt::format("{}: cannot be written", file.string())};
}

}  // namespace inkedge::benchmarks
