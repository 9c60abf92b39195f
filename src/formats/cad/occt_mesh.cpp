#include "formats/cad/occt_mesh.h"

#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepMesh_Context.hxx>
#include <BRepMesh_DelabellaMeshAlgoFactory.hxx>
#include <BRepMesh_FaceDiscret.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepMesh_MeshAlgoFactory.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <IMeshData_Face.hxx>
#include <IMeshTools_MeshAlgo.hxx>
#include <IMeshTools_Parameters.hxx>
#include <Poly_Triangulation.hxx>
#include <Precision.hxx>
#include <ShapeFix_ShapeTolerance.hxx>
#include <TopExp.hxx>
#include <TopLoc_Location.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Pnt.hxx>
#include <gp_Trsf.hxx>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "formats/cad/occt_edges.h"
#include "formats/cad/occt_faces.h"
#include "formats/cad/occt_surfaces.h"
#include "formats/cad/occt_vectors.h"

namespace inkedge::cad {
namespace {

// Radians between the normals of neighbouring triangles: under the usual crease angle, so that no pixels of a fillet
// bend as those of a crease do.
constexpr double angularDeflection = 0.45;

// The usual algorithm, but for planes with very many holes Delabella's, which is far quicker there. Over some planes
// without holes that crashes; on curved faces it makes other triangles.
constexpr int veryMany = 64;
class PlaneAlgorithm final : public IMeshTools_MeshAlgo {
public:
    void Perform(const IMeshData::IFaceHandle& face, const IMeshTools_Parameters& parameters,
                 const Message_ProgressRange& range) override {
        const Handle(IMeshTools_MeshAlgo) algorithm =
            face->WiresNb() > veryMany ? BRepMesh_DelabellaMeshAlgoFactory{}.GetAlgo(GeomAbs_Plane, parameters)
                                       : BRepMesh_MeshAlgoFactory{}.GetAlgo(GeomAbs_Plane, parameters);
        algorithm->Perform(face, parameters, range);
    }
};

class MeshAlgorithms final : public IMeshTools_MeshAlgoFactory {
public:
    [[nodiscard]] Handle(IMeshTools_MeshAlgo)
        GetAlgo(GeomAbs_SurfaceType surface, const IMeshTools_Parameters& parameters) const override {
        if (surface == GeomAbs_Plane) return new PlaneAlgorithm;
        return ofOthers_->GetAlgo(surface, parameters);
    }

private:
    Handle(IMeshTools_MeshAlgoFactory) ofOthers_ = new BRepMesh_MeshAlgoFactory;
};

template <class Visit>
void forEachFace(const DocumentPart& part, Visit&& visit) {
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(part.shape, TopAbs_FACE, faces);
    for (int i = 1; i <= faces.Extent(); ++i) {
        const auto number = static_cast<std::size_t>(i - 1);
        if (part.invisible.empty() || !part.invisible[number]) visit(TopoDS::Face(faces(i)), number);
    }
}

// Collects the triangles of a part.
class Collector {
public:
    Collector(const DocumentPart& part, double deflection) : part_{part}, deflection_{deflection} {
        mesh_.name = part.name;
    }

    Part collect() {
        chooseOrigin();
        std::vector<MeshedFace> faces;
        forEachFace(part_, [&](const TopoDS_Face& face, std::size_t number) {
            if (auto meshed = MeshedFace::of(face)) {
                meshed->number = number;
                faces.push_back(std::move(*meshed));
            }
        });
        const EdgeTable edges{faces};
        for (std::size_t i = 0; i < faces.size(); ++i) {
            faces[i].refine(part_.scale * deflection_,
                            [&](std::uint32_t a, std::uint32_t b) { return edges.isBorder(i, a, b); });
            add(faces[i], i, edges);
        }
        return std::move(mesh_);
    }

private:
    void chooseOrigin() {
        glm::dvec3 low{std::numeric_limits<double>::max()};
        glm::dvec3 high{std::numeric_limits<double>::lowest()};
        for (const glm::dvec3 point : pointsOf(part_)) {
            low = glm::min(low, point);
            high = glm::max(high, point);
        }
        if (low.x <= high.x) mesh_.origin = 0.5 * (low + high);
    }

    void add(const MeshedFace& face, std::size_t index, const EdgeTable& edges) {
        const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
        for (std::size_t i = 0; i < face.positions.size(); ++i) {
            mesh_.positions.emplace_back(face.positions[i] / part_.scale - mesh_.origin);
            mesh_.normals.emplace_back(face.normals[i]);
            mesh_.parameters.push_back(face.parameters[i]);
            if (!face.poles.empty()) takePole(face.poles[i], mesh_.parameters.back());
        }
        const auto number = static_cast<std::uint32_t>(mesh_.surfaces.size());
        mesh_.surfaces.push_back(surfaceOf(face.face));
        mesh_.surfaces.back().location /= part_.scale;
        const std::uint32_t own = part_.materials.empty() ? 0 : part_.materials[face.number];
        for (const std::array<std::uint32_t, 3>& triangle : face.triangles) {
            if (isCollapsed(face, triangle)) continue;
            for (std::size_t k = 0; k < 3; ++k) {
                mesh_.indices.push_back(first + triangle[k]);
                mesh_.edges.push_back(edges.kindOf(index, triangle[k], triangle[(k + 1) % 3]));
            }
            mesh_.faces.push_back(number);
            mesh_.materials.push_back(own != 0 ? own : part_.material);
        }
    }

