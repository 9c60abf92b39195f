#include "formats/cad/lost_nodes.h"

#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

#include <cstdint>
#include <vector>

#include "formats/cad/occt_edges.h"
#include "formats/cad/occt_faces.h"

namespace inkedge::cad_files {
namespace {

Handle(Poly_PolygonOnTriangulation) nodesOf(const TopoDS_Edge& edge, const TopoDS_Face& face) {
    TopLoc_Location location;
    return BRep_Tool::PolygonOnTriangulation(edge, BRep_Tool::Triangulation(face, location), location);
}

}  // namespace

LostNodes boxOfLostNodes() {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(10.0, 20.0, 30.0).Shape();
    const BRepMesh_IncrementalMesh mesh{box, 1.0};
    std::vector<cad::MeshedFace> faces;
    for (TopExp_Explorer each{box, TopAbs_FACE}; each.More(); each.Next())
        faces.push_back(cad::MeshedFace::of(TopoDS::Face(each.Current())).value());

    const TopoDS_Face& first = faces.front().face;
    const TopoDS_Edge lost = TopoDS::Edge(TopExp_Explorer{first, TopAbs_EDGE}.Current());
    TColStd_Array1OfInteger zeros{1, nodesOf(lost, first)->NbNodes()};
    zeros.Init(0);
    TopLoc_Location location;
    BRep_Builder{}.UpdateEdge(lost, new Poly_PolygonOnTriangulation{zeros},
                              BRep_Tool::Triangulation(first, location), location);

    const cad::EdgeTable table{faces};
    LostNodes found;
    for (std::size_t i = 0; i < faces.size(); ++i) {
        for (const auto& t : faces[i].triangles)
            for (std::size_t k = 0; k < 3; ++k) found.borders += table.isBorder(i, t[k], t[(k + 1) % 3]) ? 1 : 0;
        if (i == 0) continue;
        if (const auto nodes = nodesOf(lost, faces[i].face); !nodes.IsNull()) {
            const auto node = [&](int number) { return static_cast<std::uint32_t>(nodes->Nodes().Value(number) - 1); };
            found.onOther = static_cast<EdgeKind>(table.kindOf(i, node(1), node(2)));
        }
    }
    return found;
}

}  // namespace inkedge::cad_files
