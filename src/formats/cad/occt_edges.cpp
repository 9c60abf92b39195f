#include "formats/cad/occt_edges.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRep_Tool.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <gp_Pnt.hxx>
#include <gp_Vec.hxx>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "formats/cad/occt_vectors.h"

namespace inkedge::cad {
namespace {

// Radians: what OpenCASCADE's own STEP reader takes for no bend.
constexpr double sameNormal = 0.01;
// Of the larger curvature: what approximated surfaces are off by.
constexpr double sameCurvature = 0.05;
// Curvature times size of the part: flat.
constexpr double flat = 0.02;

std::uint64_t keyOf(std::uint32_t a, std::uint32_t b) {
    const auto [lesser, greater] = std::minmax(a, b);
    return std::uint64_t{lesser} << 32U | greater;
}

// An edge of the file as the nodes of one face along it.
struct Run {
    std::size_t face;
    std::vector<std::uint32_t> nodes;
};

// A surface near an edge.
struct Local {
    glm::dvec3 normal{0.0};  // towards the front; 0: none
    glm::dvec3 du{0.0}, dv{0.0}, duu{0.0}, duv{0.0}, dvv{0.0};

    // The normal curvature along a unit vector of the tangent plane, over 0 where the surface bends to its front.
    [[nodiscard]] double curvatureAlong(glm::dvec3 direction) const {
        const double e = glm::dot(du, du);
        const double f = glm::dot(du, dv);
        const double g = glm::dot(dv, dv);
        const double determinant = e * g - f * f;
        const double p = glm::dot(direction, du);
        const double q = glm::dot(direction, dv);
        const double a = (p * g - q * f) / determinant;
        const double b = (q * e - p * f) / determinant;
        return glm::dot(normal, a * a * duu + 2.0 * a * b * duv + b * b * dvv);
    }
};

// The faces of a part and the surfaces below them.
class Surfaces {
public:
    explicit Surfaces(const std::vector<MeshedFace>& faces) : faces_{faces}, adaptors_(faces.size()) {
        glm::dvec3 low{std::numeric_limits<double>::max()};
        glm::dvec3 high{std::numeric_limits<double>::lowest()};
        for (const MeshedFace& face : faces) {
            for (const glm::dvec3& p : face.positions) {
                low = glm::min(low, p);
                high = glm::max(high, p);
            }
        }
        size_ = low.x <= high.x ? glm::distance(low, high) : 1.0;
    }

    [[nodiscard]] EdgeKind kindOf(const Run& one, const Run& other, std::size_t i) {
        const std::size_t j = i + 1;
        for (const std::size_t node : {i, j})
            if (bends(normal(one, node), normal(other, node))) return EdgeKind::Sharp;
        const Local a = middle(one, i, j);
        const Local b = middle(other, i, j);
        if (a.normal == glm::dvec3{0.0} || b.normal == glm::dvec3{0.0}) return EdgeKind::Tangent;
        if (bends(a.normal, b.normal)) return EdgeKind::Sharp;
        const glm::dvec3 along = position(one, j) - position(one, i);
        const glm::dvec3 across = glm::cross(a.normal, along);
        const double length = glm::length(across);
        if (length == 0.0) return EdgeKind::Tangent;
        const double curvature = a.curvatureAlong(across / length);
        const double beyond = b.curvatureAlong(across / length);
        const double difference = std::abs(curvature - beyond);
        const double larger = std::max(std::abs(curvature), std::abs(beyond));
        return difference <= std::max(sameCurvature * larger, flat / size_) ? EdgeKind::Seam : EdgeKind::Tangent;
    }

    [[nodiscard]] bool isPlane(std::size_t face) { return adaptor(face).GetType() == GeomAbs_Plane; }

private:
    // 0 at a pole, where it is that of one triangle of many.
    [[nodiscard]] glm::dvec3 normal(const Run& run, std::size_t i) const {
        const MeshedFace& face = faces_[run.face];
        const bool isPole = !face.poles.empty() && face.poles[run.nodes[i]] != Pole::None;
        return isPole ? glm::dvec3{0.0} : face.normals[run.nodes[i]];
    }
    [[nodiscard]] glm::dvec3 position(const Run& run, std::size_t i) const {
        return faces_[run.face].positions[run.nodes[i]];
    }
    [[nodiscard]] static bool bends(glm::dvec3 a, glm::dvec3 b) {
        if (a == glm::dvec3{0.0} || b == glm::dvec3{0.0}) return false;  // a pole: the other end decides
        return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) > sameNormal;
    }

