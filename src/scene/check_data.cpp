#include "scene/check_data.h"

#include <cmath>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "base/message.h"

namespace inkedge::scene {
namespace {

bool finite(glm::dvec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

// Lists that may be empty; else they have one entry per element.
void checkSizes(const Mesh& mesh, const std::string& who) {
    const auto expect = [&](std::size_t found, std::size_t expected, std::string_view what, std::string_view each) {
        if (found != 0 && found != expected)
            base::refuse(fmt::format("{}: expected {} {}, one {}, found {}", who, expected, what, each, found));
    };
    const std::size_t positions = mesh.positions.size();
    const std::size_t triangles = mesh.indices.size() / 3;
    expect(mesh.normals.size(), positions, "normals", "a position");
    expect(mesh.edges.size(), mesh.indices.size(), "kinds of edges", "an index");
    expect(mesh.faces.size(), triangles, "faces", "a triangle");
    expect(mesh.textureCoordinates.size(), positions, "texture coordinates", "a position");
    expect(mesh.paint.size(), positions, "paints", "a position");
    expect(mesh.parameters.size(), positions, "parameters", "a position");
    expect(mesh.materials.size(), triangles, "materials", "a triangle");
    expect(mesh.limitTriangles.size(), triangles, "numbers of limit triangles", "a triangle");
}

void checkValues(const Mesh& mesh, const std::string& who) {
    for (std::size_t i = 0; i < mesh.textureCoordinates.size(); ++i) {
        const glm::vec2 c = mesh.textureCoordinates[i];
        if (!finite(glm::dvec3{c, 0.0F}))
            base::refuse(
                fmt::format("{}: expected finite texture coordinates, found ({}, {}) at vertex {}", who, c.x, c.y, i));
    }
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const glm::vec3 p = mesh.positions[i];
        if (!finite(p))
            base::refuse(
                fmt::format("{}: expected finite positions, found vertex {} at ({}, {}, {})", who, i, p.x, p.y, p.z));
    }
    for (std::size_t i = 0; i < mesh.lines.size(); ++i) {
        const glm::vec3 p = mesh.lines[i];
        if (!finite(p))
            base::refuse(fmt::format("{}: expected finite positions of lines, found position {} at ({}, {}, {})", who,
                                     i, p.x, p.y, p.z));
    }
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        if (mesh.indices[i] >= mesh.positions.size())
            base::refuse(fmt::format("{}: expected indices below {}, found {} at {}", who, mesh.positions.size(),
                                     mesh.indices[i], i));
    }
}

void check(const Mesh& mesh, std::size_t number) {
    const std::string who = fmt::format("mesh {} '{}'", number, mesh.name);
    if (!finite(mesh.origin)) base::refuse(fmt::format("{}: expected a finite origin, found one that is not", who));
    if (mesh.indices.size() % 3 != 0)
        base::refuse(fmt::format("{}: expected three indices a triangle, found {} indices", who, mesh.indices.size()));
    if (mesh.lines.size() % 2 != 0)
        base::refuse(
            fmt::format("{}: expected two positions a piece of a line, found {} positions", who, mesh.lines.size()));
    checkSizes(mesh, who);
    checkValues(mesh, who);
}

void check(const Instance& instance, std::size_t number, const Scene::Data& data) {
    const std::string who = fmt::format("instance {} '{}'", number, instance.name);
    if (instance.mesh >= data.meshes.size())
        base::refuse(fmt::format("{}: expected a mesh below {}, found {}", who, data.meshes.size(), instance.mesh));
    if (instance.node != noNode && instance.node >= data.nodes.size())
        base::refuse(fmt::format("{}: expected a node below {}, found {}", who, data.nodes.size(), instance.node));
    for (int column = 0; column < 4; ++column)
        if (!finite(glm::dvec3{instance.transform[column]}))
            base::refuse(fmt::format("{}: expected a finite transform, found one that is not", who));
}

void check(const SceneNode& node, std::size_t number) {
    if (node.parent != noNode && node.parent >= number)
        base::refuse(
            fmt::format("node {} '{}': expected a parent before it, found {}", number, node.name, node.parent));
}

}  // namespace

void checkData(const Scene::Data& data) {
    for (std::size_t i = 0; i < data.meshes.size(); ++i) check(data.meshes[i], i);
    for (std::size_t i = 0; i < data.nodes.size(); ++i) check(data.nodes[i], i);
    for (std::size_t i = 0; i < data.instances.size(); ++i) check(data.instances[i], i, data);
}

}  // namespace inkedge::scene
