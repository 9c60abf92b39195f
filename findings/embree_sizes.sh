#!/bin/bash
# Embree takes triangles of any finite float coordinates, so one would expect a hit's distance to be right to a few
# digits at every size. With 3.13.5 and 4.3.3 this holds up to about 4e12 only (the orbit of Neptune, in metres). Above,
# the hit lies at infinity, behind the nearest triangle, and a segment that ends before both counts as blocked; above
# about 1.8e18 the triangle is left out and the scene is empty; at 1e-16 it is missed, or with the robust flag the wrong
# one is hit at 0. No error is raised, so a caller must scale such a scene.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=lib.sh
source "$(dirname "$0")/lib.sh"
need g++
unpack bookworm libembree-dev=3.13.5+dfsg-2 libembree3-3=3.13.5+dfsg-2 libtbb12 libstdc++6 libgcc-s1 libc6
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

// Triangle 0 at z = 0 and triangle 1 at z = depth; a ray comes down from z = 4 * depth, and a segment ends at 3 * depth.
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
  RTCBounds bounds;
  rtcGetSceneBounds(scene, &bounds);
  std::printf("size %g, depth %g%s: triangle %d at %g, segment %s, scene %s, error %d\n", size, depth,
              flags == RTC_SCENE_FLAG_ROBUST ? ", robust" : "", static_cast<int>(hit.hit.geomID), hit.ray.tfar,
              segment.tfar < 0 ? "blocked" : "free", bounds.lower_x > bounds.upper_x ? "empty" : "filled",
              rtcGetDeviceError(device));
  rtcReleaseScene(scene);
}

int main() {
  RTCDevice device = rtcNewDevice(nullptr);
  look(device, 1, 1, RTC_SCENE_FLAG_NONE);
  look(device, 1e12f, 1e12f, RTC_SCENE_FLAG_NONE);
  look(device, 1e13f, 1e13f, RTC_SCENE_FLAG_NONE);
  look(device, 1e13f, 1e13f, RTC_SCENE_FLAG_ROBUST);
  look(device, 1e18f, 1, RTC_SCENE_FLAG_NONE);
  look(device, 1e19f, 1, RTC_SCENE_FLAG_NONE);
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
  cat "$work/seen"
done
