#include <inkedge/scene.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vector_relational.hpp>

#include <inkedge/error.h>

#include "mesh/closed_surface.h"
#include "mesh/curvature.h"
#include "scene/distortion.h"
#include "scene/extent.h"
#include "mesh/normals.h"
#include "scene/patch_numbers.h"
#include "scene/subdivide.h"
#include "mesh/topology.h"

namespace inkedge {

struct Scene::Prepared : Scene::Data {
    std::vector<Box> meshBoxes;
    std::vector<MeshTopology> topologies;
    std::vector<std::uint32_t> oneSided;
    std::vector<bool> hidesItsBacks;
    Box box;
    Sphere bounds;
    double creaseAngle = 0.0;
    std::uint64_t triangleCount = 0;
    PatchNumbers patchNumbers;
    double milliseconds = 0.0;
};

namespace {

[[noreturn]] void refuse(const std::string& message) { throw Error{Error::Kind::Input, message}; }

bool finite(glm::dvec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

void check(const Mesh& mesh, std::size_t number) {
    const std::string who = fmt::format("mesh {} '{}'", number, mesh.name);
    if (!finite(mesh.origin)) refuse(fmt::format("{}: expected a finite origin, found one that is not", who));
    if (mesh.indices.size() % 3 != 0) {
        refuse(fmt::format("{}: expected three indices a triangle, found {} indices", who, mesh.indices.size()));
    }
    if (!mesh.normals.empty() && mesh.normals.size() != mesh.positions.size()) {
        refuse(fmt::format("{}: expected {} normals, one a position, found {}", who, mesh.positions.size(),
                           mesh.normals.size()));
    }
    if (!mesh.edges.empty() && mesh.edges.size() != mesh.indices.size()) {
        refuse(fmt::format("{}: expected {} kinds of edges, one an index, found {}", who, mesh.indices.size(),
                           mesh.edges.size()));
    }
    if (!mesh.faces.empty() && mesh.faces.size() != mesh.indices.size() / 3) {
        refuse(fmt::format("{}: expected {} faces, one a triangle, found {}", who, mesh.indices.size() / 3,
                           mesh.faces.size()));
    }
    if (!mesh.textureCoordinates.empty() && mesh.textureCoordinates.size() != mesh.positions.size()) {
        refuse(fmt::format("{}: expected {} texture coordinates, one a position, found {}", who, mesh.positions.size(),
                           mesh.textureCoordinates.size()));
    }
    for (std::size_t i = 0; i < mesh.textureCoordinates.size(); ++i) {
        if (!finite(glm::dvec3{mesh.textureCoordinates[i], 0.0F})) {
            refuse(fmt::format("{}: expected finite texture coordinates, found ({}, {}) at vertex {}", who,
                               mesh.textureCoordinates[i].x, mesh.textureCoordinates[i].y, i));
        }
    }
    if (!mesh.paint.empty() && mesh.paint.size() != mesh.positions.size()) {
        refuse(fmt::format("{}: expected {} paints, one a position, found {}", who, mesh.positions.size(),
                           mesh.paint.size()));
    }
    if (!mesh.materials.empty() && mesh.materials.size() != mesh.indices.size() / 3) {
        refuse(fmt::format("{}: expected {} materials, one a triangle, found {}", who, mesh.indices.size() / 3,
                           mesh.materials.size()));
    }
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        if (!finite(mesh.positions[i])) {
            refuse(fmt::format("{}: expected finite positions, found vertex {} at ({}, {}, {})", who, i,
                               mesh.positions[i].x, mesh.positions[i].y, mesh.positions[i].z));
        }
    }
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        if (mesh.indices[i] >= mesh.positions.size()) {
            refuse(fmt::format("{}: expected indices below {}, found {} at {}", who, mesh.positions.size(),
                               mesh.indices[i], i));
        }
    }
}

void check(const Instance& instance, std::size_t number, const Scene::Data& data) {
    if (instance.mesh >= data.meshes.size()) {
        refuse(fmt::format("instance {} '{}': expected a mesh below {}, found {}", number, instance.name,
                           data.meshes.size(), instance.mesh));
    }
    if (instance.node != noNode && instance.node >= data.nodes.size()) {
        refuse(fmt::format("instance {} '{}': expected a node below {}, found {}", number, instance.name,
                           data.nodes.size(), instance.node));
    }
    for (int column = 0; column < 4; ++column) {
        if (!finite(glm::dvec3{instance.transform[column]})) {
            refuse(fmt::format("instance {} '{}': expected a finite transform, found one that is not", number,
                               instance.name));
        }
    }
}

void check(const std::vector<SceneNode>& nodes) {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (nodes[i].parent != noNode && nodes[i].parent >= i) {
            refuse(
                fmt::format("node {} '{}': expected a parent before it, found {}", i, nodes[i].name, nodes[i].parent));
        }
    }
}

