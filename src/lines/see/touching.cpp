#include "lines/see/touching.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "scene/world_triangles.h"

namespace inkedge::lines {
namespace {

// Faces with a smaller angle between them lie on each other.
const double layersSine = std::sin(glm::radians(1.0));
constexpr double edgeOnCosine = 1e-3;  // of the angle between a face's normal and the view of a face seen as a line

}  // namespace

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

double Touching::withinAt(glm::dvec3 point) const {
    const double rounding = 1e-6 * scene_.bounds().radius;
    return touchingWithin * screen_.footprint(point) + rounding;
}

Touching::Edge Touching::edgeOf(const Segment& segment, scene::SceneFace face, glm::dvec3 point) const {
    const scene::WorldTriangles triangles{scene_, scene_.instances()[face.instance], scene_.bounds().centre};
    const auto corners = triangles.triangle(face.triangle);
    const glm::dvec3 along = glm::normalize(segment.ends[1] - segment.ends[0]);
    const glm::dvec3 toMiddle = (corners[0] + corners[1] + corners[2]) / 3.0 - segment.ends[0];
    const glm::dvec3 across = toMiddle - along * glm::dot(toMiddle, along);
    const double length = glm::length(across);
    const glm::dvec3 into = length > 0.0 ? across / length : glm::dvec3{0.0};
    return {into, glm::cross(along, into), withinAt(point)};
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

// Looks in front of points beside the edge, where a ray meets no two faces at once: one on each of its faces, or to
// both sides of faces that are seen as a line.
bool Touching::isBehindFace(const Segment& segment, glm::dvec3 point) const {
    if (components_ == nullptr || segment.faces[0].triangle == noTriangle) return false;
    const glm::dvec3 view = screen_.ray(point);
    const double distance = glm::length(view);
    const double within = RayCaster::minStep * distance;
    if (!components_->mayBeNear(segment.faces[0], point, within)) return false;
    std::vector<Edge> edges;
    for (const scene::SceneFace own : segment.faces)
        if (own != noFace) edges.push_back(edgeOf(segment, own, point));
    const auto isEdgeOn = [&](const Edge& edge) {
        return std::abs(glm::dot(edge.normal, view)) < edgeOnCosine * distance;
    };
    std::vector<glm::dvec3> beside;
    const bool allEdgeOn = std::ranges::all_of(edges, isEdgeOn);
    for (const Edge& edge : edges) {
        const double step = 0.5 * edge.within;
        if (allEdgeOn) beside.insert(beside.end(), {point + step * edge.normal, point - step * edge.normal});
        if (!isEdgeOn(edge)) beside.push_back(point + step * edge.into);
    }
    const auto hides = [&](scene::SceneFace face, glm::dvec3 normal) {
        if (components_->of(face) == components_->of(segment.faces[0])) return false;
        const scene::WorldTriangles triangles{scene_, scene_.instances()[face.instance], scene_.bounds().centre};
        if (std::abs(glm::dot(normal, point - triangles.triangle(face.triangle)[0])) > within) return false;
        const double sign = glm::dot(normal, view) < 0.0 ? 1.0 : -1.0;
        const auto isBehind = [&](const Edge& edge) { return sign * glm::dot(normal, edge.into) < -layersSine; };
        return std::ranges::all_of(edges, isBehind);
    };
    constexpr double grazing = 50.0;  // how much further than beside the edge a face may be in front of it
    const glm::dvec3 towards = -view / distance * (0.5 * grazing * edges[0].within + within);
    const glm::dvec3 end = (allEdgeOn ? -0.1 : 1e-3) * towards;  // no face of the edge is met on the way
    return std::ranges::all_of(beside,
                               [&](glm::dvec3 at) { return rays_.meetsBetween(at + towards, at + end, hides); });
}

bool Touching::atEdge(const Segment& segment, glm::dvec3 point) const {
    if (components_ == nullptr) return false;
    if (!components_->mayBeNear(segment.faces[0], point, 2.0 * withinAt(point))) return false;
    return std::ranges::any_of(segment.faces, [&](scene::SceneFace face) {
        if (face == noFace) return false;
        const Edge edge = edgeOf(segment, face, point);
        return goesOn(segment, edge, point - 0.5 * edge.within * edge.into, Which::OtherComponents);
    });
}

}  // namespace inkedge::lines
