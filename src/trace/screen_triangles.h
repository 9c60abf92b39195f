#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/mat4x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <inkedge/camera.h>

#include "scene/scene_face.h"

namespace inkedge {

/// The scene's triangles as one camera projects them. Coordinates are pixels, (0, 0) the whole picture's top left
/// corner.
class ScreenTriangles {
public:
    /// @param firstTriangles  for each instance the number of its first triangle in the scene
    ScreenTriangles(const Scene&, const std::vector<std::uint32_t>& firstTriangles, const Camera&, Size);

    /// @param number  of a triangle of the scene, from 0
    [[nodiscard]] SceneFace locate(std::uint32_t number) const;

    /// What ends the surface that a walk across it meets.
    enum class End {
        Border,  ///< the mesh ends
        Crease,  ///< an edge that is a crease, or that more than two triangles share
        Fold,    ///< the mesh turns back under itself
    };
    struct Exit {
        End end;
        double t;  ///< where, 0 at the walk's start, 1 at its goal
    };
    struct Walk {
        std::optional<Exit> exit;                ///< where the smooth surface ends on the way
        std::optional<std::uint32_t> arrivedAt;  ///< else the triangle, of the same mesh, that covers the goal
    };
    /// Walks in the picture from a point on a triangle towards another, from triangle to triangle. Neither if the
    /// triangles on the way are too many to follow.
    [[nodiscard]] Walk walk(SceneFace from, glm::dvec2 start, glm::dvec2 goal) const;

    /// What linear function of the picture a triangle is: w and its slopes a pixel, as PlaneBuffers::planes, but in
    /// scene units and to double precision.
    struct Plane {
        double w;
        double dx;
        double dy;
    };
    [[nodiscard]] Plane plane(SceneFace, glm::dvec2 at) const;

    /// Whether two triangles of one mesh are the same or touch each other.
    [[nodiscard]] bool touch(SceneFace, SceneFace) const;

    /// Where, from 0 at start to 1 at goal, the border of a coplanar layer lies between them, whichever layer is seen
    /// there.
    /// @param patch  the layer's number (PatchNumbers::number)
    [[nodiscard]] std::optional<double> layerBorder(std::uint32_t patch, glm::dvec2 start, glm::dvec2 goal) const;

private:
    struct BorderEdge {
        glm::dvec3 from;  // homogeneous pixels
        glm::dvec3 to;
    };
    void collectLayerBorders();

    // Row k: the line through half-edge k as (a, b, c) with a x + b y + c > 0 on the triangle's side.
    struct EdgeLines {
        glm::dvec3 line[3];
    };
    [[nodiscard]] glm::dvec3 corner(std::uint32_t instance, std::uint32_t c) const;
    [[nodiscard]] EdgeLines edgeLines(SceneFace) const;

    const Scene& scene_;
    const std::vector<std::uint32_t>& firstTriangles_;
    std::vector<glm::dmat4x3> toPixels_;  // one an instance: mesh positions less their origin -> homogeneous pixels
    std::vector<glm::dvec4> toW_;         // and, orthographic, what gives w
    std::unordered_map<std::uint32_t, std::vector<BorderEdge>> layerBorders_;  // by patch number
};

}  // namespace inkedge
