#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include <inkedge/face_surfaces.h>

#include "lines/find/instance_view.h"
#include "lines/screen.h"

namespace inkedge::lines {

/// Smooth contours of meshes whose triangles stand for smooth surfaces: n . (x - C) = 0 on the surfaces themselves.
/// Positions are of mesh space, less Mesh::origin.
class SurfaceContours {
public:
    /// @param origin  Mesh::origin; the other three must outlive this
    SurfaceContours(const FaceSurfaces& surfaces, glm::dvec3 origin, const InstanceView& view, const Screen& screen)
        : surfaces_{surfaces}, origin_{origin}, view_{view}, screen_{screen} {}

    /// A point of a contour.
    struct Point {
        glm::dvec3 position;
        glm::dvec3 parameters;
        bool exact = false;  ///< false: it lies on the triangle, for the surface is somewhere else or has no normal
    };

    /// Where the contour crosses the edge from a corner of a triangle to the next, at whose ends n . (x - C) has
    /// different signs.
    /// @param corners  of the triangle
    /// @param linear   where the triangle's normals have it
    [[nodiscard]] Point crossing(const SurfaceTriangle&, std::uint32_t corner, const std::array<glm::dvec3, 3>& corners,
                                 glm::dvec3 linear) const;

    /// The contour from one crossing of a triangle to the other, so that straight pieces stray from it by at most
    /// maxStray pixels.
    /// @param face  of the triangle's surface
    /// @return      both ends and points between them
    [[nodiscard]] std::vector<glm::dvec3> between(std::uint32_t face, const Point& from, const Point& to) const;

    static constexpr double maxStray = 0.02;  ///< pixels

private:
    struct Edge;
    struct Sample;
    [[nodiscard]] Sample sample(const Edge&, double share) const;
    void narrow(const Edge&, Sample low, Sample high, Point& point) const;
    [[nodiscard]] Point moved(std::uint32_t face, glm::dvec3 parameters, double reach) const;
    [[nodiscard]] bool areTogether(glm::dvec3 a, glm::dvec3 b) const;
    [[nodiscard]] double stray(const Point& from, const Point& to, const Point& middle) const;
    void divide(std::uint32_t face, const Point& from, const Point& to, int depth,
                std::vector<glm::dvec3>& points) const;

    const FaceSurfaces& surfaces_;
    glm::dvec3 origin_;
    const InstanceView& view_;
    const Screen& screen_;
};

}  // namespace inkedge::lines
