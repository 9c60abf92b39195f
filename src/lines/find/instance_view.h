#pragma once

#include <cmath>
#include <cstdint>

#include <glm/matrix.hpp>

#include <inkedge/scene.h>

#include "lines/find/contour_finders.h"
#include "lines/screen.h"

namespace inkedge::lines {

/// An instance as a camera sees it. Mesh space is less Mesh::origin, world space less the centre of Scene::bounds().
struct InstanceView {
    glm::dmat4 toWorld;
    double scale;  ///< of lengths, to world units; 0: the instance is scaled to a point
    MeshEye eye;

    InstanceView(const Scene& scene, std::uint32_t instance, const Screen& screen)
        : toWorld{scene.instances()[instance].transform} {
        const glm::dvec3 origin = scene.meshes()[scene.instances()[instance].mesh].origin;
        toWorld[3] += toWorld * glm::dvec4{origin, 0.0} - glm::dvec4{scene.bounds().centre, 0.0};
        scale = std::cbrt(std::abs(glm::determinant(glm::dmat3{toWorld})));
        const glm::dmat4 back = glm::inverse(toWorld);
        eye = {screen.orthographic(), glm::dvec3{back * glm::dvec4{screen.eye(), 1.0}},
               glm::dmat3{back} * screen.direction()};
    }

    [[nodiscard]] glm::dvec3 world(glm::dvec3 p) const { return glm::dvec3{toWorld * glm::dvec4{p, 1.0}}; }
};

}  // namespace inkedge::lines
