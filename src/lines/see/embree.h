#pragma once

#include <utility>

#if INKEDGE_EMBREE_VERSION == 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace inkedge::embree {

/// Functions of Embree 3 or 4, whichever was configured. The library is opened on first use, so that what needs no rays
/// does not pay for it.
struct Api {
    decltype(&rtcNewDevice) newDevice;
    decltype(&rtcReleaseDevice) releaseDevice;
    decltype(&rtcGetDeviceError) getDeviceError;
    decltype(&rtcNewScene) newScene;
    decltype(&rtcReleaseScene) releaseScene;
    decltype(&rtcSetSceneFlags) setSceneFlags;
    decltype(&rtcCommitScene) commitScene;
    decltype(&rtcNewGeometry) newGeometry;
    decltype(&rtcReleaseGeometry) releaseGeometry;
    decltype(&rtcCommitGeometry) commitGeometry;
    decltype(&rtcAttachGeometry) attachGeometry;
    decltype(&rtcSetNewGeometryBuffer) setNewGeometryBuffer;
    decltype(&rtcSetGeometryInstancedScene) setGeometryInstancedScene;
    decltype(&rtcSetGeometryTransform) setGeometryTransform;
    decltype(&rtcIntersect1) intersect1;
    decltype(&rtcOccluded1) occluded1;
};

/// @throws Error  (Kind::Runtime) if the library is not installed or lacks a function
[[nodiscard]] const Api& api();

/// Owns one reference: moves, never copies, releases once.
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
        if (object_ != nullptr) (api().*release)(object_);
    }
    [[nodiscard]] Object get() const noexcept { return object_; }

private:
    Object object_;  // null once moved from
};
using Device = Handle<RTCDevice, &Api::releaseDevice>;
using Scene = Handle<RTCScene, &Api::releaseScene>;
using Geometry = Handle<RTCGeometry, &Api::releaseGeometry>;

/// @throws Error  (Kind::Runtime) with Embree's reason
[[nodiscard]] Device makeDevice();

/// The first face that a ray meets, written into it; geomID stays RTC_INVALID_GEOMETRY_ID where there is none. Thread-safe.
void intersect(const Scene&, RTCRayHit&);

/// Whether a ray meets any face. Thread-safe.
[[nodiscard]] bool occluded(const Scene&, RTCRay);

/// @throws Error  (Kind::Runtime) if a call since the last check failed: most often for want of memory
void check(const Device&);

}  // namespace inkedge::embree
