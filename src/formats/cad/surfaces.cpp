#include "formats/cad/surfaces.h"

#include <cmath>

#include <glm/mat3x3.hpp>

#include "formats/cad/nurbs.h"

namespace inkedge::cad {
namespace {

CurvePoint curveAt(const CurveData& curve, double t) {
    const glm::dvec3 x = curve.frame[0];
    const glm::dvec3 origin = curve.frame[3];
    switch (curve.kind) {
        case CurveKind::Line:
            return {origin + t * x, x, glm::dvec3{0.0}};
        case CurveKind::Circle:
        case CurveKind::Ellipse: {
            const glm::dvec3 a = curve.major * x;
            const glm::dvec3 b = curve.minor * curve.frame[1];
            const double c = std::cos(t);
            const double s = std::sin(t);
            return {origin + c * a + s * b, c * b - s * a, -c * a - s * b};
        }
        case CurveKind::Nurbs:
            return nurbsAt(curve, t);
        case CurveKind::None:
            break;
    }
    return {};
}

// A profile (radius, height) turned about the z axis, in the frame's coordinates.
struct Profile {
    glm::dvec2 at;
    glm::dvec2 first;
    glm::dvec2 second;
};

SurfacePoint turned(const Profile& profile, double u) {
    const double c = std::cos(u);
    const double s = std::sin(u);
    const auto out = [&](glm::dvec2 p) { return glm::dvec3{c * p.x, s * p.x, p.y}; };
    const auto along = [&](glm::dvec2 p) { return glm::dvec3{-s * p.x, c * p.x, 0.0}; };
    return {.position = out(profile.at),
            .du = along(profile.at),
            .dv = out(profile.first),
            .duu = glm::dvec3{-c * profile.at.x, -s * profile.at.x, 0.0},
            .duv = along(profile.first),
            .dvv = out(profile.second)};
}

Profile profileOf(const SurfaceData& surface, double v) {
    const double c = std::cos(v);
    const double s = std::sin(v);
    switch (surface.kind) {
        case SurfaceKind::Cone: {
            const double sine = std::sin(surface.minor);
            const double cosine = std::cos(surface.minor);
            return {{surface.major + v * sine, v * cosine}, {sine, cosine}, glm::dvec2{0.0}};
        }
        case SurfaceKind::Sphere: {
            const double r = surface.major;
            return {{r * c, r * s}, {-r * s, r * c}, {-r * c, -r * s}};
        }
        case SurfaceKind::Torus: {
            const double r = surface.minor;
            return {{surface.major + r * c, r * s}, {-r * s, r * c}, {-r * c, -r * s}};
        }
        default:
            return {{surface.major, v}, {0.0, 1.0}, glm::dvec2{0.0}};
    }
}

// A curve anywhere, turned about the frame's z axis.
SurfacePoint revolved(const SurfaceData& surface, glm::dvec2 uv) {
    const glm::dmat3 axes{surface.frame[0], surface.frame[1], surface.frame[2]};
    const CurvePoint curve = curveAt(surface.curve, uv.y);
    const double c = std::cos(uv.x);
    const double s = std::sin(uv.x);
    const auto turn = [&](glm::dvec3 p) { return glm::dvec3{c * p.x - s * p.y, s * p.x + c * p.y, p.z}; };
    const auto along = [&](glm::dvec3 p) { return glm::dvec3{-s * p.x - c * p.y, c * p.x - s * p.y, 0.0}; };
    const glm::dvec3 origin = surface.frame[3];
    const glm::dvec3 p = (curve[0] - origin) * axes;  // in the frame
    const glm::dvec3 d = curve[1] * axes;
    const glm::dvec3 dd = curve[2] * axes;
    const glm::dvec3 at = turn(p);
    return {.position = origin + axes * at,
            .du = axes * along(p),
            .dv = axes * turn(d),
            .duu = axes * glm::dvec3{-at.x, -at.y, 0.0},
            .duv = axes * along(d),
            .dvv = axes * turn(dd)};
}

SurfacePoint extruded(const SurfaceData& surface, glm::dvec2 uv) {
    const CurvePoint curve = curveAt(surface.curve, uv.x);
    SurfacePoint point;
    point.position = curve[0] + uv.y * surface.frame[2];
    point.du = curve[1];
    point.dv = surface.frame[2];
    point.duu = curve[2];
    return point;
}

}  // namespace

SurfacePoint CadSurfaces::at(std::uint32_t face, glm::dvec2 parameters) const {
    const SurfaceData& surface = surfaces_[face];
    if (surface.kind == SurfaceKind::Nurbs) return nurbsAt(surface, parameters);
    if (surface.kind == SurfaceKind::Revolution) return revolved(surface, parameters);
    if (surface.kind == SurfaceKind::Extrusion) return extruded(surface, parameters);
    SurfacePoint point;
    if (surface.kind == SurfaceKind::Plane) {
        point.position = {parameters, 0.0};
        point.du = {1.0, 0.0, 0.0};
        point.dv = {0.0, 1.0, 0.0};
    } else {
        point = turned(profileOf(surface, parameters.y), parameters.x);
    }
    const glm::dmat3 axes{surface.frame[0], surface.frame[1], surface.frame[2]};
    for (glm::dvec3* const vector : {&point.du, &point.dv, &point.duu, &point.duv, &point.dvv})
        *vector = axes * *vector;
    point.position = surface.frame[3] + axes * point.position;
    return point;
}

}  // namespace inkedge::cad
