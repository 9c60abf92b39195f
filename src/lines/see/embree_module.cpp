// Rays by Embree 4 or 3, whichever was configured.
#if INKEDGE_EMBREE_VERSION == 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <inkedge/export.h>

#include "lines/see/rays.h"
#include "modules/failure.h"

namespace inkedge::lines {
namespace {

const char* reasonFor(RTCError error) {
    switch (error) {
        case RTC_ERROR_OUT_OF_MEMORY:
            return "out of memory";
        case RTC_ERROR_UNSUPPORTED_CPU:
            return "a processor that it does not support";
        case RTC_ERROR_INVALID_ARGUMENT:
            return "an invalid argument";
        case RTC_ERROR_INVALID_OPERATION:
            return "an invalid operation";
        case RTC_ERROR_CANCELLED:
            return "a cancelled build";
        default:
            return "an unknown error";
    }
}

// Owns one reference: moves, never copies, releases once.
template <class Object, auto release>
class Handle {
public:
    explicit Handle(Object object) noexcept : object_{object} {}
    Handle(Handle&& from) noexcept : object_{std::exchange(from.object_, nullptr)} {}
    Handle& operator=(Handle&& from) noexcept {
        std::swap(object_, from.object_);
        return *this;
    }
    ~Handle() {
        if (object_ != nullptr) release(object_);
    }
    [[nodiscard]] Object get() const noexcept { return object_; }

private:
    Object object_;  // null once moved from
};
using Device = Handle<RTCDevice, &rtcReleaseDevice>;
using SceneHandle = Handle<RTCScene, &rtcReleaseScene>;
using Geometry = Handle<RTCGeometry, &rtcReleaseGeometry>;

[[noreturn]] void refuse(RTCError error) {
    throw std::runtime_error{std::string{"lines from object space: expected Embree to work, found: "} +
                             reasonFor(error)};
}

// Refuses if a call since the last check failed, usually because memory ran out.
void check(const Device& device) {
    if (const RTCError error = rtcGetDeviceError(device.get()); error != RTC_ERROR_NONE) refuse(error);
}

Device makeDevice() {
    const RTCDevice device = rtcNewDevice(nullptr);
    if (device == nullptr) refuse(rtcGetDeviceError(nullptr));
    return Device{device};
}

SceneHandle makeMeshScene(const Device& device, const RayMesh& mesh) {
    if (mesh.indices.empty()) {  // a mesh of lines
        SceneHandle empty{rtcNewScene(device.get())};
        rtcCommitScene(empty.get());
        return empty;
    }
    const Geometry geometry{rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_TRIANGLE)};
    void* const positions = rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                    sizeof(glm::vec3), mesh.positions.size());
    void* const indices = rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                  3 * sizeof(std::uint32_t), mesh.indices.size() / 3);
    check(device);
    std::ranges::transform(mesh.positions, static_cast<glm::vec3*>(positions),
                           [&](glm::vec3 p) { return glm::vec3{mesh.scale * glm::dvec3{p}}; });
    auto* const to = static_cast<std::uint32_t*>(indices);
    std::ranges::copy(mesh.indices, to);
    for (std::size_t t = 0; t < mesh.originals.size(); ++t)
        if (mesh.originals[t] != t) to[3 * t + 1] = to[3 * t + 2] = to[3 * t];
    // The quickest to build: few rays are cast for each face. It is taken if both the geometry and its scene say so.
    rtcSetGeometryBuildQuality(geometry.get(), RTC_BUILD_QUALITY_LOW);
    rtcCommitGeometry(geometry.get());
    SceneHandle scene{rtcNewScene(device.get())};
    rtcSetSceneFlags(scene.get(), RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(scene.get(), RTC_BUILD_QUALITY_LOW);
    rtcAttachGeometry(scene.get(), geometry.get());
    rtcCommitScene(scene.get());
    check(device);
    return scene;
}

