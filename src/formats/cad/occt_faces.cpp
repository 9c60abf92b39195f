#include "formats/cad/occt_faces.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRep_Tool.hxx>
#include <Geom_Surface.hxx>
#include <Poly_Triangulation.hxx>
#include <TopLoc_Location.hxx>
#include <gp_Pnt.hxx>
#include <gp_Vec.hxx>

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

#include <glm/geometric.hpp>

#include "formats/cad/occt_vectors.h"

namespace inkedge::cad {
namespace {

// A surface at a point of it.
struct AtPoint {
    glm::dvec3 normal{0.0};  // the surface's own; 0 where it has none
    Pole pole = Pole::None;
};

AtPoint at(const Geom_Surface& surface, glm::dvec2 uv) {
    constexpr double parallel = 1e-9;   // sine
    constexpr double vanishing = 1e-9;  // of the other derivative
    gp_Pnt point;
    gp_Vec du;
    gp_Vec dv;
    surface.D1(uv.x, uv.y, point, du, dv);
    const double u = du.Magnitude();
    const double v = dv.Magnitude();
    AtPoint found;
    found.pole = u <= vanishing * v ? Pole::OfU : v <= vanishing * u ? Pole::OfV : Pole::None;
    const gp_Vec across = du.Crossed(dv);
    const double length = across.Magnitude();
    if (length > parallel * u * v && length > 0.0) found.normal = vectorOf(across.XYZ()) / length;
    return found;
}

// Each node's neighbour in the face: the middle of a triangle that it is a corner of.
std::vector<glm::dvec2> middlesBeside(const MeshedFace& mesh) {
    std::vector<glm::dvec2> middles = mesh.parameters;
    for (const auto& t : mesh.triangles) {
        const glm::dvec2 middle = (mesh.parameters[t[0]] + mesh.parameters[t[1]] + mesh.parameters[t[2]]) / 3.0;
        for (const std::uint32_t corner : t) middles[corner] = middle;
    }
    return middles;
}

void addNormals(const Geom_Surface& surface, MeshedFace& mesh) {
    constexpr double beside = 1e-4;  // of the way to the middle of a triangle
    const std::vector<glm::dvec2> middles = middlesBeside(mesh);
    mesh.normals.reserve(mesh.positions.size());
    mesh.poles.reserve(mesh.positions.size());
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const glm::dvec2 uv = mesh.parameters[i];
        AtPoint found = at(surface, uv);
        mesh.poles.push_back(found.pole);
        if (found.normal == glm::dvec3{0.0}) found = at(surface, uv + beside * (middles[i] - uv));
        mesh.normals.push_back(found.normal);
    }
}

// Of faces that have triangles alone.
void addNormals(const Poly_Triangulation& triangles, MeshedFace& mesh) {
    mesh.normals.assign(mesh.positions.size(), glm::dvec3{0.0});
    if (!triangles.HasNormals()) return;
    for (std::size_t i = 0; i < mesh.normals.size(); ++i)
        mesh.normals[i] = vectorOf(triangles.Normal(static_cast<int>(i) + 1).XYZ());
}

void movePositions(const gp_Trsf& trsf, MeshedFace& mesh) {
    if (trsf.Form() == gp_Identity) return;
    for (glm::dvec3& p : mesh.positions) p = vectorOf(gp_Pnt{p.x, p.y, p.z}.Transformed(trsf).XYZ());
}

void turnNormals(const gp_Trsf& trsf, MeshedFace& mesh) {
    if (trsf.Form() == gp_Identity) return;
    for (glm::dvec3& n : mesh.normals) {
        if (n == glm::dvec3{0.0}) continue;
        const glm::dvec3 moved = vectorOf(gp_Vec{n.x, n.y, n.z}.Transformed(trsf).XYZ());
        n = moved / glm::length(moved);
    }
}

}  // namespace

std::optional<MeshedFace> MeshedFace::of(const TopoDS_Face& face) {
    TopLoc_Location location;
    const Handle(Poly_Triangulation) source = BRep_Tool::Triangulation(face, location);
    if (source.IsNull() || source->NbTriangles() == 0) return {};
    MeshedFace mesh;
    mesh.face = face;
    for (int i = 1; i <= source->NbNodes(); ++i) {
        mesh.positions.push_back(vectorOf(source->Node(i).XYZ()));
        const gp_Pnt2d uv = source->HasUVNodes() ? source->UVNode(i) : gp_Pnt2d{};
        mesh.parameters.emplace_back(uv.X(), uv.Y());
    }
    for (int i = 1; i <= source->NbTriangles(); ++i) {
        std::array<int, 3> t{};
        source->Triangle(i).Get(t[0], t[1], t[2]);
        mesh.triangles.push_back({static_cast<std::uint32_t>(t[0] - 1), static_cast<std::uint32_t>(t[1] - 1),
                                  static_cast<std::uint32_t>(t[2] - 1)});
    }
    TopLoc_Location ofSurface;
    const Handle(Geom_Surface)& surface = BRep_Tool::Surface(face, ofSurface);
    const bool isKnown = !surface.IsNull() && source->HasUVNodes();
    if (isKnown)
        addNormals(*surface, mesh);
    else
        addNormals(*source, mesh);
    const gp_Trsf& trsf = (isKnown ? ofSurface : location).Transformation();
    movePositions(location.Transformation(), mesh);
    turnNormals(trsf, mesh);
    // Triangles are wound by the surface's own normal. Where a mirrored location turns that normal over against the
    // mirrored triangles, the mirrored normals point out still.
    const bool reversed = face.Orientation() == TopAbs_REVERSED;
    mesh.turned = reversed != trsf.IsNegative();
    if (reversed)
        for (glm::dvec3& n : mesh.normals) n = -n;
    if (mesh.turned)
        for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
    return mesh;
}

