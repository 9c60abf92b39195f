#!/bin/bash
# Embree's manual (rtcCommitScene) says that it leaves out triangles with values beyond 1.844e18, so one would expect
# hits to be right within that. 3.13.5 and 4.3.3 get them right up to about 3e12. Of two triangles of size and depth
# 1e13 the one behind is hit, at the distance infinity, and a segment that ends before both counts as blocked; at 1e-16
# both are missed, or, with the robust flag, the one behind is hit at 0. No error is raised: callers must scale such
# scenes.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=lib.sh
source "$(dirname "$0")/lib.sh"
need g++
unpack bookworm libembree-dev=3.13.5+dfsg-2 libembree3-3=3.13.5+dfsg-2 libtbb12
unpack trixie libembree-dev=4.3.3+dfsg-1 libembree4-4=4.3.3+dfsg-1 libtbb12 libstdc++6 libgcc-s1 libc6

cat >"$work/hit.cpp" <<'CPP'
#include <rtcore.h>

#include <cmath>
#include <cstdio>

static void add(RTCDevice device, RTCScene scene, float size, float z) {
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* points = static_cast<float*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), 3));
  const float values[9] = {-size, -size, z, size, -size, z, 0, size, z};
  for (int i = 0; i < 9; ++i) points[i] = values[i];
  auto* corners = static_cast<unsigned*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), 1));
  for (unsigned i = 0; i < 3; ++i) corners[i] = i;
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
}

// Triangle 0 at z = 0 and triangle 1 at z = depth. A ray comes down from z = 4 * depth, and a segment to 3 * depth.
static void look(RTCDevice device, float size, float depth, RTCSceneFlags flags) {
  RTCScene scene = rtcNewScene(device);
  rtcSetSceneFlags(scene, flags);
  add(device, scene, size, 0);
  add(device, scene, size, depth);
  rtcCommitScene(scene);
  RTCRayHit hit{};
  hit.ray.org_z = 4 * depth;
  hit.ray.dir_z = -1;
  hit.ray.tfar = INFINITY;
  hit.ray.mask = ~0u;
  hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  RTCRay segment = hit.ray;
  segment.tfar = depth;
#if RTC_VERSION_MAJOR == 3
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(scene, &context, &hit);
  rtcOccluded1(scene, &context, &segment);
#else
  rtcIntersect1(scene, &hit);
  rtcOccluded1(scene, &segment);
#endif
  std::printf("size %g, depth %g%s: triangle %d at %.2g, segment %s, error %d\n", size, depth,
              flags == RTC_SCENE_FLAG_ROBUST ? ", robust" : "", static_cast<int>(hit.hit.geomID), hit.ray.tfar,
              segment.tfar < 0 ? "blocked" : "free", rtcGetDeviceError(device));
  rtcReleaseScene(scene);
}

int main() {
  RTCDevice device = rtcNewDevice(nullptr);
  look(device, 1, 1, RTC_SCENE_FLAG_NONE);
  look(device, 1e12f, 1e12f, RTC_SCENE_FLAG_NONE);
  look(device, 1e13f, 1e13f, RTC_SCENE_FLAG_NONE);
  look(device, 1e13f, 1e13f, RTC_SCENE_FLAG_ROBUST);
  look(device, 1e18f, 1, RTC_SCENE_FLAG_NONE);
  look(device, 1e-14f, 1e-14f, RTC_SCENE_FLAG_NONE);
  look(device, 1e-16f, 1e-16f, RTC_SCENE_FLAG_NONE);
  look(device, 1e-16f, 1e-16f, RTC_SCENE_FLAG_ROBUST);
  rtcReleaseDevice(device);
}
CPP
for suite in bookworm trixie; do
  root=$work/$suite/usr
  g++ -I"$(echo "$root"/include/embree?)" "$work/hit.cpp" "$root"/lib/x86_64-linux-gnu/libembree?.so \
    -Wl,--allow-shlib-undefined -o "$work/hit"
  run "$suite" "$work/hit" >"$work/seen"
  expect "$work/seen" "$suite" <<'SEEN'
size 1, depth 1: triangle 1 at 3, segment free, error 0
size 1e+12, depth 1e+12: triangle 1 at 3e+12, segment free, error 0
size 1e+13, depth 1e+13: triangle 0 at inf, segment blocked, error 0
size 1e+13, depth 1e+13, robust: triangle 0 at inf, segment free, error 0
size 1e+18, depth 1: triangle 1 at 3, segment free, error 0
size 1e-14, depth 1e-14: triangle 1 at 3e-14, segment free, error 0
size 1e-16, depth 1e-16: triangle -1 at inf, segment free, error 0
size 1e-16, depth 1e-16, robust: triangle 0 at 0, segment blocked, error 0
SEEN
done