// Primitives may share one vertex array and use a part of it each; what is not drawn must not count for the bounds.
void dropUnusedVertices(Mesh& mesh) {
    constexpr std::uint32_t unused = ~0U;
    std::vector<std::uint32_t> to(mesh.positions.size(), unused);
    for (const std::uint32_t i : mesh.indices) to[i] = 0;
    std::uint32_t count = 0;
    for (std::size_t i = 0; i < to.size(); ++i) {
        if (to[i] == unused) continue;
        mesh.positions[count] = mesh.positions[i];
        if (!mesh.normals.empty()) mesh.normals[count] = mesh.normals[i];
        if (!mesh.textureCoordinates.empty()) mesh.textureCoordinates[count] = mesh.textureCoordinates[i];
        if (!mesh.paint.empty()) mesh.paint[count] = mesh.paint[i];
        to[i] = count++;
    }
    mesh.positions.resize(count);
    if (!mesh.normals.empty()) mesh.normals.resize(count);
    if (!mesh.textureCoordinates.empty()) mesh.textureCoordinates.resize(count);
    if (!mesh.paint.empty()) mesh.paint.resize(count);
    for (std::uint32_t& i : mesh.indices) i = to[i];
}

bool isSingleSided(const Mesh& mesh, const Scene::Data& data) {
    if (!data.source.knowsSides) return false;
    return std::ranges::none_of(mesh.materials, [&](std::uint32_t material) {
        return material > 0 && material <= data.materials.size() && data.materials[material - 1].doubleSided;
    });
}

// Brings the triangles of single-sided materials to the front.
// @return how many they are
std::uint32_t sortBySides(Mesh& mesh, const std::vector<Material>& materials) {
    const auto isDoubleSided = [&](std::uint32_t t) {
        const std::uint32_t material = mesh.materials.empty() ? 0 : mesh.materials[t];
        return material > 0 && material <= materials.size() && materials[material - 1].doubleSided;
    };
    std::uint32_t count = 0;
    const auto total = static_cast<std::uint32_t>(mesh.indices.size() / 3);
    for (std::uint32_t t = 0; t < total; ++t) count += isDoubleSided(t) ? 0U : 1U;
    if (count == total || count == 0) return count;
    std::vector<std::uint32_t> order(total);
    std::iota(order.begin(), order.end(), 0U);
    std::stable_partition(order.begin(), order.end(), std::not_fn(isDoubleSided));
    Mesh sorted = mesh;
    for (std::size_t t = 0; t < order.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
            sorted.indices[3 * t + k] = mesh.indices[3 * order[t] + k];
            if (!mesh.edges.empty()) sorted.edges[3 * t + k] = mesh.edges[3 * order[t] + k];
        }
        if (!mesh.materials.empty()) sorted.materials[t] = mesh.materials[order[t]];
        if (!mesh.faces.empty()) sorted.faces[t] = mesh.faces[order[t]];
    }
    mesh = std::move(sorted);
    return count;
}

Box boxOf(const std::vector<glm::vec3>& positions) {
    if (positions.empty()) return {};
    glm::vec3 low = positions.front();
    glm::vec3 high = low;
    for (const glm::vec3 p : positions) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    return {low, high};
}

Sphere boundingSphere(const Scene& scene) {
    const glm::dvec3 centre = 0.5 * (scene.box().min + scene.box().max);
    return {centre, farthestDistance(scene, centre)};
}

}  // namespace