    static void takePole(Pole pole, glm::dvec2& parameters) {
        constexpr double any = std::numeric_limits<double>::quiet_NaN();
        if (pole == Pole::OfU) parameters.x = any;
        if (pole == Pole::OfV) parameters.y = any;
    }

    // At a pole several nodes are one point.
    [[nodiscard]] static bool isCollapsed(const MeshedFace& face, const std::array<std::uint32_t, 3>& t) {
        const auto same = [&](std::size_t a, std::size_t b) { return face.positions[t[a]] == face.positions[t[b]]; };
        return same(0, 1) || same(1, 2) || same(2, 0);
    }

    const DocumentPart& part_;
    double deflection_;
    Part mesh_;
};

}  // namespace

void tessellate(const DocumentPart& part, double deflection) {
    BRepTools::Clean(part.shape);
    IMeshTools_Parameters parameters;
    parameters.Deflection = part.scale * deflection;
    parameters.Angle = angularDeflection;
    parameters.InParallel = true;
    const Handle(IMeshTools_Context) context = new BRepMesh_Context;
    context->SetFaceDiscret(new BRepMesh_FaceDiscret{new MeshAlgorithms});
    BRepMesh_IncrementalMesh mesher;
    mesher.SetShape(part.shape);
    mesher.ChangeParameters() = parameters;
    mesher.Perform(context);
    if (lacksTriangles(part)) const BRepMesh_IncrementalMesh byDefault{part.shape, parameters};
}

bool lacksTriangles(const DocumentPart& part) {
    bool lacks = false;
    forEachFace(part, [&](const TopoDS_Face& face, std::size_t) {
        TopLoc_Location location;
        lacks = lacks || BRep_Tool::Triangulation(face, location).IsNull();
    });
    return lacks;
}

void bringToUsualSize(DocumentPart& part) {
    constexpr double smallest = 1.0;  // millimetres
    constexpr double largest = 1e4;
    constexpr double usual = 100.0;
    constexpr double ofAccuracy = 100.0;  // of OpenCASCADE: tolerances are scaled, too
    const std::vector<glm::dvec3> corners = boxOf(part);
    if (corners.empty()) return;
    const double size = glm::distance(corners.front(), corners.back());
    if (!(size > 0.0) || !(size < 1e30) || (size >= smallest && size <= largest)) return;
    part.scale = std::exp2(std::round(std::log2(usual / size)));
    gp_Trsf trsf;
    trsf.SetScale(gp_Pnt{}, part.scale);
    part.shape = BRepBuilderAPI_Transform{part.shape, trsf, true}.Shape();
    ShapeFix_ShapeTolerance{}.LimitTolerance(part.shape, Precision::Confusion(), ofAccuracy * Precision::Confusion());
}

Part meshOf(const DocumentPart& part, double deflection) { return Collector{part, deflection}.collect(); }

std::vector<glm::dvec3> pointsOf(const DocumentPart& part) {
    std::vector<glm::dvec3> points;
    forEachFace(part, [&](const TopoDS_Face& face, std::size_t) {
        TopLoc_Location location;
        const Handle(Poly_Triangulation) triangles = BRep_Tool::Triangulation(face, location);
        if (triangles.IsNull()) return;
        for (int i = 1; i <= triangles->NbNodes(); ++i)
            points.push_back(vectorOf(triangles->Node(i).Transformed(location.Transformation()).XYZ()) / part.scale);
    });
    return points;
}

std::vector<glm::dvec3> boxOf(const DocumentPart& part) {
    Bnd_Box box;
    forEachFace(part, [&](const TopoDS_Face& face, std::size_t) { BRepBndLib::Add(face, box, false); });
    std::vector<glm::dvec3> corners;
    if (box.IsVoid()) return corners;
    const glm::dvec3 low = vectorOf(box.CornerMin().XYZ()) / part.scale;
    const glm::dvec3 high = vectorOf(box.CornerMax().XYZ()) / part.scale;
    for (int i = 0; i < 8; ++i)
        corners.emplace_back((i & 1) != 0 ? high.x : low.x, (i & 2) != 0 ? high.y : low.y,
                             (i & 4) != 0 ? high.z : low.z);
    return corners;
}

}  // namespace inkedge::cad
