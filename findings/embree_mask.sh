#!/bin/bash
# A geometry that was never given a mask would be expected to be seen by every ray whose own mask is not 0, and with
# Embree 3.13.5 it is. With 4.3.3 such a geometry has the mask 1: a ray with the mask 2 goes through it, and no error is
# raised. Only the release notes tell, not the manual page of rtcSetGeometryMask. A program that gives its rays masks
# and its geometries none builds against both versions, and with the newer one finds nothing.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=lib.sh
source "$(dirname "$0")/lib.sh"
need g++
unpack bookworm libembree-dev=3.13.5+dfsg-2 libembree3-3=3.13.5+dfsg-2 libtbb12
unpack trixie libembree-dev=4.3.3+dfsg-1 libembree4-4=4.3.3+dfsg-1 libtbb12 libstdc++6 libgcc-s1 libc6

cat >"$work/mask.cpp" <<'CPP'
#include <rtcore.h>

#include <cmath>
#include <cstdio>
#include <initializer_list>

int main() {
  RTCDevice device = rtcNewDevice(nullptr);
  RTCScene scene = rtcNewScene(device);
  RTCGeometry sphere = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_SPHERE_POINT);
  auto* point = static_cast<float*>(
      rtcSetNewGeometryBuffer(sphere, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, 4 * sizeof(float), 1));
  point[0] = point[1] = point[2] = 0;
  point[3] = 1;
  rtcCommitGeometry(sphere);
  rtcAttachGeometry(scene, sphere);
  rtcReleaseGeometry(sphere);
  rtcCommitScene(scene);
  for (const unsigned mask : {1u, 2u, 0x80000000u, 0xffffffffu}) {
    RTCRayHit hit{};
    hit.ray.org_z = 3;
    hit.ray.dir_z = -1;
    hit.ray.tfar = INFINITY;
    hit.ray.mask = mask;
    hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
#if RTC_VERSION_MAJOR == 3
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene, &context, &hit);
#else
    rtcIntersect1(scene, &hit);
#endif
    std::printf("ray mask %#x: %s, error %d\n", mask, hit.hit.geomID == RTC_INVALID_GEOMETRY_ID ? "miss" : "hit",
                rtcGetDeviceError(device));
  }
  rtcReleaseScene(scene);
  rtcReleaseDevice(device);
}
CPP
for suite in bookworm trixie; do
  root=$work/$suite/usr
  g++ -I"$(echo "$root"/include/embree?)" "$work/mask.cpp" "$root"/lib/x86_64-linux-gnu/libembree?.so \
    -Wl,--allow-shlib-undefined -o "$work/mask-$suite"
  run "$suite" "$work/mask-$suite" >"$work/seen-$suite"
done
expect "$work/seen-bookworm" bookworm <<'SEEN'
ray mask 0x1: hit, error 0
ray mask 0x2: hit, error 0
ray mask 0x80000000: hit, error 0
ray mask 0xffffffff: hit, error 0
SEEN
expect "$work/seen-trixie" trixie <<'SEEN'
ray mask 0x1: hit, error 0
ray mask 0x2: miss, error 0
ray mask 0x80000000: miss, error 0
ray mask 0xffffffff: hit, error 0
SEEN