Scene::Scene(Data data, const LoadSettings& settings) {
    const auto begin = std::chrono::steady_clock::now();
    for (std::size_t i = 0; i < data.meshes.size(); ++i) check(data.meshes[i], i);
    for (std::size_t i = 0; i < data.instances.size(); ++i) check(data.instances[i], i, data);
    check(data.nodes);

    auto prepared = std::make_shared<Prepared>();
    static_cast<Data&>(*prepared) = std::move(data);
    prepared->creaseAngle = settings.creaseAngle;
    std::erase_if(prepared->instances, [&](const Instance& i) { return prepared->meshes[i.mesh].indices.empty(); });
    if (prepared->instances.empty()) refuse("expected at least one triangle to draw, found none");
    bakeDistortedInstances(*prepared, settings.limits.vertices);
    if (settings.subdivide > 0) subdivideMeshes(*prepared, settings);
    for (Mesh& mesh : prepared->meshes) {
        dropUnusedVertices(mesh);
        prepared->oneSided.push_back(settings.backFaces == BackFaces::Draw ? 0
                                                                           : sortBySides(mesh, prepared->materials));
        applyAuthoredNormals(mesh, settings);
        MeshTopology topology = buildTopology(mesh);
        completeNormals(mesh, topology, settings);
        buildPatches(mesh, settings.creaseAngle, topology);
        mesh.curvatures = settings.curvature ? meanCurvatures(mesh, topology) : std::vector<float>{};
        prepared->hidesItsBacks.push_back(isSingleSided(mesh, *prepared) && isClosedOutward(mesh, topology));
        prepared->topologies.push_back(std::move(topology));
        prepared->meshBoxes.push_back(boxOf(mesh.positions));
    }
    for (const Instance& instance : prepared->instances) {
        prepared->triangleCount += prepared->meshes[instance.mesh].indices.size() / 3;
    }
    Prepared& filled = *prepared;
    data_ = std::move(prepared);
    filled.box = boxOfAll(*this);
    filled.bounds = boundingSphere(*this);
    if (!std::isfinite(filled.bounds.radius)) refuse("expected finite bounds, found coordinates that overflow");
    filled.patchNumbers = numberPatches(*this, settings.creaseAngle);
    for (MeshTopology& topology : filled.topologies)
        topology.faceNormals = std::vector<glm::dvec3>{};  // a third of all that is kept; = {} would keep its memory
    filled.milliseconds = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

const std::vector<Mesh>& Scene::meshes() const noexcept { return data_->meshes; }
const std::vector<Instance>& Scene::instances() const noexcept { return data_->instances; }
const std::vector<SceneNode>& Scene::nodes() const noexcept { return data_->nodes; }
const std::vector<SceneCamera>& Scene::cameras() const noexcept { return data_->cameras; }
const std::vector<Material>& Scene::materials() const noexcept { return data_->materials; }
const std::vector<std::string>& Scene::warnings() const noexcept { return data_->warnings; }
const Box& Scene::meshBox(std::size_t i) const noexcept { return data_->meshBoxes[i]; }
const SceneSource& Scene::source() const noexcept { return data_->source; }
const Box& Scene::box() const noexcept { return data_->box; }
const Sphere& Scene::bounds() const noexcept { return data_->bounds; }
std::uint32_t Scene::oneSidedTriangles(std::size_t i) const noexcept { return data_->oneSided[i]; }
bool Scene::hidesItsBacks(std::size_t i) const noexcept { return data_->hidesItsBacks[i]; }
double Scene::creaseAngle() const noexcept { return data_->creaseAngle; }
std::uint64_t Scene::triangleCount() const noexcept { return data_->triangleCount; }
const MeshTopology& Scene::topology(std::size_t i) const noexcept { return data_->topologies[i]; }
const PatchNumbers& Scene::patchNumbers() const noexcept { return data_->patchNumbers; }
double Scene::preparationMilliseconds() const noexcept { return data_->milliseconds; }
std::weak_ptr<const void> Scene::identity() const noexcept { return data_; }

}  // namespace inkedge
