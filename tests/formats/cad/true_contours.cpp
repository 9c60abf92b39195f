#include "formats/cad/true_contours.h"

#include <BRepBndLib.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Geom_Surface.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Reader.hxx>
#include <ShapeAnalysis_Surface.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Pnt.hxx>
#include <gp_Pnt2d.hxx>
#include <gp_Vec.hxx>

#include <algorithm>
#include <cmath>
#include <vector>

namespace inkedge::cad_files {

struct TrueContours::Faces {
    struct Entry {
        Bnd_Box box;
        Handle(Geom_Surface) surface;
        Handle(ShapeAnalysis_Surface) search;
    };
    std::vector<Entry> all;
};

TrueContours::TrueContours(const std::filesystem::path& step) {
    Message::DefaultMessenger()->ChangePrinters().Clear();
    STEPControl_Reader reader;
    reader.ReadFile(step.c_str());
    reader.TransferRoots();
    auto faces = std::make_unique<Faces>();
    for (TopExp_Explorer face{reader.OneShape(), TopAbs_FACE}; face.More(); face.Next()) {
        Faces::Entry& entry = faces->all.emplace_back();
        BRepBndLib::Add(face.Current(), entry.box, false);
        entry.surface = BRep_Tool::Surface(TopoDS::Face(face.Current()));
        entry.search = new ShapeAnalysis_Surface{entry.surface};
    }
    faces_ = std::move(faces);
}

TrueContours::~TrueContours() = default;

double TrueContours::offsetOf(glm::dvec3 point, const Eye& eye, double reach) const {
    constexpr int maxSteps = 20;
    const gp_Pnt p{point.x, point.y, point.z};
    const gp_Pnt position{eye.position.x, eye.position.y, eye.position.z};
    const gp_Vec direction{eye.direction.x, eye.direction.y, eye.direction.z};
    double nearest = none;
    for (const Faces::Entry& face : faces_->all) {
        Bnd_Box box = face.box;
        box.Enlarge(reach);
        if (box.IsOut(p)) continue;
        gp_Pnt2d uv = face.search->ValueOfUV(p, 1e-7);
        for (int i = 0; i < maxSteps; ++i) {
            gp_Pnt at;
            gp_Vec du, dv, duu, dvv, duv;
            face.surface->D2(uv.X(), uv.Y(), at, du, dv, duu, dvv, duv);
            if (at.Distance(p) > reach) break;
            const gp_Vec seen = eye.orthographic ? direction : gp_Vec{position, at};
            const gp_Vec normal = du.Crossed(dv);
            const double f = normal.Dot(seen);
            const double byU = (duu.Crossed(dv) + du.Crossed(duv)).Dot(seen);
            const double byV = (duv.Crossed(dv) + du.Crossed(dvv)).Dot(seen);
            // The step that is the shortest on a surface whose parameters are at right angles, as most are.
            const double e = du.SquareMagnitude();
            const double g = dv.SquareMagnitude();
            const double slope = byU * byU / e + byV * byV / g;
            if (!(slope > 0.0)) break;
            const double stepU = -f * byU / e / slope;
            const double stepV = -f * byV / g / slope;
            if (std::hypot(stepU * std::sqrt(e), stepV * std::sqrt(g)) < 1e-6 * reach) {
                nearest = std::min(nearest, std::abs(gp_Vec{at, p}.Dot(normal)) / normal.Magnitude());
                break;
            }
            uv.SetCoord(uv.X() + stepU, uv.Y() + stepV);
        }
    }
    return nearest;
}

}  // namespace inkedge::cad_files
