#!/bin/bash
# A face on an offset of a B-spline surface (ISO 10303-42, offset_surface) is written to STEP by OpenCASCADE's
# STEPControl_Writer, which reports success. Its STEPControl_Reader reports success, too: one root, transferred; but
# what it gives is a shell without a face. The same face on an offset of a torus comes back whole. A reader that counts
# roots loses the face without a word; whether one is missing shows only in the area, or in the checks of the transfer.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=lib.sh
source "$(dirname "$0")/lib.sh"
need g++
unpack_whole bookworm libocct-data-exchange-dev=7.6.3+dfsg1-7 libocct-modeling-algorithms-dev=7.6.3+dfsg1-7
unpack_whole trixie libocct-data-exchange-dev=7.8.1+dfsg1-3 libocct-modeling-algorithms-dev=7.8.1+dfsg1-3

cat >"$work/offset.cpp" <<'CPP'
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Reader.hxx>
#include <STEPControl_Writer.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Face.hxx>

#include <cstdio>

double areaOf(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  BRepGProp::SurfaceProperties(shape, properties);
  return properties.Mass();
}

void tryOne(const char* name, const Handle(Geom_Surface)& surface) {
  const TopoDS_Shape face = BRepBuilderAPI_MakeFace(surface, 1e-6).Shape();
  STEPControl_Writer writer;
  const bool written = writer.Transfer(face, STEPControl_AsIs) == IFSelect_RetDone &&
                       writer.Write("offset.step") == IFSelect_RetDone;
  STEPControl_Reader reader;
  const bool read = reader.ReadFile("offset.step") == IFSelect_RetDone;
  const int roots = reader.TransferRoots();
  int faces = 0;
  for (TopExp_Explorer each{reader.OneShape(), TopAbs_FACE}; each.More(); each.Next()) ++faces;
  std::printf("%s: area %.0f, %s, %s, %d root, %d face, area %.0f\n", name, areaOf(face),
              written ? "written" : "not written", read ? "read" : "not read", roots, faces, areaOf(reader.OneShape()));
}

int main() {
  Message::DefaultMessenger()->ChangePrinters().Clear();
  const Handle(Geom_Surface) torus = new Geom_ToroidalSurface{gp_Ax3{}, 8.0, 2.0};
  const Handle(Geom_Surface) spline = GeomConvert::SurfaceToBSplineSurface(torus);
  tryOne("B-spline", spline);
  tryOne("offset of a torus", new Geom_OffsetSurface{torus, 1.0});
  tryOne("offset of a B-spline", new Geom_OffsetSurface{spline, 1.0});
}
CPP
for suite in bookworm trixie; do
  root=$work/$suite/usr
  libraries=()
  for name in TKSTEP TKDESTEP TKXSBase TKTopAlgo TKGeomBase TKBRep TKG3d TKMath TKernel; do
    [[ ! -e $root/lib/x86_64-linux-gnu/lib$name.so ]] || libraries+=("$root/lib/x86_64-linux-gnu/lib$name.so")
  done
  g++ -w -I "$root/include/opencascade" "$work/offset.cpp" -o "$work/offset-$suite" "${libraries[@]}" \
    -Wl,--allow-shlib-undefined
  (cd "$work" && run_whole "$suite" "$work/offset-$suite") | grep -v '^$' | grep : >"$work/seen"
  expect "$work/seen" "$suite" <<'END'
B-spline: area 635, written, read, 1 root, 1 face, area 635
offset of a torus: area 947, written, read, 1 root, 1 face, area 947
offset of a B-spline: area 950, written, read, 1 root, 0 face, area 0
END
done
