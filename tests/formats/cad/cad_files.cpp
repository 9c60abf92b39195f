#include "formats/cad/cad_files.h"

#include <BRepBuilderAPI_Copy.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GeomAPI_PointsToBSpline.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <IGESControl_Writer.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <STEPControl_Writer.hxx>
#include <ShapeUpgrade_ShapeDivideAngle.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Shell.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <gp_Ax1.hxx>
#include <gp_Ax2.hxx>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>
#include <gp_Trsf.hxx>

#include <array>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <sstream>
#include <stdexcept>

#include "base/temporary_folder.h"

namespace inkedge::cad_files {
namespace {

TopoDS_Shape box() { return BRepPrimAPI_MakeBox(10.0, 20.0, 30.0).Shape(); }

TopoDS_Shape rounded() {
    const TopoDS_Shape solid = box();
    BRepFilletAPI_MakeFillet fillet{solid};
    TopTools_IndexedMapOfShape edges;
    TopExp::MapShapes(solid, TopAbs_EDGE, edges);
    for (int i = 1; i <= edges.Extent(); ++i) {
        const TopoDS_Edge& edge = TopoDS::Edge(edges(i));
        const gp_Pnt a = BRep_Tool::Pnt(TopExp::FirstVertex(edge));
        const gp_Pnt b = BRep_Tool::Pnt(TopExp::LastVertex(edge));
        if (std::abs(a.Z() - b.Z()) > 1.0) fillet.Add(2.0, edge);
    }
    return fillet.Shape();
}

TopoDS_Shape halves() {
    ShapeUpgrade_ShapeDivideAngle divide{std::numbers::pi, BRepPrimAPI_MakeCylinder(5.0, 12.0).Shape()};
    divide.Perform();
    return divide.Result();
}

TopoDS_Shape asSplines(const TopoDS_Shape& shape) { return BRepBuilderAPI_NurbsConvert(shape).Shape(); }

TopoDS_Shape offsetTorus() {
    const Handle(Geom_Surface) tube = new Geom_ToroidalSurface{gp_Ax3{}, 8.0, 2.0};
    const Handle(Geom_Surface) spline = GeomConvert::SurfaceToBSplineSurface(tube);
    return BRepBuilderAPI_MakeFace(new Geom_OffsetSurface{spline, 1.0}, 1e-6).Shape();
}

TopoDS_Shape scaledTorus() {
    gp_Trsf mirror;
    mirror.SetMirror(gp_Ax2{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}});
    gp_Trsf twice;
    twice.SetScale(gp_Pnt{}, 2.0);
    TopoDS_Shape torus = BRepPrimAPI_MakeTorus(4.0, 1.5).Shape();
    torus.Location(TopLoc_Location{mirror * twice}, false);
    return torus;
}

TopoDS_Edge curve() {
    TColgp_Array1OfPnt points{1, 5};
    for (int i = 1; i <= 5; ++i) points.SetValue(i, {3.0 + i, 0.0, 1.5 * std::sin(static_cast<double>(i))});
    return BRepBuilderAPI_MakeEdge(GeomAPI_PointsToBSpline{points}.Curve()).Edge();
}

// The faces of a shape but for some, each by itself or as one shell.
enum class As { Shell, Pieces };
TopoDS_Shape facesOf(const TopoDS_Shape& shape, int leftOut, As as) {
    const BRep_Builder builder;
    TopoDS_Compound pieces;
    TopoDS_Shell shell;
    builder.MakeCompound(pieces);
    builder.MakeShell(shell);
    int number = 0;
    for (TopExp_Explorer face{shape, TopAbs_FACE}; face.More(); face.Next()) {
        if (number++ == leftOut) continue;
        if (as == As::Shell)
            builder.Add(shell, face.Current());
        else
            builder.Add(pieces, BRepBuilderAPI_Copy(face.Current()).Shape());
    }
    return as == As::Shell ? TopoDS_Shape{shell} : TopoDS_Shape{pieces};
}

TopoDS_Shape moved(const TopoDS_Shape& shape) {
    gp_Trsf trsf;
    trsf.SetTransformation(gp_Ax3{{100.0, 0.0, 0.0}, {1.0, 0.0, 0.0}}, gp_Ax3{});
    return shape.Moved(TopLoc_Location{trsf});
}

TopoDS_Shape mirrored(const TopoDS_Shape& shape) {
    gp_Trsf trsf;
    trsf.SetMirror(gp_Ax2{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}});
    return BRepBuilderAPI_Transform{shape, trsf, true}.Shape();
}