namespace {

// Divides the triangles of a face at middles of edges.
class Refinement {
public:
    Refinement(MeshedFace& mesh, double deflection, const std::function<bool(std::uint32_t, std::uint32_t)>& isBorder)
        : mesh_{mesh}, surface_{mesh.face, false}, deflection_{deflection}, isBorder_{isBorder} {}

    // Whether any triangle was divided.
    bool pass() {
        std::vector<std::array<std::uint32_t, 3>> divided;
        bool any = false;
        for (const auto& t : mesh_.triangles) {
            std::array<std::uint32_t, 3> middles{};
            for (std::size_t k = 0; k < 3; ++k) middles[k] = middleOf(t[k], t[(k + 1) % 3]);
            any = divide(t, middles, divided) || any;
        }
        mesh_.triangles = std::move(divided);
        return any;
    }

    [[nodiscard]] bool isFlat() const { return surface_.GetType() == GeomAbs_Plane; }

private:
    static constexpr std::uint32_t none = ~0U;

    // Of a node, towards another: from a pole all directions have one parameter, that of the other node.
    [[nodiscard]] glm::dvec2 parametersOf(std::uint32_t node, std::uint32_t other) const {
        glm::dvec2 own = mesh_.parameters[node];
        if (mesh_.poles[node] == Pole::OfU) own.x = mesh_.parameters[other].x;
        if (mesh_.poles[node] == Pole::OfV) own.y = mesh_.parameters[other].y;
        return own;
    }

    // The node in the middle of an edge; none: the edge is not divided.
    std::uint32_t middleOf(std::uint32_t a, std::uint32_t b) {
        const auto [lesser, greater] = std::minmax(a, b);
        const auto [entry, isNew] = middles_.try_emplace(std::uint64_t{lesser} << 32U | greater, none);
        if (!isNew) return entry->second;
        if (isBorder_(a, b)) return none;
        const glm::dvec2 uv = 0.5 * (parametersOf(a, b) + parametersOf(b, a));
        gp_Pnt point;
        gp_Vec du;
        gp_Vec dv;
        surface_.D1(uv.x, uv.y, point, du, dv);
        const glm::dvec3 across = vectorOf(du.Crossed(dv).XYZ());
        const double length = glm::length(across);
        if (!(length > 0.0)) return none;
        const glm::dvec3 normal = across * ((mesh_.turned ? -1.0 : 1.0) / length);
        const glm::dvec3 position = vectorOf(point.XYZ());
        const double stray = glm::dot(position - 0.5 * (mesh_.positions[a] + mesh_.positions[b]), normal);
        if (!(std::abs(stray) > ofMiddles * deflection_) || std::abs(stray) > believed * deflection_) return none;
        entry->second = static_cast<std::uint32_t>(mesh_.positions.size());
        mesh_.positions.push_back(position);
        mesh_.normals.push_back(normal);
        mesh_.parameters.push_back(uv);
        mesh_.poles.push_back(Pole::None);
        return entry->second;
    }

    // @param middles  of the edges from each corner to the next
    static bool divide(const std::array<std::uint32_t, 3>& t, const std::array<std::uint32_t, 3>& middles,
                       std::vector<std::array<std::uint32_t, 3>>& to) {
        std::vector<std::uint32_t> ring;  // corners and middles, from a corner before a middle on
        std::size_t start = 0;
        while (start < 3 && middles[start] == none) ++start;
        if (start == 3) {
            to.push_back(t);
            return false;
        }
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t k = (start + i) % 3;
            ring.push_back(t[k]);
            if (middles[k] != none) ring.push_back(middles[k]);
        }
        if (ring.size() == 6) {
            to.push_back({ring[0], ring[1], ring[5]});
            to.push_back({ring[1], ring[2], ring[3]});
            to.push_back({ring[3], ring[4], ring[5]});
            to.push_back({ring[1], ring[3], ring[5]});
        } else {  // a fan about the first middle
            for (std::size_t i = 2; i + 1 < ring.size(); ++i) to.push_back({ring[1], ring[i], ring[i + 1]});
            to.push_back({ring[1], ring.back(), ring[0]});
        }
        return true;
    }

    static constexpr double ofMiddles = 0.8;  // of the deflection: triangles stray by a third more than their edges
    static constexpr double believed = 16.0;  // deflections: what is more has wrong parameters

    MeshedFace& mesh_;
    BRepAdaptor_Surface surface_;
    double deflection_;
    const std::function<bool(std::uint32_t, std::uint32_t)>& isBorder_;
    std::unordered_map<std::uint64_t, std::uint32_t> middles_;
};

}  // namespace

void MeshedFace::refine(double deflection, const std::function<bool(std::uint32_t, std::uint32_t)>& isBorder) {
    constexpr int maxPasses = 4;
    TopLoc_Location ignored;
    if (BRep_Tool::Surface(face, ignored).IsNull() || poles.empty()) return;
    Refinement refinement{*this, deflection, isBorder};
    for (int i = 0; i < maxPasses && !refinement.isFlat() && refinement.pass(); ++i) {
    }
}

}  // namespace inkedge::cad
