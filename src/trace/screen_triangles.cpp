#include "trace/screen_triangles.h"

#include <algorithm>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>

#include "base/parallel.h"
#include "mesh/topology.h"
#include "scene/prepared.h"

namespace inkedge::trace {
namespace {

constexpr std::size_t maxProjected = std::size_t{1} << 20U;  // 24 MiB; of more only few are walked over
constexpr double edgeOn = 1e-4;  // pixels: faces of less height in the picture are seen edge-on
constexpr int longestWalk = 64;  // triangles: more are far below a pixel, so that their ends cannot be seen

// Clip space -> homogeneous pixels (x w, y w, w).
glm::dmat4x3 clipToPixels(Size size) {
    const double halfWidth = 0.5 * size.width;
    const double halfHeight = 0.5 * size.height;
    glm::dmat4x3 m{0.0};
    m[0] = {halfWidth, 0.0, 0.0};
    m[1] = {0.0, -halfHeight, 0.0};
    m[3] = {halfWidth, halfHeight, 1.0};
    return m;
}

// A way in the picture, as homogeneous points.
struct Way {
    glm::dvec3 start;
    glm::dvec3 goal;
};
struct Leaving {
    std::uint32_t halfEdge;  // that is crossed; noHalfEdge: none
    double t;                // share of the way
    glm::dvec3 line;         // through it: (a, b, c) with a x + b y + c > 0 on the triangle's side
};

// Where a way leaves a triangle that it entered by one of its half-edges, if by any.
// @param first    the half-edge from corner a to corner b
// @param reached  share of the way, where it was entered
Leaving leave(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, std::uint32_t first, std::uint32_t entry,
              double reached, const Way& way) {
    // Homogeneous lines, so that corners behind the camera need no clipping.
    const glm::dvec3 ab = glm::cross(a, b);
    const double sign = glm::dot(ab, c) < 0.0 ? -1.0 : 1.0;
    Leaving leaving{mesh::noHalfEdge, 1.0, {}};
    const auto tryEdge = [&](std::uint32_t halfEdge, const glm::dvec3& line) {
        const double ep = sign * glm::dot(line, way.start);
        const double eq = sign * glm::dot(line, way.goal);
        if (eq >= 0.0 || eq >= ep) return;
        if (const double crossed = std::max(ep / (ep - eq), reached); crossed <= leaving.t)
            leaving = {halfEdge, crossed, sign * line};
    };
    if (entry != first) tryEdge(first, ab);
    if (entry != first + 1) tryEdge(first + 1, glm::cross(b, c));
    if (entry != first + 2) tryEdge(first + 2, glm::cross(c, a));
    return leaving;
}

}  // namespace

ScreenTriangles::ScreenTriangles(const Scene& scene, const std::vector<std::uint32_t>& firstTriangles,
                                 const Camera& camera, Size size)
    : scene_{scene},
      seamCreases_{scene::instancedMeshesOf(scene), scene.loadedWith()},
      firstTriangles_{firstTriangles} {
    const glm::dmat4 view = camera.projection(size) * camera.view;
    const glm::dmat4x3 viewport = clipToPixels(size);
    toPixels_.reserve(scene.instances().size());
    for (const Instance& instance : scene.instances()) {
        glm::dmat4 fromOrigin{1.0};
        fromOrigin[3] = glm::dvec4{scene.meshes()[instance.mesh].origin, 1.0};
        toPixels_.push_back(viewport * (view * (instance.transform * fromOrigin)));
        if (camera.orthographic()) {
            toW_.push_back(glm::transpose(camera.view * (instance.transform * fromOrigin))[2]);
        }
    }
    projectAll();
    collectLayerBorders();
}

void ScreenTriangles::collectLayerBorders() {
    const scene::PatchNumbers& patches = scene::patchNumbersOf(scene_);
    if (std::ranges::find(patches.layered, true) == patches.layered.end()) return;
    for (std::uint32_t i = 0; i < scene_.instances().size(); ++i) {
        const mesh::MeshTopology& topology = scene::topologyOf(scene_, scene_.instances()[i].mesh);
        for (std::uint32_t h = 0; h < topology.twins.size(); ++h) {
            const std::uint32_t patch = patches.base[i] + topology.patches[h / 3];
            if (!patches.layered[patch] || (mesh::isHalfEdge(topology.twins[h]) && !topology.creases[h])) continue;
            layerBorders_[patches.number[patch]].push_back(
                {{i, h / 3}, corner(i, h), corner(i, mesh::nextHalfEdge(h))});
        }
    }
}

bool ScreenTriangles::touch(scene::SceneFace a, scene::SceneFace b) const {
    if (a.instance != b.instance) return false;
    const auto& points = scene::topologyOf(scene_, scene_.instances()[a.instance].mesh).points;
    for (std::uint32_t i = 0; i < 3; ++i) {
        for (std::uint32_t j = 0; j < 3; ++j) {
            if (points[3 * a.triangle + i] == points[3 * b.triangle + j]) return true;
        }
    }
    return false;
}

std::optional<bool> ScreenTriangles::goOnAcrossSeam(std::uint32_t instance, std::uint32_t halfEdge,
                                                    std::uint32_t otherInstance, std::uint32_t otherHalfEdge) const {
    const scene::InstancedMeshes instanced = scene::instancedMeshesOf(scene_);
    const auto border = scene::borderEdgeOf(instanced, instance, halfEdge);
    const auto other = scene::borderEdgeOf(instanced, otherInstance, otherHalfEdge);
    if (!border || !other) return {};
    const auto shared = scene::runAlong(*border, *other, seamWidth());
    if (!shared) return {};
    return !seamCreases_.meetInCrease(*border, *other, *shared);
}

std::uint32_t ScreenTriangles::patchOf(scene::SceneFace face) const { return scene::patchOf(scene_, face); }

std::optional<ScreenTriangles::LayerBorder> ScreenTriangles::layerBorder(std::uint32_t patch, glm::dvec2 start,
                                                                         glm::dvec2 goal) const {
    const auto borders = layerBorders_.find(patch);
    if (borders == layerBorders_.end()) return {};
    const glm::dvec3 p{start, 1.0};
    const glm::dvec3 q{goal, 1.0};
    const glm::dvec3 step = glm::cross(p, q);
    for (const BorderEdge& edge : borders->second) {
        if (edge.from.z <= 0.0 || edge.to.z <= 0.0) continue;
        if ((glm::dot(step, edge.from) >= 0.0) == (glm::dot(step, edge.to) >= 0.0)) continue;
        const glm::dvec3 line = glm::cross(edge.from, edge.to);
        const double ep = glm::dot(line, p);
        const double eq = glm::dot(line, q);
        if ((ep >= 0.0) != (eq >= 0.0)) return LayerBorder{ep / (ep - eq), edge.face};
    }
    return {};
}

scene::SceneFace ScreenTriangles::locate(std::uint32_t number) const {
    const auto after = std::ranges::upper_bound(firstTriangles_, number);
    const auto instance = static_cast<std::uint32_t>(after - firstTriangles_.begin()) - 1;
    return {instance, number - firstTriangles_[instance]};
}

glm::dvec3 ScreenTriangles::project(std::uint32_t instance, std::uint32_t position) const {
    const Mesh& mesh = scene_.meshes()[scene_.instances()[instance].mesh];
    return toPixels_[instance] * glm::dvec4{glm::dvec3{mesh.positions[position]}, 1.0};
}

// Every position is asked for several times.
void ScreenTriangles::projectAll() {
    std::size_t count = 0;
    for (const Instance& instance : scene_.instances()) {
        firstProjected_.push_back(count);
        count += scene_.meshes()[instance.mesh].positions.size();
    }
    if (count > maxProjected) return;
    std::vector<glm::dvec3> all(count);
    for (std::uint32_t i = 0; i < scene_.instances().size(); ++i) {
        const std::size_t positions = scene_.meshes()[scene_.instances()[i].mesh].positions.size();
        base::inRanges(positions, [&](std::size_t begin, std::size_t end) {
            for (std::size_t p = begin; p < end; ++p)
                all[firstProjected_[i] + p] = project(i, static_cast<std::uint32_t>(p));
        });
    }
    projected_ = std::move(all);
}

glm::dvec3 ScreenTriangles::planeFunction(scene::SceneFace t) const {
    const glm::dvec3 a = corner(t.instance, 3 * t.triangle);
    const glm::dvec3 b = corner(t.instance, 3 * t.triangle + 1);
    const glm::dvec3 c = corner(t.instance, 3 * t.triangle + 2);
    glm::dvec3 w{1.0};  // at the corners, times their homogeneous coordinate
    if (!toW_.empty()) {
        const Mesh& mesh = scene_.meshes()[scene_.instances()[t.instance].mesh];
        for (std::uint32_t i = 0; i < 3; ++i) {
            const glm::dvec3 position{mesh.positions[mesh.indices[3 * t.triangle + i]]};
            w[static_cast<int>(i)] = glm::dot(toW_[t.instance], glm::dvec4{position, 1.0});
        }
    }
    const glm::dvec3 bc = glm::cross(b, c);
    return (w.x * bc + w.y * glm::cross(c, a) + w.z * glm::cross(a, b)) / glm::dot(a, bc);
}

ScreenTriangles::Plane ScreenTriangles::plane(scene::SceneFace t, glm::dvec2 at) const {
    const glm::dvec3 f = planeFunction(t);
    return {glm::dot(f, glm::dvec3{at, 1.0}), f.x, f.y};
}

void ScreenTriangles::walk(scene::SceneFace from, glm::dvec2 start, glm::dvec2 goal, Walk* patch, Walk* surface) const {
    const mesh::MeshTopology& topology = scene::topologyOf(scene_, scene_.instances()[from.instance].mesh);
    const std::vector<std::uint32_t>& indices = scene_.meshes()[scene_.instances()[from.instance].mesh].indices;
    const auto cornerAt = [&](std::uint32_t c) { return projected(from.instance, indices[c]); };
    const Way way{{start, 1.0}, {goal, 1.0}};
    std::uint32_t at = from.triangle;
    std::uint32_t entry = mesh::noHalfEdge;
    double reached = 0.0;
    const auto end = [&](Walk*& which, const Walk& how) {
        if (which != nullptr) *which = how;
        which = nullptr;
    };
    const auto endBoth = [&](const Walk& how) {
        end(patch, how);
        end(surface, how);
    };
    for (int step = 0; step < longestWalk; ++step) {
        const auto [exit, t, line] =
            leave(cornerAt(3 * at), cornerAt(3 * at + 1), cornerAt(3 * at + 2), 3 * at, entry, reached, way);
        if (exit == mesh::noHalfEdge) return endBoth({{}, at, at});
        const std::uint32_t twin = topology.twins[exit];
        if (twin == mesh::noHalfEdge) return endBoth({Exit{End::Border, t, exit}, {}, at});
        if (twin == mesh::manyHalfEdges) return endBoth({Exit{End::Crease, t, exit}, {}, at});
        if (topology.creases[exit]) end(patch, {Exit{End::Crease, t, exit}, {}, at});
        const glm::dvec3 third = cornerAt(mesh::previousHalfEdge(twin));
        const double behind = glm::dot(line, third);
        // A surface ends at faces seen edge-on: rounding alone would say whether they are seen.
        if (surface != nullptr && behind > -edgeOn * glm::length(glm::dvec2{line}) * third.z)
            end(surface, {Exit{End::Fold, t, exit}, {}, at});
        if (behind > 0.0) end(patch, {Exit{End::Fold, t, exit}, {}, at});
        if (patch == nullptr && surface == nullptr) return;
        at = twin / 3;
        entry = twin;
        reached = t;
    }
    endBoth({{}, {}, at});
}

ScreenTriangles::Walk ScreenTriangles::walk(scene::SceneFace from, glm::dvec2 start, glm::dvec2 goal, Over over) const {
    Walk found;
    walk(from, start, goal, over == Over::Patch ? &found : nullptr, over == Over::Surface ? &found : nullptr);
    return found;
}

ScreenTriangles::BothWalks ScreenTriangles::walkBoth(scene::SceneFace from, glm::dvec2 start, glm::dvec2 goal) const {
    BothWalks found;
    walk(from, start, goal, &found.patch, &found.surface);
    return found;
}

}  // namespace inkedge::trace
