#include "formats/cad/occt_surfaces.h"

#include <BRep_Tool.hxx>
#include <GeomAdaptor_Curve.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_Circle.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_Curve.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_Line.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_Surface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TopLoc_Location.hxx>
#include <gp_Ax3.hxx>
#include <gp_Pnt.hxx>

#include "formats/cad/occt_vectors.h"

namespace inkedge::cad {
namespace {

// Left-handed ones, as ISO 10303 has none of, too.
glm::dmat4x3 frameOf(const gp_Ax3& axes) {
    return {vectorOf(axes.XDirection().XYZ()), vectorOf(axes.YDirection().XYZ()), vectorOf(axes.Direction().XYZ()),
            vectorOf(axes.Location().XYZ())};
}
glm::dmat4x3 frameOf(const gp_Ax2& axes) { return frameOf(gp_Ax3{axes}); }

std::vector<double> listOf(const TColStd_Array1OfReal& values) { return {values.begin(), values.end()}; }

glm::dvec4 poleOf(const gp_Pnt& point, double weight) { return {weight * vectorOf(point.XYZ()), weight}; }

CurveData dataOf(const Handle(Geom_BSplineCurve) & source) {
    CurveData data;
    data.kind = CurveKind::Nurbs;
    Handle(Geom_BSplineCurve) curve = Handle(Geom_BSplineCurve)::DownCast(source->Copy());
    if (curve->IsPeriodic()) {
        data.period = curve->Period();
        curve->SetNotPeriodic();
    }
    data.degree = static_cast<std::uint32_t>(curve->Degree());
    data.knots = listOf(curve->KnotSequence());
    for (int i = 1; i <= curve->NbPoles(); ++i) data.poles.push_back(poleOf(curve->Pole(i), curve->Weight(i)));
    return data;
}

CurveData dataOf(const Handle(Geom_Curve) & curve) {
    CurveData data;
    if (const auto trimmed = Handle(Geom_TrimmedCurve)::DownCast(curve); !trimmed.IsNull())
        return dataOf(trimmed->BasisCurve());
    if (const auto line = Handle(Geom_Line)::DownCast(curve); !line.IsNull()) {
        data.kind = CurveKind::Line;
        data.frame[0] = vectorOf(line->Lin().Direction().XYZ());
        data.frame[3] = vectorOf(line->Lin().Location().XYZ());
    } else if (const auto circle = Handle(Geom_Circle)::DownCast(curve); !circle.IsNull()) {
        data.kind = CurveKind::Circle;
        data.frame = frameOf(circle->Position());
        data.major = data.minor = circle->Radius();
    } else if (const auto ellipse = Handle(Geom_Ellipse)::DownCast(curve); !ellipse.IsNull()) {
        data.kind = CurveKind::Ellipse;
        data.frame = frameOf(ellipse->Position());
        data.major = ellipse->MajorRadius();
        data.minor = ellipse->MinorRadius();
    } else if (const auto spline = Handle(Geom_BSplineCurve)::DownCast(curve); !spline.IsNull()) {
        return dataOf(spline);
    } else if (const auto bezier = Handle(Geom_BezierCurve)::DownCast(curve); !bezier.IsNull()) {
        return dataOf(GeomConvert::CurveToBSplineCurve(bezier));
    }
    return data;
}

SurfaceData dataOf(const Handle(Geom_BSplineSurface) & source) {
    SurfaceData data;
    data.kind = SurfaceKind::Nurbs;
    Handle(Geom_BSplineSurface) surface = Handle(Geom_BSplineSurface)::DownCast(source->Copy());
    if (surface->IsUPeriodic()) {
        data.periodU = surface->UPeriod();
        surface->SetUNotPeriodic();
    }
    if (surface->IsVPeriodic()) {
        data.periodV = surface->VPeriod();
        surface->SetVNotPeriodic();
    }
    data.degreeU = static_cast<std::uint32_t>(surface->UDegree());
    data.degreeV = static_cast<std::uint32_t>(surface->VDegree());
    data.knotsU = listOf(surface->UKnotSequence());
    data.knotsV = listOf(surface->VKnotSequence());
    for (int i = 1; i <= surface->NbUPoles(); ++i)
        for (int j = 1; j <= surface->NbVPoles(); ++j)
            data.poles.push_back(poleOf(surface->Pole(i, j), surface->Weight(i, j)));
    return data;
}

SurfaceData elementary(const Handle(Geom_ElementarySurface) & surface) {
    SurfaceData data;
    data.frame = frameOf(surface->Position());
    if (const auto cylinder = Handle(Geom_CylindricalSurface)::DownCast(surface); !cylinder.IsNull()) {
        data.kind = SurfaceKind::Cylinder;
        data.major = cylinder->Radius();
    } else if (const auto cone = Handle(Geom_ConicalSurface)::DownCast(surface); !cone.IsNull()) {
        data.kind = SurfaceKind::Cone;
        data.major = cone->RefRadius();
        data.minor = cone->SemiAngle();
    } else if (const auto sphere = Handle(Geom_SphericalSurface)::DownCast(surface); !sphere.IsNull()) {
        data.kind = SurfaceKind::Sphere;
        data.major = sphere->Radius();
    } else if (const auto torus = Handle(Geom_ToroidalSurface)::DownCast(surface); !torus.IsNull()) {
        data.kind = SurfaceKind::Torus;
        data.major = torus->MajorRadius();
        data.minor = torus->MinorRadius();
    } else if (surface->IsKind(STANDARD_TYPE(Geom_Plane))) {
        data.kind = SurfaceKind::Plane;
    }
    return data;
}

SurfaceData swept(const Handle(Geom_SweptSurface) & surface) {
    SurfaceData data;
    data.curve = dataOf(surface->BasisCurve());
    if (data.curve.kind == CurveKind::None) return data;
    if (const auto revolution = Handle(Geom_SurfaceOfRevolution)::DownCast(surface); !revolution.IsNull()) {
        data.kind = SurfaceKind::Revolution;
        const gp_Ax2 axes{revolution->Location(), revolution->Axis().Direction()};
        data.frame = frameOf(axes);
    } else {
        data.kind = SurfaceKind::Extrusion;
        data.frame[2] = vectorOf(surface->Direction().XYZ());
    }
    return data;
}

Handle(Geom_Surface) untrimmed(Handle(Geom_Surface) surface) {
    while (surface->IsKind(STANDARD_TYPE(Geom_RectangularTrimmedSurface)))
        surface = Handle(Geom_RectangularTrimmedSurface)::DownCast(surface)->BasisSurface();
    return surface;
}

SurfaceData ofKind(const Handle(Geom_Surface) & surface) {
    if (const auto found = Handle(Geom_ElementarySurface)::DownCast(surface); !found.IsNull()) return elementary(found);
    if (const auto found = Handle(Geom_BSplineSurface)::DownCast(surface); !found.IsNull()) return dataOf(found);
    if (const auto found = Handle(Geom_BezierSurface)::DownCast(surface); !found.IsNull())
        return dataOf(GeomConvert::SurfaceToBSplineSurface(found));
    if (const auto found = Handle(Geom_SweptSurface)::DownCast(surface); !found.IsNull()) return swept(found);
    return {};
}

}  // namespace

SurfaceData surfaceOf(const TopoDS_Face& face) {
    TopLoc_Location location;
    Handle(Geom_Surface) surface = BRep_Tool::Surface(face, location);
    if (surface.IsNull()) return {};
    surface = untrimmed(surface);
    double offset = 0.0;
    if (const auto found = Handle(Geom_OffsetSurface)::DownCast(surface); !found.IsNull()) {
        offset = found->Offset();
        surface = untrimmed(found->BasisSurface());
    }
    SurfaceData data = ofKind(surface);
    data.offset = offset;
    data.location = glm::dmat4x3{matrixOf(location.Transformation())};
    return data;
}

}  // namespace inkedge::cad
