#include "lines/see/touching.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "scene/world_triangles.h"

namespace inkedge::lines {

// A face's side of an edge.
struct Touching::Edge {
    glm::dvec3 into;    // unit, in the face's plane, across the edge into the face; 0 for a face without area
    glm::dvec3 normal;  // unit
    double within;      // world units
};

Touching::Touching(const Scene& scene, const RayCaster& rays, const SurfaceComponents* components, const Screen& screen)
    : scene_{scene},
      rays_{rays},
      components_{components},
      screen_{screen},
      creaseCosine_{std::cos(glm::radians(scene.creaseAngle()))} {}

Touching::Edge Touching::edgeOf(const Segment& segment, scene::SceneFace face, glm::dvec3 point) const {
    const scene::WorldTriangles triangles{scene_, scene_.instances()[face.instance], scene_.bounds().centre};
    const auto corners = triangles.triangle(face.triangle);
    const glm::dvec3 along = glm::normalize(segment.ends[1] - segment.ends[0]);
    const glm::dvec3 toMiddle = (corners[0] + corners[1] + corners[2]) / 3.0 - segment.ends[0];
    const glm::dvec3 across = toMiddle - along * glm::dot(toMiddle, along);
    const double length = glm::length(across);
    const glm::dvec3 into = length > 0.0 ? across / length : glm::dvec3{0.0};
    const double rounding = 1e-6 * scene_.bounds().radius;
    return {into, glm::cross(along, into), touchingWithin * screen_.footprint(point) + rounding};
}

bool Touching::goesOn(const Segment& segment, const Edge& edge, glm::dvec3 beside, Which which) const {
    const glm::dvec3 off = edge.within * edge.normal;
    return rays_.meetsBetween(beside + off, beside - off, [&](scene::SceneFace face, glm::dvec3 normal) {
        if (std::ranges::find(segment.faces, face) != segment.faces.end()) return false;
        const bool counts = which == Which::Any || components_->of(face) != components_->of(segment.faces[0]);
        return counts && std::abs(glm::dot(normal, edge.normal)) > creaseCosine_;
    });
}

// Whether the face that goes on beyond the edge lies below it, too. A ray meets but one of two faces in one plane.
bool Touching::isBelow(const Segment& segment, const Edge& edge, glm::dvec3 point) const {
    const glm::dvec3 off = edge.within * edge.normal;
    const glm::dvec3 beyond = point - 0.5 * edge.within * edge.into;
    const glm::dvec3 below = point + 0.5 * edge.within * edge.into;
    return rays_.meetsBetween(beyond + off, beyond - off, [&](scene::SceneFace face, glm::dvec3 normal) {
        if (components_->of(face) == components_->of(segment.faces[0])) return false;
        const scene::WorldTriangles triangles{scene_, scene_.instances()[face.instance], scene_.bounds().centre};
        const auto corners = triangles.triangle(face.triangle);
        const auto side = [&](std::size_t k) {
            return glm::dot(normal, glm::cross(corners[(k + 1) % 3] - corners[k], below - corners[k]));
        };
        return side(0) >= 0.0 && side(1) >= 0.0 && side(2) >= 0.0;
    });
}

Touch Touching::atBorder(const Segment& segment, glm::dvec3 point) const {
    const Edge edge = edgeOf(segment, segment.faces[0], point);
    const glm::dvec3 step = 0.5 * edge.within * edge.into;
    if (!goesOn(segment, edge, point - step, Which::Any)) return Touch::None;
    const bool runsOn = components_ != nullptr &&
                        (goesOn(segment, edge, point + step, Which::OtherComponents) || isBelow(segment, edge, point));
    return runsOn ? Touch::RunsOn : Touch::Begins;
}

bool Touching::atEdge(const Segment& segment, glm::dvec3 point) const {
    if (components_ == nullptr) return false;
    return std::ranges::any_of(segment.faces, [&](scene::SceneFace face) {
        if (face == noFace) return false;
        const Edge edge = edgeOf(segment, face, point);
        return goesOn(segment, edge, point - 0.5 * edge.within * edge.into, Which::OtherComponents);
    });
}

}  // namespace inkedge::lines