    const BRepAdaptor_Surface& adaptor(std::size_t face) {
        if (!adaptors_[face]) adaptors_[face] = std::make_unique<BRepAdaptor_Surface>(faces_[face].face, false);
        return *adaptors_[face];
    }

    [[nodiscard]] Local middle(const Run& run, std::size_t i, std::size_t j) {
        const MeshedFace& face = faces_[run.face];
        const glm::dvec2 uv = 0.5 * (face.parameters[run.nodes[i]] + face.parameters[run.nodes[j]]);
        gp_Pnt point;
        gp_Vec du;
        gp_Vec dv;
        gp_Vec duu;
        gp_Vec dvv;
        gp_Vec duv;
        adaptor(run.face).D2(uv.x, uv.y, point, du, dv, duu, dvv, duv);
        Local local{
            {}, vectorOf(du.XYZ()), vectorOf(dv.XYZ()), vectorOf(duu.XYZ()), vectorOf(duv.XYZ()), vectorOf(dvv.XYZ())};
        const glm::dvec3 across = glm::cross(local.du, local.dv);
        const double length = glm::length(across);
        if (length > 0.0) local.normal = across * ((face.turned ? -1.0 : 1.0) / length);
        return local;
    }

    const std::vector<MeshedFace>& faces_;
    std::vector<std::unique_ptr<BRepAdaptor_Surface>> adaptors_;
    double size_ = 1.0;
};

// Without nodes where OpenCASCADE has lost them, as on a seam whose sides lie two turns apart: they are 0 then, where
// they count from 1.
std::optional<Run> runOf(const TopoDS_Edge& edge, const TopoDS_Face& face, std::size_t index) {
    TopLoc_Location location;
    const Handle(Poly_Triangulation) triangles = BRep_Tool::Triangulation(face, location);
    const Handle(Poly_PolygonOnTriangulation) polygon = BRep_Tool::PolygonOnTriangulation(edge, triangles, location);
    if (polygon.IsNull() || polygon->NbNodes() < 2) return {};
    Run run{index, {}};
    for (const int node : polygon->Nodes()) {
        if (node < 1 || node > triangles->NbNodes()) return Run{index, {}};
        run.nodes.push_back(static_cast<std::uint32_t>(node - 1));
    }
    return run;
}

}  // namespace

EdgeTable::EdgeTable(const std::vector<MeshedFace>& faces) : faces_(faces.size()) {
    TopTools_IndexedMapOfShape edges;
    std::vector<std::vector<Run>> runs;
    Surfaces surfaces{faces};
    for (std::size_t i = 0; i < faces.size(); ++i) {
        if (!surfaces.isPlane(i)) faces_[i].within = EdgeKind::Seam;
        for (TopExp_Explorer explorer{faces[i].face, TopAbs_EDGE}; explorer.More(); explorer.Next()) {
            const TopoDS_Edge& edge = TopoDS::Edge(explorer.Current());
            if (BRep_Tool::Degenerated(edge)) continue;
            auto run = runOf(edge, faces[i].face, i);
            if (!run) continue;
            const auto number = static_cast<std::size_t>(edges.Add(edge)) - 1;  // it may be there already
            runs.resize(std::max(runs.size(), number + 1));
            runs[number].push_back(std::move(*run));
        }
    }
    for (const std::vector<Run>& shared : runs) {
        for (const Run& run : shared) {
            for (std::size_t i = 0; i + 1 < run.nodes.size(); ++i) {
                EdgeKind kind = shared.size() == 1 ? EdgeKind::Free : EdgeKind::Sharp;
                if (shared.size() == 2 && shared[0].nodes.size() == shared[1].nodes.size())
                    kind = surfaces.kindOf(shared[0], shared[1], i);
                faces_[run.face].kinds[keyOf(run.nodes[i], run.nodes[i + 1])] = kind;
            }
        }
    }
}

bool EdgeTable::isBorder(std::size_t face, std::uint32_t a, std::uint32_t b) const {
    return faces_[face].kinds.contains(keyOf(a, b));
}

std::uint8_t EdgeTable::kindOf(std::size_t face, std::uint32_t a, std::uint32_t b) const {
    const auto found = faces_[face].kinds.find(keyOf(a, b));
    return static_cast<std::uint8_t>(found == faces_[face].kinds.end() ? faces_[face].within : found->second);
}

}  // namespace inkedge::cad
