#include "lines/see/embree.h"

#include <string>

#include <dlfcn.h>
#include <fmt/format.h>

#include <inkedge/error.h>

namespace inkedge::embree {
namespace {

const std::string libraryName = fmt::format("libembree{0}.so.{0}", INKEDGE_EMBREE_VERSION);

template <class Function>
void resolve(void* library, const char* name, Function& function) {
    function = reinterpret_cast<Function>(::dlsym(library, name));
    if (function == nullptr) {
        throw Error{Error::Kind::Runtime,
                    fmt::format("lines from object space: expected {} in {}, found none; install Embree {}", name,
                                libraryName, INKEDGE_EMBREE_VERSION)};
    }
}

Api load() {
    void* const library = ::dlopen(libraryName.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr) {
        throw Error{Error::Kind::Runtime,
                    fmt::format("lines from object space: expected {}, found: {}; install Embree {}, or use "
                                "--lines-from image",
                                libraryName, ::dlerror(), INKEDGE_EMBREE_VERSION)};
    }
    Api api{};
    resolve(library, "rtcNewDevice", api.newDevice);
    resolve(library, "rtcReleaseDevice", api.releaseDevice);
    resolve(library, "rtcGetDeviceError", api.getDeviceError);
    resolve(library, "rtcNewScene", api.newScene);
    resolve(library, "rtcReleaseScene", api.releaseScene);
    resolve(library, "rtcSetSceneFlags", api.setSceneFlags);
    resolve(library, "rtcCommitScene", api.commitScene);
    resolve(library, "rtcNewGeometry", api.newGeometry);
    resolve(library, "rtcReleaseGeometry", api.releaseGeometry);
    resolve(library, "rtcCommitGeometry", api.commitGeometry);
    resolve(library, "rtcAttachGeometry", api.attachGeometry);
    resolve(library, "rtcSetNewGeometryBuffer", api.setNewGeometryBuffer);
    resolve(library, "rtcSetGeometryInstancedScene", api.setGeometryInstancedScene);
    resolve(library, "rtcSetGeometryTransform", api.setGeometryTransform);
    resolve(library, "rtcIntersect1", api.intersect1);
    resolve(library, "rtcOccluded1", api.occluded1);
    return api;
}

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

[[noreturn]] void refuse(RTCError error) {
    throw Error{Error::Kind::Runtime,
                fmt::format("lines from object space: expected Embree to work, found: {}", reasonFor(error))};
}

}  // namespace

const Api& api() {
    static const Api loaded = load();
    return loaded;
}

Device makeDevice() {
    RTCDevice device = api().newDevice(nullptr);
    if (device == nullptr) refuse(api().getDeviceError(nullptr));
    return Device{device};
}

#if INKEDGE_EMBREE_VERSION == 4
void intersect(const Scene& scene, RTCRayHit& hit) { api().intersect1(scene.get(), &hit, nullptr); }

bool occluded(const Scene& scene, RTCRay ray) {
    api().occluded1(scene.get(), &ray, nullptr);
    return ray.tfar < 0.0F;
}
#else
void intersect(const Scene& scene, RTCRayHit& hit) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    api().intersect1(scene.get(), &context, &hit);
}

bool occluded(const Scene& scene, RTCRay ray) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    api().occluded1(scene.get(), &context, &ray);
    return ray.tfar < 0.0F;
}
#endif

void check(const Device& device) {
    if (const RTCError error = api().getDeviceError(device.get()); error != RTC_ERROR_NONE) refuse(error);
}

}  // namespace inkedge::embree