TopoDS_Shape withCurves(const TopoDS_Shape& shape) {
    const BRep_Builder builder;
    TopoDS_Compound all;
    builder.MakeCompound(all);
    builder.Add(all, shape);
    builder.Add(all, curve());
    builder.Add(all, BRepBuilderAPI_MakeEdge(gp_Circ{gp_Ax2{}, 3.0}).Edge());
    builder.Add(all, BRepBuilderAPI_MakeVertex(gp_Pnt{1.0, 2.0, 3.0}).Vertex());
    return all;
}

TopoDS_Shape crossing() {
    const BRep_Builder builder;
    TopoDS_Compound both;
    builder.MakeCompound(both);
    builder.Add(both, box());
    builder.Add(both, BRepPrimAPI_MakeCylinder(gp_Ax2{{-10.0, 10.0, 15.0}, {1.0, 0.0, 0.0}}, 4.0, 30.0).Shape());
    return both;
}

TopoDS_Shape manyHoles() {
    BRepBuilderAPI_MakeFace face{gp_Pln{}, 0.0, 100.0, 0.0, 100.0};
    const auto cut = [&](const TopoDS_Wire& wire) { face.Add(TopoDS::Wire(wire.Reversed())); };
    for (int i = 0; i < 64; ++i) {
        const gp_Pnt low{2.0 + 12.0 * (i % 8), 2.0 + 8.0 * (i / 8), 0.0};
        cut(BRepBuilderAPI_MakePolygon{low, low.Translated({4, 0, 0}), low.Translated({4, 4, 0}),
                                       low.Translated({0, 4, 0}), true});
    }
    for (const double x : {45.0, 55.0})
        cut(BRepBuilderAPI_MakeWire{BRepBuilderAPI_MakeEdge{gp_Circ{gp_Ax2{{x, 84.0, 0.0}, gp::DZ()}, 8.0}}});
    return face.Face();
}

// Of a square of 19 about (x, 0), its corner rounded by 0.4, what lies outside a circle about the same point.
TopoDS_Shape corner() {
    constexpr double x = 0.154275;
    constexpr double half = 9.5;
    constexpr double rounding = 0.4;
    constexpr double radius = 9.51;
    const double cut = std::sqrt(radius * radius - half * half);
    const auto circle = [](double cx, double cy, double r) { return gp_Circ{gp_Ax2{{cx, cy, 0.0}, gp::DZ()}, r}; };
    const std::array<gp_Pnt, 4> points{gp_Pnt{x - cut, half, 0.0}, gp_Pnt{x - half, cut, 0.0},
                                       gp_Pnt{x - half, half - rounding, 0.0}, gp_Pnt{x - half + rounding, half, 0.0}};
    BRepBuilderAPI_MakeWire wire;
    wire.Add(BRepBuilderAPI_MakeEdge{circle(x, 0.0, radius), points[0], points[1]});
    wire.Add(BRepBuilderAPI_MakeEdge{points[1], points[2]});
    wire.Add(BRepBuilderAPI_MakeEdge{circle(x - half + rounding, half - rounding, rounding), points[3], points[2]});
    wire.Add(BRepBuilderAPI_MakeEdge{points[3], points[0]});
    return BRepBuilderAPI_MakeFace{gp_Pln{}, wire.Wire()}.Face();
}

TopoDS_Shape make(Shape shape) {
    Message::DefaultMessenger()->ChangePrinters().Clear();
    switch (shape) {
        case Shape::Box:
            return box();
        case Shape::Cylinder:
            return BRepPrimAPI_MakeCylinder(5.0, 12.0).Shape();
        case Shape::Halves:
            return halves();
        case Shape::Cone:
            return BRepPrimAPI_MakeCone(6.0, 0.0, 8.0).Shape();
        case Shape::Sphere:
            return BRepPrimAPI_MakeSphere(4.0).Shape();
        case Shape::Torus:
            return BRepPrimAPI_MakeTorus(8.0, 3.0).Shape();
        case Shape::Rounded:
            return rounded();
        case Shape::SplineTorus:
            return asSplines(BRepPrimAPI_MakeTorus(8.0, 3.0).Shape());
        case Shape::SplineCone:
            return asSplines(BRepPrimAPI_MakeCone(6.0, 0.0, 8.0).Shape());
        case Shape::OffsetTorus:
            return offsetTorus();
        case Shape::ScaledTorus:
            return scaledTorus();
        case Shape::SplineHalves:
            return asSplines(halves());
        case Shape::Extruded:
            return BRepPrimAPI_MakePrism(curve(), gp_Vec{0.0, 5.0, 0.0}).Shape();
        case Shape::Revolved:
            return BRepPrimAPI_MakeRevol(curve(), gp_Ax1{}).Shape();
        case Shape::OpenBox:
            return facesOf(box(), 5, As::Shell);
        case Shape::Pieces:
            return facesOf(box(), -1, As::Pieces);
        case Shape::Moved:
            return moved(BRepPrimAPI_MakeCylinder(5.0, 12.0).Shape());
        case Shape::Mirrored:
            return mirrored(box());
        case Shape::CurvesAndPoint:
            return withCurves(box());
        case Shape::Crossing:
            return crossing();
        case Shape::ManyHoles:
            return manyHoles();
        case Shape::Corner:
            return corner();
    }
    return {};
}

