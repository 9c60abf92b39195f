#pragma once

#include <utility>

#include <embree3/rtcore.h>

namespace inkedge::embree {

/// Embree's functions. The library is opened on first use, so that what needs no rays does not pay for it.
struct Api {
    decltype(&rtcNewDevice) newDevice;
    decltype(&rtcReleaseDevice) releaseDevice;
    decltype(&rtcGetDeviceError) getDeviceError;
    decltype(&rtcNewScene) newScene;
    decltype(&rtcReleaseScene) releaseScene;
    decltype(&rtcSetSceneFlags) setSceneFlags;
    decltype(&rtcSetSceneBuildQuality) setSceneBuildQuality;
    decltype(&rtcCommitScene) commitScene;
    decltype(&rtcNewGeometry) newGeometry;
    decltype(&rtcReleaseGeometry) releaseGeometry;
    decltype(&rtcCommitGeometry) commitGeometry;
    decltype(&rtcAttachGeometry) attachGeometry;
    decltype(&rtcSetSharedGeometryBuffer) setSharedGeometryBuffer;
    decltype(&rtcSetNewGeometryBuffer) setNewGeometryBuffer;
    decltype(&rtcSetGeometryInstancedScene) setGeometryInstancedScene;
    decltype(&rtcSetGeometryTransform) setGeometryTransform;
    decltype(&rtcSetGeometryUserData) setGeometryUserData;
    decltype(&rtcSetGeometryUserPrimitiveCount) setGeometryUserPrimitiveCount;
    decltype(&rtcSetGeometryBoundsFunction) setGeometryBoundsFunction;
    decltype(&rtcIntersect1) intersect1;
    decltype(&rtcOccluded1) occluded1;
    decltype(&rtcCollide) collide;
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

/// @throws Error  (Kind::Runtime) if a call since the last check failed: most often for want of memory
void check(const Device&);

}  // namespace inkedge::embree
