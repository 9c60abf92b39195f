#include "scene/prepare.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <glm/common.hpp>
#include <glm/trigonometric.hpp>

#include <inkedge/setting_table.h>

#include "base/message.h"
#include "base/stage_clock.h"
#include "mesh/arrange.h"
#include "mesh/closed_surface.h"
#include "mesh/connect.h"
#include "mesh/curvature.h"
#include "mesh/subdivide.h"
#include "scene/check_data.h"
#include "scene/choose_nodes.h"
#include "scene/distortion.h"
#include "scene/extent.h"

namespace inkedge::scene {
namespace {

void dropEmptyInstances(Scene::Data& data) {
    std::erase_if(data.instances, [&](const Instance& i) {
        return data.meshes[i.mesh].indices.empty() && data.meshes[i.mesh].lines.empty();
    });
    if (!data.instances.empty()) return;
    const std::string there = data.undrawn.empty() ? "" : fmt::format(": {}", fmt::join(data.undrawn, ", "));
    base::refuse("expected at least one triangle or line to draw, found none" + there);
}

// Unlike triangles, lines are copied for each instance when they are drawn.
void checkLineCount(const Scene::Data& data, std::uint64_t limit) {
    std::uint64_t ends = 0;
    for (const Instance& instance : data.instances) {
        ends += data.meshes[instance.mesh].lines.size();
        if (ends > limit)
            base::refuse(fmt::format(
                "expected at most {} ends of lines in all instances, found more; raise max-vertices", limit));
    }
}

bool isDoubleSided(const std::vector<Material>& materials, std::uint32_t material) {
    return material > 0 && material <= materials.size() && materials[material - 1].doubleSided;
}

bool isSingleSided(const Mesh& mesh, const Scene::Data& data) {
    if (!data.source.knowsSides) return false;
    return std::ranges::none_of(mesh.materials, [&](std::uint32_t m) { return isDoubleSided(data.materials, m); });
}

// Moves the triangles of single-sided materials before all others.
// @return how many there are
std::uint32_t sortBySides(Mesh& mesh, const std::vector<Material>& materials) {
    std::vector<bool> single(mesh.indices.size() / 3, true);
    for (std::size_t t = 0; t < mesh.materials.size(); ++t) single[t] = !isDoubleSided(materials, mesh.materials[t]);
    mesh::bringForward(mesh, single);
    return static_cast<std::uint32_t>(std::ranges::count(single, true));
}

Box boxOf(const Mesh& mesh) {
    if (mesh.positions.empty() && mesh.lines.empty()) return {};
    glm::vec3 low = mesh.positions.empty() ? mesh.lines.front() : mesh.positions.front();
    glm::vec3 high = low;
    for (const std::vector<glm::vec3>* const list : {&mesh.positions, &mesh.lines}) {
        for (const glm::vec3 p : *list) {
            low = glm::min(low, p);
            high = glm::max(high, p);
        }
    }
    return {low, high};
}

Sphere sphereAround(const Box& box, const InstancedBoxes& instanced) {
    const glm::dvec3 centre = 0.5 * (box.min + box.max);
    const Sphere sphere{centre, farthestDistance(instanced, centre)};
    if (!std::isfinite(sphere.radius)) base::refuse("expected finite bounds, found coordinates that overflow");
    return sphere;
}

struct PreparedMesh {
    mesh::MeshTopology topology;
    Box box;
    std::uint32_t oneSided;
    bool hidesItsBacks;
};

PreparedMesh prepareMesh(Mesh& mesh, const Scene::Data& data, const LoadSettings& settings) {
    mesh::arrangeTriangles(mesh);
    mesh::arrangeVertices(mesh);
    const std::uint32_t oneSided = settings.backFaces == BackFaces::Draw ? 0 : sortBySides(mesh, data.materials);
    mesh::MeshTopology topology = mesh::connect(mesh, settings);
    mesh.curvatures = settings.curvature ? mesh::meanCurvatures(mesh, topology) : std::vector<float>{};
    const bool hidesItsBacks = isSingleSided(mesh, data) && mesh::isClosedOutward(mesh, topology);
    return {std::move(topology), boxOf(mesh), oneSided, hidesItsBacks};
}

double minCreaseBend(const std::vector<mesh::MeshTopology>& topologies, double creaseAngle) {
    constexpr double rounding = 0.5;  // degrees, of bends as planes are drawn
    double cosine = -1.0;
    for (const mesh::MeshTopology& topology : topologies) cosine = std::max(cosine, topology.innerCreaseCosine);
    return std::min(creaseAngle, std::max(0.0, glm::degrees(std::acos(std::min(cosine, 1.0))) - rounding));
}

std::uint64_t trianglesOf(const Scene::Data& data) {
    std::uint64_t count = 0;
    for (const Instance& instance : data.instances) count += data.meshes[instance.mesh].indices.size() / 3;
    return count;
}

}  // namespace

PreparedScene prepare(Scene::Data data, const LoadSettings& settings) {
    const base::Stopwatch watch;
    validate(settings);
    checkData(data);
    dropEmptyInstances(data);
    chooseNodes(data, settings);
    checkLineCount(data, settings.limits.vertices);
    PreparedScene scene;
    for (const Instance& instance : data.instances) scene.transforms.push_back(instance.transform);
    bakeDistortedInstances(data, settings.limits.vertices);
    if (settings.subdivide > 0) mesh::subdivideMeshes(data.meshes, settings);

    for (Mesh& mesh : data.meshes) {
        PreparedMesh made = prepareMesh(mesh, data, settings);
        scene.topologies.push_back(std::move(made.topology));
        scene.meshBoxes.push_back(made.box);
        scene.oneSided.push_back(made.oneSided);
        scene.hidesItsBacks.push_back(made.hidesItsBacks);
    }
    const InstancedBoxes boxes{data.meshes, scene.meshBoxes, data.instances};
    scene.box = boxOfAll(boxes);
    scene.bounds = sphereAround(scene.box, boxes);
    const InstancedMeshes instanced{data.meshes, scene.topologies, data.instances, scene.bounds};
    scene.patchNumbers = numberPatches(instanced, settings);
    scene.minCreaseBend = minCreaseBend(scene.topologies, settings.creaseAngle);
    for (mesh::MeshTopology& topology : scene.topologies)
        topology.faceNormals = std::vector<glm::dvec3>{};  // a third of all that is kept; = {} would keep its memory
    scene.triangleCount = trianglesOf(data);
    scene.loadedWith = settings;
    scene.data = std::move(data);
    scene.milliseconds = watch.milliseconds();
    return scene;
}

}  // namespace inkedge::scene
