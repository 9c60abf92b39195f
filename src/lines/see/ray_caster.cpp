#include "lines/see/ray_caster.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/mat4x3.hpp>

#include "lines/see/embree.h"
#include "mesh/topology.h"
#include "scene/world_triangles.h"

namespace inkedge::lines {
namespace {

constexpr double leastStep = 1e-5;  // of a point's distance: a face must be nearer by more to hide it

// A mesh's triangles; those that repeat another are left out, for they would hide the edges of their like.
embree::Scene makeMeshScene(const embree::Device& device, const Mesh& mesh, const MeshTopology& topology) {
    const embree::Api& api = embree::api();
    const embree::Geometry geometry{api.newGeometry(device.get(), RTC_GEOMETRY_TYPE_TRIANGLE)};
    void* const positions = api.setNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                     sizeof(glm::vec3), mesh.positions.size());
    void* const indices = api.setNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                   3 * sizeof(std::uint32_t), mesh.indices.size() / 3);
    embree::check(device);
    std::ranges::copy(mesh.positions, static_cast<glm::vec3*>(positions));
    auto* const to = static_cast<std::uint32_t*>(indices);
    std::ranges::copy(mesh.indices, to);
    for (std::size_t t = 0; t < topology.originals.size(); ++t) {
        if (topology.originals[t] != t) to[3 * t + 1] = to[3 * t + 2] = to[3 * t];
    }
    api.commitGeometry(geometry.get());
    embree::Scene scene{api.newScene(device.get())};
    api.setSceneFlags(scene.get(), RTC_SCENE_FLAG_ROBUST);
    api.attachGeometry(scene.get(), geometry.get());
    api.commitScene(scene.get());
    embree::check(device);
    return scene;
}

}  // namespace

struct RayCaster::State {
    const Scene& scene;
    embree::Device device = embree::makeDevice();
    std::vector<embree::Scene> meshes{};
    embree::Scene top{embree::api().newScene(device.get())};
    double radius = 0.0;

    // A ray that enters the scene's sphere: floats are fine there, however far off the eye is.
    struct Ray {
        glm::dvec3 from;
        glm::dvec3 along;  // to the point
        double begin;      // where the faces that count begin, 0 at from, 1 at the point
    };

    [[nodiscard]] Ray rayTo(const Screen& screen, glm::dvec3 point) const {
        const glm::dvec3 whole = screen.ray(point);
        const double depth = screen.depth(point);
        const double near = depth > 0.0 ? screen.near() / depth : 0.0;
        // From the point back to where the ray enters the sphere, or to the near plane if that is nearer.
        const double reach = 2.0 * radius / glm::length(whole);
        const double enter = std::clamp(1.0 - reach, 0.0, 1.0 - 1e-9);
        const glm::dvec3 along = whole * (1.0 - enter);
        return {point - along, along, std::max(0.0, (near - enter) / (1.0 - enter))};
    }

    [[nodiscard]] static RTCRayHit embreeRay(const Ray& ray, double begin, double end) {
        RTCRayHit hit{};
        hit.ray.org_x = static_cast<float>(ray.from.x);
        hit.ray.org_y = static_cast<float>(ray.from.y);
        hit.ray.org_z = static_cast<float>(ray.from.z);
        hit.ray.dir_x = static_cast<float>(ray.along.x);
        hit.ray.dir_y = static_cast<float>(ray.along.y);
        hit.ray.dir_z = static_cast<float>(ray.along.z);
        hit.ray.tnear = static_cast<float>(begin);
        hit.ray.tfar = static_cast<float>(end);
        hit.ray.mask = ~0U;
        hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        hit.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
        return hit;
    }

    // Where the ray meets a face's plane, in double precision; of one seen edge-on, as single precision has it.
    [[nodiscard]] double planeAt(const Ray& ray, SceneFace face, float single) const {
        constexpr double edgeOn = 1e-4;  // cosine
        const WorldTriangles triangles{scene, scene.instances()[face.instance], scene.bounds().centre};
        const auto corners = triangles.triangle(face.triangle);
        const glm::dvec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
        const double slope = glm::dot(normal, ray.along);
        if (std::abs(slope) <= edgeOn * glm::length(normal) * glm::length(ray.along)) {
            return static_cast<double>(single);
        }
        return glm::dot(normal, corners[0] - ray.from) / slope;
    }
};

