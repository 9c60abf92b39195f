#include "lines/embree.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <inkedge/error.h>

namespace inkedge::embree {
namespace {

constexpr const char* libraryName = "libembree3.so.3";

template <class Function>
void resolve(void* library, const char* name, Function& function) {
    function = reinterpret_cast<Function>(::dlsym(library, name));
    if (function == nullptr) {
        throw Error{Error::Kind::Runtime,
                    fmt::format("lines from object space: expected {} in {}, found none; install Embree 3.13", name,
                                libraryName)};
    }
}

Api load() {
    void* const library = ::dlopen(libraryName, RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr) {
        throw Error{Error::Kind::Runtime,
                    fmt::format("lines from object space: expected {}, found: {}; install Embree 3.13, or use "
                                "--lines-from image",
                                libraryName, ::dlerror())};
    }
    Api api{};
    resolve(library, "rtcNewDevice", api.newDevice);
    resolve(library, "rtcReleaseDevice", api.releaseDevice);
    resolve(library, "rtcGetDeviceError", api.getDeviceError);
    resolve(library, "rtcNewScene", api.newScene);
    resolve(library, "rtcReleaseScene", api.releaseScene);
    resolve(library, "rtcSetSceneFlags", api.setSceneFlags);
    resolve(library, "rtcSetSceneBuildQuality", api.setSceneBuildQuality);
    resolve(library, "rtcCommitScene", api.commitScene);
    resolve(library, "rtcNewGeometry", api.newGeometry);
    resolve(library, "rtcReleaseGeometry", api.releaseGeometry);
    resolve(library, "rtcCommitGeometry", api.commitGeometry);
    resolve(library, "rtcAttachGeometry", api.attachGeometry);
    resolve(library, "rtcSetSharedGeometryBuffer", api.setSharedGeometryBuffer);
    resolve(library, "rtcSetNewGeometryBuffer", api.setNewGeometryBuffer);
    resolve(library, "rtcSetGeometryInstancedScene", api.setGeometryInstancedScene);
    resolve(library, "rtcSetGeometryTransform", api.setGeometryTransform);
    resolve(library, "rtcSetGeometryUserData", api.setGeometryUserData);
    resolve(library, "rtcSetGeometryUserPrimitiveCount", api.setGeometryUserPrimitiveCount);
    resolve(library, "rtcSetGeometryBoundsFunction", api.setGeometryBoundsFunction);
    resolve(library, "rtcIntersect1", api.intersect1);
    resolve(library, "rtcOccluded1", api.occluded1);
    resolve(library, "rtcCollide", api.collide);
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

void check(const Device& device) {
    if (const RTCError error = api().getDeviceError(device.get()); error != RTC_ERROR_NONE) refuse(error);
}

}  // namespace inkedge::embree
