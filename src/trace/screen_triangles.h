#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/mat4x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <inkedge/camera.h>
#include <inkedge/scene.h>

#include "scene/border_edge.h"
#include "scene/scene_face.h"

namespace inkedge::trace {

/// The triangles of a scene as one camera projects them. Coordinates are pixels, (0, 0) the whole picture's top left
/// corner.
class ScreenTriangles {
public:
    /// @param firstTriangles  for each instance the number of its first triangle in the scene
    ScreenTriangles(const Scene&, const std::vector<std::uint32_t>& firstTriangles, const Camera&, Size);

    /// Of the scene, degrees.
    [[nodiscard]] double creaseAngle() const noexcept { return scene_.creaseAngle(); }

    /// Scene units between two borders that run along each other.
    [[nodiscard]] double seamWidth() const { return scene::seamTolerance * scene_.bounds().radius; }

    /// @param number  of a triangle of the scene, from 0
    [[nodiscard]] scene::SceneFace locate(std::uint32_t number) const;

    /// A position of an instance's mesh as homogeneous pixels: (x w, y w, w).
    [[nodiscard]] glm::dvec3 projected(std::uint32_t instance, std::uint32_t position) const {
        return projected_.empty() ? project(instance, position) : projected_[firstProjected_[instance] + position];
    }

    /// What ends a surface on a walk across it.
    enum class End {
        Border,  ///< the mesh ends
        Crease,  ///< an edge that is a crease, unless it is walked over, or that more than two triangles share
        Fold,    ///< the mesh turns back under itself
    };
    struct Exit {
        End end;
        double t;  ///< share of the way from the walk's start to its goal
        std::uint32_t halfEdge;
    };
    struct Walk {
        std::optional<Exit> exit;                ///< where the surface ends on the way; none: it does not
        std::optional<std::uint32_t> arrivedAt;  ///< without an exit: the triangle of the mesh that covers the goal
        std::uint32_t last = 0;                  ///< the triangle that the walk ends on
    };
    /// What a walk stays on: a patch, or the whole surface, which goes on across creases.
    enum class Over { Patch, Surface };
    /// Walks in the picture from a point on a triangle towards another point, from triangle to triangle. There is
    /// neither an exit nor an arrival if the triangles on the way are too many to follow.
    [[nodiscard]] Walk walk(scene::SceneFace from, glm::dvec2 start, glm::dvec2 goal, Over over = Over::Patch) const;

    struct BothWalks {
        Walk patch;
        Walk surface;
    };
    /// Two walks for the price of the longer one.
    [[nodiscard]] BothWalks walkBoth(scene::SceneFace from, glm::dvec2 start, glm::dvec2 goal) const;

    /// A triangle as a linear function of the picture: w and its slopes per pixel, as PlaneBuffers::planes, but in
    /// scene units and double precision.
    struct Plane {
        double w;
        double dx;
        double dy;
    };
    [[nodiscard]] Plane plane(scene::SceneFace, glm::dvec2 at) const;

    /// The same as (a, b, c): a x + b y + c.
    [[nodiscard]] glm::dvec3 planeFunction(scene::SceneFace) const;

    /// Whether the surfaces that end at two borders, each an instance's half-edge, go on into each other without a
    /// crease. None: the borders do not run along each other.
    [[nodiscard]] std::optional<bool> goOnAcrossSeam(std::uint32_t instance, std::uint32_t halfEdge,
                                                     std::uint32_t otherInstance, std::uint32_t otherHalfEdge) const;

    /// Whether two triangles of one mesh are the same or touch each other.
    [[nodiscard]] bool touch(scene::SceneFace, scene::SceneFace) const;

    /// The number of a triangle's patch (PatchNumbers::number).
    [[nodiscard]] std::uint32_t patchOf(scene::SceneFace) const;

    /// Where the border of a coplanar layer lies between two points, whichever layer is seen there.
    struct LayerBorder {
        double t;  ///< share of the way
        scene::SceneFace face;
    };
    /// @param patch  the layer's number (PatchNumbers::number)
    [[nodiscard]] std::optional<LayerBorder> layerBorder(std::uint32_t patch, glm::dvec2 start, glm::dvec2 goal) const;

private:
    struct BorderEdge {
        scene::SceneFace face;
        glm::dvec3 from;  // homogeneous pixels
        glm::dvec3 to;
    };
    void collectLayerBorders();

    // Null: that walk is not asked for.
    void walk(scene::SceneFace from, glm::dvec2 start, glm::dvec2 goal, Walk* patch, Walk* surface) const;

    [[nodiscard]] glm::dvec3 corner(std::uint32_t instance, std::uint32_t c) const {
        return projected(instance, scene_.meshes()[scene_.instances()[instance].mesh].indices[c]);
    }
    [[nodiscard]] glm::dvec3 project(std::uint32_t instance, std::uint32_t position) const;
    void projectAll();

    const Scene& scene_;
    scene::SeamCreases seamCreases_;
    const std::vector<std::uint32_t>& firstTriangles_;
    std::vector<glm::dmat4x3> toPixels_;  // one per instance: mesh positions less their origin -> homogeneous pixels
    std::vector<glm::dvec3> projected_;   // all positions of all instances; none: they are too many to keep
    std::vector<std::size_t> firstProjected_;  // one per instance: where its positions begin there
    std::vector<glm::dvec4> toW_;              // one per instance in an orthographic view: mesh positions -> w
    std::unordered_map<std::uint32_t, std::vector<BorderEdge>> layerBorders_;  // by patch number
};

}  // namespace inkedge::trace