RayCaster::RayCaster(const Scene& scene) : state_{std::make_unique<State>(State{scene})} {
    const embree::Api& api = embree::api();
    for (std::size_t i = 0; i < scene.meshes().size(); ++i) {
        state_->meshes.push_back(makeMeshScene(state_->device, scene.meshes()[i], scene.topology(i)));
    }
    for (std::uint32_t i = 0; i < scene.instances().size(); ++i) {
        const Instance& instance = scene.instances()[i];
        const embree::Geometry geometry{api.newGeometry(state_->device.get(), RTC_GEOMETRY_TYPE_INSTANCE)};
        api.setGeometryInstancedScene(geometry.get(), state_->meshes[instance.mesh].get());
        glm::dmat4 place = instance.transform;
        place[3] += place * glm::dvec4{scene.meshes()[instance.mesh].origin, 0.0};
        place[3] -= glm::dvec4{scene.bounds().centre, 0.0};
        const glm::mat4x3 columns{place};
        api.setGeometryTransform(geometry.get(), 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, &columns[0][0]);
        api.commitGeometry(geometry.get());
        api.attachGeometry(state_->top.get(), geometry.get());  // numbered as the instances are
    }
    api.setSceneFlags(state_->top.get(), RTC_SCENE_FLAG_ROBUST);
    api.commitScene(state_->top.get());
    embree::check(state_->device);
    state_->radius = std::max(scene.bounds().radius, std::numeric_limits<double>::min());
}

RayCaster::~RayCaster() = default;

bool RayCaster::hides(const Screen& screen, glm::dvec3 point, std::span<const SceneFace> own,
                      const Slack& slack) const {
    constexpr int mostHits = 64;  // own faces and those at the point itself; more is a pile of faces in one place
    const State::Ray ray = state_->rayTo(screen, point);
    const double length = glm::length(ray.along);
    const double distance = glm::length(screen.ray(point));
    const double alike = slack.parts == nullptr ? slack.length : 0.0;  // what all faces have need not be asked of each
    const double end = 1.0 - (leastStep * distance + alike) / length;
    double begin = ray.begin;
    for (int i = 0; i < mostHits && begin < end; ++i) {
        RTCRayHit hit = State::embreeRay(ray, begin, end);
        embree::intersect(state_->top, hit);
        if (hit.hit.geomID == RTC_INVALID_GEOMETRY_ID) return false;
        const SceneFace face{hit.hit.instID[0], hit.hit.primID};
        const bool counts = std::ranges::find(own, face) == own.end();
        if (counts && state_->planeAt(ray, face, hit.ray.tfar) < end - (slack.of(face) - alike) / length) return true;
        begin = std::nextafter(static_cast<double>(hit.ray.tfar) * (1.0 + 1e-6) + 1e-7, 2.0);
    }
    return false;
}

std::optional<glm::dvec3> RayCaster::firstNormal(glm::dvec3 from, glm::dvec3 to, std::span<const SceneFace> own) const {
    constexpr int mostHits = 8;
    double begin = 0.0;
    for (int i = 0; i < mostHits && begin < 1.0; ++i) {
        RTCRayHit hit = State::embreeRay({from, to - from, 0.0}, begin, 1.0);
        embree::intersect(state_->top, hit);
        if (hit.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
        const SceneFace face{hit.hit.instID[0], hit.hit.primID};
        if (std::ranges::find(own, face) == own.end()) {
            const WorldTriangles triangles{state_->scene, state_->scene.instances()[face.instance], {}};
            const auto corners = triangles.triangle(face.triangle);
            const glm::dvec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
            const double length = glm::length(normal);
            return length > 0.0 ? normal / length : glm::dvec3{0.0};
        }
        begin = static_cast<double>(hit.ray.tfar) + 1e-4;
    }
    return {};
}

bool RayCaster::meets(const Screen& screen, glm::dvec3 point) const {
    const State::Ray ray = state_->rayTo(screen, point);
    return embree::occluded(state_->top, State::embreeRay(ray, ray.begin, std::numeric_limits<double>::infinity()).ray);
}

}  // namespace inkedge::lines
