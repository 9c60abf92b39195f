#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <inkedge/mesh.h>

#include "lines/find/contour_finders.h"
#include "lines/find/instance_view.h"
#include "lines/screen.h"

namespace inkedge::lines {

/// Smooth contours of meshes whose faces have surfaces, or that are where a field is 0: n . (x - C) = 0 on the surfaces
/// themselves, not on the triangles that stand for them.
class SurfaceContours {
public:
    /// @param mesh  with surfaces or a field; all three must outlive this
    SurfaceContours(const Mesh& mesh, const InstanceView& view, const Screen& screen)
        : mesh_{mesh}, view_{view}, screen_{screen} {}

    /// A point of a contour.
    struct Point {
        glm::dvec3 position;    ///< mesh space, less origin
        glm::dvec2 parameters;  ///< on the surface of its face
        bool exact = false;     ///< false: it lies on the triangle, for the surface is not known or has no normal there
    };

    /// Where the contour crosses an edge of a triangle.
    /// @param ends    vertices, at which n . (x - C) has different signs
    /// @param linear  where the triangle's normals have it
    [[nodiscard]] Point crossing(std::uint32_t triangle, std::array<std::uint32_t, 2> ends, glm::dvec3 linear) const;

    /// The contour from one crossing of a triangle to the other, so that straight pieces stray from it by at most
    /// maxStray pixels.
    /// @return  both ends and points between them; mesh space, less origin
    [[nodiscard]] std::vector<glm::dvec3> between(std::uint32_t triangle, const Point& from, const Point& to) const;

    static constexpr double maxStray = 0.02;  ///< pixels

private:
    [[nodiscard]] double viewDot(std::uint32_t face, glm::dvec2 parameters, glm::dvec3& position) const;
    [[nodiscard]] Point moved(std::uint32_t face, glm::dvec2 parameters, double reach) const;
    [[nodiscard]] Point movedInField(glm::dvec3 start, double reach) const;
    void divide(std::uint32_t face, const Point& from, const Point& to, int depth,
                std::vector<glm::dvec3>& points) const;

    const Mesh& mesh_;
    const InstanceView& view_;
    const Screen& screen_;
};

}  // namespace inkedge::lines
