#include "formats/cad/occt_sew.h"

#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepLib.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <ShapeFix_Solid.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>

#include <algorithm>
#include <cmath>

namespace inkedge::cad {
namespace {

// How many faces have an edge that no other face shares.
int looseFaces(const TopoDS_Shape& shape) {
    TopTools_IndexedDataMapOfShapeListOfShape edges;
    TopExp::MapShapesAndUniqueAncestors(shape, TopAbs_EDGE, TopAbs_FACE, edges);
    TopTools_IndexedMapOfShape loose;
    for (int i = 1; i <= edges.Extent(); ++i) {
        const TopoDS_Edge& edge = TopoDS::Edge(edges.FindKey(i));
        if (edges(i).Extent() != 1 || BRep_Tool::Degenerated(edge)) continue;
        const TopoDS_Face& face = TopoDS::Face(edges(i).First());
        if (!BRep_Tool::IsClosed(edge, face)) loose.Add(face);
    }
    return loose.Extent();
}

double toleranceOf(const TopoDS_Shape& shape) {
    constexpr double share = 1e-5;  // of the size: what IGES writers leave between faces
    Bnd_Box box;
    BRepBndLib::Add(shape, box, false);
    const double size = box.IsVoid() ? 1.0 : std::sqrt(box.SquareExtent());
    return std::max(1e-6, share * std::min(size, 1e6));
}

// Solids of the closed shells, turned outward; other faces as they are.
TopoDS_Shape withSolids(const TopoDS_Shape& sewn) {
    TopoDS_Compound all;
    const BRep_Builder builder;
    builder.MakeCompound(all);
    for (TopExp_Explorer shell{sewn, TopAbs_SHELL}; shell.More(); shell.Next()) {
        if (!BRep_Tool::IsClosed(shell.Current())) {
            builder.Add(all, shell.Current());
            continue;
        }
        TopoDS_Solid solid;
        builder.MakeSolid(solid);
        builder.Add(solid, shell.Current());
        BRepLib::OrientClosedSolid(solid);
        builder.Add(all, solid);
    }
    for (TopExp_Explorer face{sewn, TopAbs_FACE, TopAbs_SHELL}; face.More(); face.Next())
        builder.Add(all, face.Current());
    return all;
}

}  // namespace

void sew(DocumentPart& part) {
    if (looseFaces(part.shape) < 2) return;
    TopTools_IndexedMapOfShape before;
    TopExp::MapShapes(part.shape, TopAbs_FACE, before);
    BRepBuilderAPI_Sewing sewing{toleranceOf(part.shape)};
    sewing.Add(part.shape);
    sewing.Perform();
    const TopoDS_Shape sewn = withSolids(sewing.SewedShape());
    TopTools_IndexedMapOfShape after;
    TopExp::MapShapes(sewn, TopAbs_FACE, after);
    if (after.Extent() != before.Extent()) return;  // faces were lost: better loose than none
    std::vector<std::uint32_t> materials(part.materials.size(), 0);
    std::vector<bool> invisible(part.invisible.size(), false);
    for (int i = 1; i <= before.Extent() && !part.materials.empty(); ++i) {
        const int to = after.FindIndex(sewing.ModifiedSubShape(before(i)));
        if (to == 0) return;
        materials[static_cast<std::size_t>(to - 1)] = part.materials[static_cast<std::size_t>(i - 1)];
        invisible[static_cast<std::size_t>(to - 1)] = part.invisible[static_cast<std::size_t>(i - 1)];
    }
    part.shape = sewn;
    part.materials = std::move(materials);
    part.invisible = std::move(invisible);
}

}  // namespace inkedge::cad
