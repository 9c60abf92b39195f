// perforated_plate N FILE: a STEP file of a plate with N hexagonal holes, whose corners are rounded.
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepFilletAPI_MakeFillet2d.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepTools.hxx>
#include <Interface_Static.hxx>
#include <STEPControl_Writer.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <gp_Pln.hxx>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>

namespace {

constexpr double pitch = 10.0;  // millimetres
constexpr double radius = 4.0;  // of a hole's corners from its middle
constexpr double rounded = 1.0;
constexpr double thickness = 3.0;

TopoDS_Wire hole(double x, double y) {
    BRepBuilderAPI_MakePolygon polygon;
    for (int i = 0; i < 6; ++i) {
        const double angle = i * std::numbers::pi / 3.0;
        polygon.Add(gp_Pnt{x + radius * std::cos(angle), y + radius * std::sin(angle), 0.0});
    }
    polygon.Close();
    const TopoDS_Face face = BRepBuilderAPI_MakeFace{gp_Pln{}, polygon.Wire()};
    BRepFilletAPI_MakeFillet2d fillet{face};
    TopTools_IndexedMapOfShape corners;
    for (TopExp_Explorer vertex{face, TopAbs_VERTEX}; vertex.More(); vertex.Next()) corners.Add(vertex.Current());
    for (int i = 1; i <= corners.Extent(); ++i) fillet.AddFillet(TopoDS::Vertex(corners(i)), rounded);
    return BRepTools::OuterWire(TopoDS::Face(fillet.Shape()));
}

}  // namespace

int main(int count, char** arguments) {
    const int holes = count == 3 ? std::atoi(arguments[1]) : 0;
    if (holes < 1) {
        std::fprintf(stderr, "perforated_plate: error: expected a number of holes and a file\n");
        return 2;
    }
    const int columns = static_cast<int>(std::ceil(std::sqrt(holes)));
    const int rows = (holes + columns - 1) / columns;
    BRepBuilderAPI_MakePolygon outline{gp_Pnt{-pitch, -pitch, 0}, gp_Pnt{columns * pitch, -pitch, 0},
                                       gp_Pnt{columns * pitch, rows * pitch, 0}, gp_Pnt{-pitch, rows * pitch, 0}, true};
    BRepBuilderAPI_MakeFace face{gp_Pln{}, outline.Wire()};
    for (int i = 0; i < holes; ++i) face.Add(TopoDS::Wire(hole(i % columns * pitch, i / columns * pitch).Reversed()));
    STEPControl_Writer writer;
    Interface_Static::SetIVal("write.surfacecurve.mode", 0);  // as CAD programs write: without curves in (u, v)
    writer.Transfer(BRepPrimAPI_MakePrism{face.Face(), gp_Vec{0, 0, thickness}}.Shape(), STEPControl_AsIs);
    return writer.Write(arguments[2]) == IFSelect_RetDone ? 0 : 1;
}