// What a writer that knows files alone writes.
template <class Write>
std::string written(Write write) {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder / "model";
    write(file.c_str());
    return contents(file);
}

std::string stepOf(const TopoDS_Shape& shape, const std::string& schema, const std::string& unit) {
    return written([&](const char* file) {
        STEPControl_Writer writer;
        Interface_Static::SetCVal("write.step.schema", schema.c_str());
        Interface_Static::SetCVal("write.step.unit", unit.c_str());
        writer.Transfer(shape, STEPControl_AsIs);
        writer.Write(file);
        Interface_Static::SetCVal("write.step.unit", "MM");
    });
}

}  // namespace

std::string step(Shape shape, const std::string& schema, const std::string& unit) {
    return stepOf(make(shape), schema, unit);
}

std::string scaledStep(Shape shape, double scale) {
    gp_Trsf trsf;
    trsf.SetScale(gp_Pnt{}, scale);
    return stepOf(BRepBuilderAPI_Transform{make(shape), trsf, true}.Shape(), "AP214IS", "MM");
}

std::string iges(Shape shape) {
    return written([&](const char* file) {
        IGESControl_Writer writer;
        writer.AddShape(make(shape));
        writer.Write(file);
    });
}

std::string brep(Shape shape) {
    std::ostringstream text;
    BRepTools::Write(make(shape), text);
    return text.str();
}

std::string assembly() {
    Message::DefaultMessenger()->ChangePrinters().Clear();
    Handle(TDocStd_Document) document;
    XCAFApp_Application::GetApplication()->NewDocument("MDTV-XCAF", document);
    const Handle(XCAFDoc_ShapeTool) shapes = XCAFDoc_DocumentTool::ShapeTool(document->Main());
    const Handle(XCAFDoc_ColorTool) colors = XCAFDoc_DocumentTool::ColorTool(document->Main());
    const TopoDS_Shape legShape = BRepPrimAPI_MakeBox(2.0, 2.0, 10.0).Shape();
    const TopoDS_Shape plateShape = BRepPrimAPI_MakeBox(gp_Pnt{0.0, 0.0, 10.0}, gp_Pnt{22.0, 2.0, 11.0}).Shape();
    const TDF_Label table = shapes->NewShape();
    const TDF_Label leg = shapes->AddShape(legShape, false);
    const TDF_Label plate = shapes->AddShape(plateShape, false);
    gp_Trsf aside;
    aside.SetTranslation(gp_Vec{20.0, 0.0, 0.0});
    const TDF_Label first = shapes->AddComponent(table, leg, TopLoc_Location{});
    const TDF_Label second = shapes->AddComponent(table, leg, TopLoc_Location{aside});
    const TDF_Label third = shapes->AddComponent(table, plate, TopLoc_Location{});
    TDataStd_Name::Set(table, "table");
    TDataStd_Name::Set(leg, "leg");
    TDataStd_Name::Set(plate, "plate");
    TDataStd_Name::Set(first, "leg one");
    TDataStd_Name::Set(second, "leg two");
    TDataStd_Name::Set(third, "plate");
    colors->SetColor(leg, Quantity_Color{1.0, 0.0, 0.0, Quantity_TOC_RGB}, XCAFDoc_ColorSurf);
    colors->SetColor(plate, Quantity_Color{0.0, 0.0, 1.0, Quantity_TOC_RGB}, XCAFDoc_ColorSurf);
    int number = 0;
    for (TopExp_Explorer face{plateShape, TopAbs_FACE}; face.More(); face.Next())
        if (number++ == 5)
            colors->SetColor(shapes->AddSubShape(plate, face.Current()),
                             Quantity_Color{0.0, 1.0, 0.0, Quantity_TOC_RGB}, XCAFDoc_ColorSurf);
    shapes->UpdateAssemblies();
    return written([&](const char* file) {
        STEPCAFControl_Writer writer;
        writer.SetColorMode(true);
        writer.SetNameMode(true);
        writer.Transfer(document);
        writer.Write(file);
    });
}

}  // namespace inkedge::cad_files
