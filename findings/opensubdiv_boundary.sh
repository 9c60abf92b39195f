#!/bin/bash
# With its default options OpenSubdiv would be expected to subdivide a mesh that has an edge, such as a flat grid,
# whole. With 3.5.0 and 3.6.0 every face at the edge becomes a hole: of a 3 x 3 grid one patch is left of nine.
# Refinement still counts all 36 smaller faces, so the loss shows in the patches, or where a caller asks IsFaceHole.
# Sdc::Options starts with VTX_BOUNDARY_NONE, and no error or warning is given: a caller must set another.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=lib.sh
source "$(dirname "$0")/lib.sh"
need g++
unpack bookworm libosd-dev=3.5.0-2 libosdcpu3.5.0=3.5.0-2 libgomp1
unpack trixie libosd-dev=3.6.0-3 libosdcpu3.6.0=3.6.0-3 libgomp1 libstdc++6 libgcc-s1 libc6

cat >"$work/grid.cpp" <<'CPP'
#include <opensubdiv/far/patchTableFactory.h>
#include <opensubdiv/far/topologyDescriptor.h>

#include <cstdio>
#include <memory>
#include <vector>

using namespace OpenSubdiv;
using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;

static void refine(const char* title, Sdc::Options options) {
  std::vector<int> sizes(9, 4), corners;
  for (int face = 0; face < 9; ++face) {
    const int first = face / 3 * 4 + face % 3;
    corners.insert(corners.end(), {first, first + 1, first + 5, first + 4});
  }
  Far::TopologyDescriptor grid;
  grid.numVertices = 16;
  grid.numFaces = 9;
  grid.numVertsPerFace = sizes.data();
  grid.vertIndicesPerFace = corners.data();

  std::unique_ptr<Far::TopologyRefiner> uniform(Factory::Create(grid, {Sdc::SCHEME_CATMARK, options}));
  uniform->RefineUniform({1});
  const Far::TopologyLevel level = uniform->GetLevel(1);
  int holes = 0;
  for (int face = 0; face < level.GetNumFaces(); ++face) holes += level.IsFaceHole(face) ? 1 : 0;

  std::unique_ptr<Far::TopologyRefiner> adaptive(Factory::Create(grid, {Sdc::SCHEME_CATMARK, options}));
  adaptive->RefineAdaptive({2});
  std::unique_ptr<Far::PatchTable> patches(Far::PatchTableFactory::Create(*adaptive, {2}));
  std::printf("%s: %d faces after one step, %d of them holes; %d patches\n", title, level.GetNumFaces(), holes,
              patches->GetNumPatchesTotal());
}

int main() {
  Sdc::Options options;
  refine("default", options);
  options.SetVtxBoundaryInterpolation(Sdc::Options::VTX_BOUNDARY_EDGE_AND_CORNER);
  refine("edge and corner", options);
}
CPP
for suite in bookworm trixie; do
  root=$work/$suite/usr
  g++ -isystem "$root/include" "$work/grid.cpp" "$root"/lib/x86_64-linux-gnu/libosdCPU.so \
    -Wl,--allow-shlib-undefined -o "$work/grid"
  run "$suite" "$work/grid" >"$work/seen"
  expect "$work/seen" "$suite" <<'SEEN'
default: 36 faces after one step, 32 of them holes; 1 patches
edge and corner: 36 faces after one step, 0 of them holes; 9 patches
SEEN
done
