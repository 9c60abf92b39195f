#pragma once

#include <cstdint>
#include <vector>

#include <glm/mat4x3.hpp>
#include <glm/vec4.hpp>

namespace inkedge::cad {

enum class CurveKind : std::uint8_t { None, Line, Circle, Ellipse, Nurbs };

/// A curve c(t) by its numbers.
struct CurveData {
    CurveKind kind = CurveKind::None;
    /// Columns x, y, z and origin. Line: along x from the origin. Circle, ellipse: about z, from x towards y.
    glm::dmat4x3 frame{1.0};
    double major = 0.0;  ///< radius
    double minor = 0.0;
    std::uint32_t degree = 0;
    std::vector<double> knots;      ///< repeated; not periodic
    std::vector<glm::dvec4> poles;  ///< (w x, w y, w z, w)
    double period = 0.0;            ///< 0: none
};

enum class SurfaceKind : std::uint8_t { None, Plane, Cylinder, Cone, Sphere, Torus, Extrusion, Revolution, Nurbs };

/// A surface x(u, v) by its numbers, with the parameters of ISO 10303-42: what its kind says, then offset, then moved
/// to where the face is.
struct SurfaceData {
    SurfaceKind kind = SurfaceKind::None;
    glm::dmat4x3 frame{1.0};  ///< columns x, y, z and origin
    double major = 0.0;       ///< radius; of a cone at its origin
    double minor = 0.0;       ///< radius of a torus's tube; half the angle of a cone
    CurveData curve;          ///< of an extrusion along z, parameter u; of a revolution about z, parameter v
    std::uint32_t degreeU = 0;
    std::uint32_t degreeV = 0;
    std::vector<double> knotsU;  ///< as CurveData
    std::vector<double> knotsV;
    std::vector<glm::dvec4> poles;  ///< v runs first
    double periodU = 0.0;
    double periodV = 0.0;
    double offset = 0.0;         ///< along x_u x x_v
    glm::dmat4x3 location{1.0};  ///< columns x, y, z and origin: a movement, which may mirror and scale
};

template <class Archive>
void members(Archive& archive, CurveData& c) {
    archive(c.kind, c.frame, c.major, c.minor, c.degree, c.knots, c.poles, c.period);
}
template <class Archive>
void members(Archive& archive, SurfaceData& s) {
    archive(s.kind, s.frame, s.major, s.minor, s.curve, s.degreeU, s.degreeV, s.knotsU, s.knotsV, s.poles, s.periodU,
            s.periodV, s.offset, s.location);
}

}  // namespace inkedge::cad
