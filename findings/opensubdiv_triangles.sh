#!/bin/bash
# The derivatives that OpenSubdiv's Bfr::Surface evaluates would be expected to be those of the surface. With 3.5.0 and
# 3.6.0 the second ones of Loop's scheme have the wrong sign on parts of faces at points where other than six faces
# meet: on the triangles that refinement turns about. Positions and first derivatives are right. A caller must compare
# with a difference of first derivatives.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=lib.sh
source "$(dirname "$0")/lib.sh"
need g++
unpack bookworm libosd-dev=3.5.0-2 libosdcpu3.5.0=3.5.0-2 libgomp1
unpack trixie libosd-dev=3.6.0-3 libosdcpu3.6.0=3.6.0-3 libgomp1 libstdc++6 libgcc-s1 libc6

cat >"$work/octahedron.cpp" <<'CPP'
#include <opensubdiv/bfr/refinerSurfaceFactory.h>
#include <opensubdiv/bfr/surface.h>
#include <opensubdiv/far/topologyDescriptor.h>

#include <cstdio>
#include <memory>
#include <vector>

using namespace OpenSubdiv;
using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;

int main() {
  const double positions[] = {1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1};
  const int sizes[] = {3, 3, 3, 3, 3, 3, 3, 3};
  const int corners[] = {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};
  Far::TopologyDescriptor octahedron;
  octahedron.numVertices = 6;
  octahedron.numFaces = 8;
  octahedron.numVertsPerFace = sizes;
  octahedron.vertIndicesPerFace = corners;
  std::unique_ptr<Far::TopologyRefiner> refiner(Factory::Create(octahedron, {Sdc::SCHEME_LOOP, {}}));
  Bfr::SurfaceFactory::Options options;
  Bfr::RefinerSurfaceFactory<> factory(*refiner, options.SetApproxLevelSmooth(6));
  Bfr::Surface<double> surface;
  factory.InitVertexSurface(0, &surface);
  std::vector<double> points(3 * surface.GetNumPatchPoints());
  surface.PreparePatchPoints(positions, 3, points.data(), 3);
  const auto evaluate = [&](double u, double v, double* derivatives) {  // x, x_u, x_v, x_uu, x_uv, x_vv
    const double uv[] = {u, v};
    double* const d = derivatives;
    surface.Evaluate(uv, points.data(), 3, d, d + 3, d + 6, d + 9, d + 12, d + 15);
  };
  const double step = 1e-5;
  const double parameters[][2] = {{0.8, 0.02}, {0.36, 0.3}};
  for (const auto& at : parameters) {
    double here[18], right[18], left[18];
    evaluate(at[0], at[1], here);
    evaluate(at[0] + step, at[1], right);
    evaluate(at[0] - step, at[1], left);
    std::printf("at (%.2f, %.2f) x_uu is (%.2f, %.2f, %.2f), by differences of x_u (%.2f, %.2f, %.2f)\n", at[0], at[1],
                here[9], here[10], here[11], (right[3] - left[3]) / (2 * step), (right[4] - left[4]) / (2 * step),
                (right[5] - left[5]) / (2 * step));
  }
}
CPP
for suite in bookworm trixie; do
  root=$work/$suite/usr
  g++ -isystem "$root/include" "$work/octahedron.cpp" "$root"/lib/x86_64-linux-gnu/libosdCPU.so \
    -Wl,--allow-shlib-undefined -o "$work/octahedron"
  run "$suite" "$work/octahedron" >"$work/seen"
  expect "$work/seen" "$suite" <<'SEEN'
at (0.80, 0.02) x_uu is (0.83, -1.42, -0.12), by differences of x_u (0.83, -1.42, -0.12)
at (0.36, 0.30) x_uu is (0.88, 0.94, 0.73), by differences of x_u (-0.88, -0.94, -0.73)
SEEN
done