RTCRay toEmbree(const Ray& ray) noexcept {
    RTCRay result{};
    result.org_x = ray.from.x;
    result.org_y = ray.from.y;
    result.org_z = ray.from.z;
    result.dir_x = ray.along.x;
    result.dir_y = ray.along.y;
    result.dir_z = ray.along.z;
    result.tnear = ray.begin;
    result.tfar = ray.end;
    result.mask = ~0U;
    return result;
}

// Whether Embree, which inverts a transform in floats, can bring rays into its space. Its own assertions end the
// process where it cannot.
bool canBeInverted(const glm::mat4x3& transform) {
    constexpr double largest = 1e15;  // of a factor: rays that start within a few units stay below largestCoordinate
    const glm::dmat3 linear{glm::dmat4x3{transform}};
    const double volume = std::abs(glm::determinant(linear));
    if (!(volume >= double{FLT_MIN})) return false;
    const glm::dmat3 back = glm::inverse(linear);
    for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < 3; ++row)
            if (!(std::abs(back[column][row]) <= largest)) return false;
        if (!(std::abs(double{transform[3][column]}) <= largest)) return false;
    }
    return true;
}

// Not so where a member is no number.
bool isUsable(const Ray& ray) noexcept {
    for (int axis = 0; axis < 3; ++axis) {
        if (!(std::abs(ray.from[axis]) <= largestCoordinate)) return false;
        if (!(std::abs(ray.along[axis]) <= largestCoordinate)) return false;
    }
    return std::isfinite(ray.begin) && ray.begin <= ray.end;
}

class EmbreeRays final : public Rays {
public:
    EmbreeRays(std::span<const RayMesh> meshes, std::span<const RayInstance> instances) {
        for (const RayMesh& mesh : meshes) meshes_.push_back(makeMeshScene(device_, mesh));
        for (std::uint32_t i = 0; i < instances.size(); ++i) {
            const RayInstance& instance = instances[i];
            if (!canBeInverted(instance.transform)) continue;
            const Geometry geometry{rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_INSTANCE)};
            rtcSetGeometryInstancedScene(geometry.get(), meshes_[instance.mesh].get());
            rtcSetGeometryTransform(geometry.get(), 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, &instance.transform[0][0]);
            rtcCommitGeometry(geometry.get());
            rtcAttachGeometryByID(top_.get(), geometry.get(), i);
        }
        rtcSetSceneFlags(top_.get(), RTC_SCENE_FLAG_ROBUST);
        rtcCommitScene(top_.get());
        check(device_);
    }

    [[nodiscard]] std::optional<RayHit> first(const Ray& ray) const noexcept override {
        if (!isUsable(ray)) return {};
        RTCRayHit hit{};
        hit.ray = toEmbree(ray);
        hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        hit.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
        intersect(hit);
        if (hit.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
        return RayHit{hit.hit.instID[0], hit.hit.primID, hit.ray.tfar};
    }

    [[nodiscard]] bool meetsAny(const Ray& ray) const noexcept override {
        if (!isUsable(ray)) return false;
        RTCRay embreeRay = toEmbree(ray);
        occlude(embreeRay);
        return embreeRay.tfar < 0.0F;
    }

private:
#if INKEDGE_EMBREE_VERSION == 4
    void intersect(RTCRayHit& hit) const { rtcIntersect1(top_.get(), &hit, nullptr); }
    void occlude(RTCRay& ray) const { rtcOccluded1(top_.get(), &ray, nullptr); }
#else
    void intersect(RTCRayHit& hit) const {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        rtcIntersect1(top_.get(), &context, &hit);
    }
    void occlude(RTCRay& ray) const {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        rtcOccluded1(top_.get(), &context, &ray);
    }
#endif

    Device device_ = makeDevice();
    std::vector<SceneHandle> meshes_;
    SceneHandle top_{rtcNewScene(device_.get())};
};

}  // namespace

extern "C" INKEDGE_API const RayMaker* inkedge_embree_2() noexcept {
    static constexpr RayMaker functions{[](std::span<const RayMesh> meshes, std::span<const RayInstance> instances) {
        return modules::guarded([&] { return MadeRays{std::make_unique<EmbreeRays>(meshes, instances), {}}; });
    }};
    return &functions;
}

}  // namespace inkedge::lines
