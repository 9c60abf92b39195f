#include "lines/see/ray_caster.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat4x3.hpp>

#include "lines/see/rays.h"
#include "mesh/topology.h"
#include "modules/failure.h"
#include "scene/prepared.h"
#include "scene/world_triangles.h"

namespace inkedge::lines {
namespace {

// A power of two, so that nothing is rounded, that brings a length to 1..2. 1 for no length.
double scaleOf(double length) { return length > 0.0 ? std::ldexp(1.0, -std::ilogb(length)) : 1.0; }

double reachOf(const Box& box) {
    const glm::dvec3 reach = glm::max(glm::abs(box.min), glm::abs(box.max));
    return std::max({reach.x, reach.y, reach.z});
}

// Rays are cast in a space of the scene's own size, and each mesh is held in one of the mesh's: Embree goes wrong with
// numbers far from 1.
std::unique_ptr<Rays> raysOf(const Scene& scene, double scale) {
    std::vector<RayMesh> meshes;
    for (std::size_t i = 0; i < scene.meshes().size(); ++i) {
        const Mesh& mesh = scene.meshes()[i];
        meshes.push_back(
            {mesh.positions, scaleOf(reachOf(scene.meshBox(i))), mesh.indices, scene::topologyOf(scene, i).originals});
    }
    std::vector<RayInstance> instances;
    for (const Instance& instance : scene.instances()) {
        glm::dmat4 transform = instance.transform;
        transform[3] += transform * glm::dvec4{scene.meshes()[instance.mesh].origin, 0.0};
        transform[3] -= glm::dvec4{scene.bounds().centre, 0.0};
        for (int column = 0; column < 3; ++column) transform[column] *= scale / meshes[instance.mesh].scale;
        transform[3] *= scale;
        instances.push_back({instance.mesh, glm::mat4x3{transform}});
    }
    constexpr Error::Kind kind = Error::Kind::Runtime;
    return modules::expectNoFailure(modules::functionsOf<embreeModule>(kind).make(meshes, instances), kind).rays;
}

}  // namespace

struct RayCaster::State {
    const Scene& scene;
    double radius;
    double scale;  // to the space in which rays are cast
    std::unique_ptr<Rays> rays = raysOf(scene, scale);

    // The part of a ray within the scene's bounding sphere: floats are precise there, however far off the eye is.
    struct Way {
        glm::dvec3 from;
        glm::dvec3 along;  // to the point
        double begin;      // faces count from here on; 0 at from, 1 at the point
    };

    [[nodiscard]] Way wayTo(const Screen& screen, glm::dvec3 point) const {
        const glm::dvec3 whole = screen.ray(point);
        const double depth = screen.depth(point);
        const double near = depth > 0.0 ? screen.near() / depth : 0.0;
        // Back from the point to where the ray enters the sphere, or to the near plane if that is nearer.
        const double reach = 2.0 * radius / glm::length(whole);
        const double enter = std::clamp(1.0 - reach, 0.0, 1.0 - 1e-9);
        const glm::dvec3 along = whole * (1.0 - enter);
        return {point - along, along, std::max(0.0, (near - enter) / (1.0 - enter))};
    }

    [[nodiscard]] Ray rayAlong(const Way& way, double begin, double end) const {
        return {glm::vec3{scale * way.from}, glm::vec3{scale * way.along}, static_cast<float>(begin),
                static_cast<float>(end)};
    }

    // Where the way meets the plane of a face, in double precision; for a face seen edge-on the single precision value.
    [[nodiscard]] double planeAt(const Way& way, scene::SceneFace face, float single) const {
        constexpr double edgeOn = 1e-4;  // cosine
        const scene::WorldTriangles triangles{scene, scene.instances()[face.instance], scene.bounds().centre};
        const auto corners = triangles.triangle(face.triangle);
        const glm::dvec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
        const double slope = glm::dot(normal, way.along);
        if (std::abs(slope) <= edgeOn * glm::length(normal) * glm::length(way.along)) {
            return static_cast<double>(single);
        }
        return glm::dot(normal, corners[0] - way.from) / slope;
    }
};

RayCaster::RayCaster(const Scene& scene)
    : state_{std::make_unique<State>(State{scene, std::max(scene.bounds().radius, std::numeric_limits<double>::min()),
                                           scaleOf(scene.bounds().radius)})} {}

RayCaster::~RayCaster() = default;

bool RayCaster::hides(const Screen& screen, glm::dvec3 point, std::span<const scene::SceneFace> own,
                      const Slack& slack) const {
    constexpr int maxHits =
        64;  // own faces and those at the point itself; only piles of faces at one position have more
    const State::Way way = state_->wayTo(screen, point);
    const double length = glm::length(way.along);
    const double distance = glm::length(screen.ray(point));
    const double alike = slack.components == nullptr ? slack.length : 0.0;  // a slack for all faces
    const double end = 1.0 - (minStep * distance + alike) / length;
    double begin = way.begin;
    for (int i = 0; i < maxHits && begin < end; ++i) {
        const std::optional<RayHit> hit = state_->rays->first(state_->rayAlong(way, begin, end));
        if (!hit) return false;
        const scene::SceneFace face{hit->instance, hit->triangle};
        const bool counts = std::ranges::find(own, face) == own.end();
        if (counts && state_->planeAt(way, face, hit->at) < end - (slack.of(face) - alike) / length) return true;
        begin = std::nextafter(static_cast<double>(hit->at) * (1.0 + 1e-6) + 1e-7, 2.0);
    }
    return false;
}

bool RayCaster::meetsBetween(glm::dvec3 from, glm::dvec3 to,
                             const std::function<bool(scene::SceneFace, glm::dvec3)>& counts) const {
    constexpr int maxHits = 8;
    double begin = 0.0;
    for (int i = 0; i < maxHits && begin < 1.0; ++i) {
        const std::optional<RayHit> hit = state_->rays->first(state_->rayAlong({from, to - from, 0.0}, begin, 1.0));
        if (!hit) return false;
        const scene::SceneFace face{hit->instance, hit->triangle};
        const scene::WorldTriangles triangles{state_->scene, state_->scene.instances()[face.instance], {}};
        const auto corners = triangles.triangle(face.triangle);
        const glm::dvec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
        const double length = glm::length(normal);
        if (counts(face, length > 0.0 ? normal / length : glm::dvec3{0.0})) return true;
        begin = static_cast<double>(hit->at) + 1e-4;
    }
    return false;
}

bool RayCaster::meets(const Screen& screen, glm::dvec3 point) const {
    const State::Way way = state_->wayTo(screen, point);
    return state_->rays->meetsAny(state_->rayAlong(way, way.begin, std::numeric_limits<double>::infinity()));
}

}  // namespace inkedge::lines
