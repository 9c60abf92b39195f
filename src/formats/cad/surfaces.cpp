#include "formats/cad/surfaces.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include <inkedge/mesh.h>

#include "formats/cad/nurbs.h"
#include "mesh/surface_point.h"

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

mesh::SurfaceDerivatives turned(const Profile& profile, double u) {
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
mesh::SurfaceDerivatives revolved(const SurfaceData& surface, glm::dvec2 uv) {
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

mesh::SurfaceDerivatives extruded(const SurfaceData& surface, glm::dvec2 uv) {
    const CurvePoint curve = curveAt(surface.curve, uv.x);
    mesh::SurfaceDerivatives point;
    point.position = curve[0] + uv.y * surface.frame[2];
    point.du = curve[1];
    point.dv = surface.frame[2];
    point.duu = curve[2];
    return point;
}

// As its kind says.
mesh::SurfaceDerivatives derivativesAt(const SurfaceData& surface, glm::dvec2 uv) {
    if (surface.kind == SurfaceKind::Nurbs) return nurbsAt(surface, uv);
    if (surface.kind == SurfaceKind::Revolution) return revolved(surface, uv);
    if (surface.kind == SurfaceKind::Extrusion) return extruded(surface, uv);
    mesh::SurfaceDerivatives point;
    if (surface.kind == SurfaceKind::Plane) {
        point.position = {uv, 0.0};
        point.du = {1.0, 0.0, 0.0};
        point.dv = {0.0, 1.0, 0.0};
    } else {
        point = turned(profileOf(surface, uv.y), uv.x);
    }
    const glm::dmat3 axes{surface.frame[0], surface.frame[1], surface.frame[2]};
    for (glm::dvec3* const vector : {&point.du, &point.dv, &point.duu, &point.duv, &point.dvv})
        *vector = axes * *vector;
    point.position = surface.frame[3] + axes * point.position;
    return point;
}

// x + d n has the normal n: (x + d n)_u = x_u + d n_u, where the unit n changes as the normal does, across itself.
void moveAlongNormal(SurfacePoint& point, double distance) {
    const double length = glm::length(point.normal);
    if (distance == 0.0 || !(length > 0.0)) return;
    const glm::dvec3 n = point.normal / length;
    const auto across = [&](glm::dvec3 change) { return (change - glm::dot(change, n) * n) / length; };
    point.position += distance * n;
    point.du += distance * across(point.normalDu);
    point.dv += distance * across(point.normalDv);
}

}  // namespace

std::optional<SurfaceTriangle> CadSurfaces::under(const Mesh& mesh, std::uint32_t triangle) const {
    if (mesh.faces.empty() || mesh.parameters.empty()) return {};
    SurfaceTriangle part{mesh.faces[triangle]};
    if (part.face >= surfaces_.size() || surfaces_[part.face].kind == SurfaceKind::None) return {};
    for (std::size_t k = 0; k < 3; ++k)
        part.corners[k] = {mesh.parameters[mesh.indices[3 * std::size_t{triangle} + k]], 0.0};
    return part;
}

SurfacePoint CadSurfaces::at(std::uint32_t face, glm::dvec3 parameters) const {
    const SurfaceData& surface = surfaces_[face];
    SurfacePoint point = mesh::surfacePoint(derivativesAt(surface, glm::dvec2{parameters}));
    moveAlongNormal(point, surface.offset);
    const glm::dmat3 axes{surface.location[0], surface.location[1], surface.location[2]};
    for (glm::dvec3* const vector : {&point.du, &point.dv, &point.normal, &point.normalDu, &point.normalDv})
        *vector = axes * *vector;  // it keeps angles
    point.position = surface.location[3] + axes * point.position;
    return point;
}

}  // namespace inkedge::cad
