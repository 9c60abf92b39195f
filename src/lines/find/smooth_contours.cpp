#include "lines/find/smooth_contours.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <unordered_map>

#include <glm/geometric.hpp>

#include "base/parallel.h"
#include "lines/find/facet.h"
#include "lines/find/surface_contours.h"
#include "mesh/subdivide.h"

namespace inkedge::lines {
namespace {

class Search {
public:
    Search(const SmoothContourSearch& of, std::vector<Segment>& to) : of_{of}, to_{to} {
        const FaceSurfaces* const surfaces = surfacesOf(of.mesh, of.choice);
        if (surfaces != nullptr && of.choice.contour != Contour::Mesh)
            exact_.emplace(*surfaces, of.mesh.origin, of.view, of.screen);
    }

    void addContours() { of_.choice.refinement > 0 ? addRefinedContours() : addMeshContours(); }

private:
    [[nodiscard]] glm::dvec3 position(std::uint32_t corner) const {
        return glm::dvec3{of_.mesh.positions[of_.mesh.indices[corner]]};
    }
    [[nodiscard]] glm::dvec3 toWorld(glm::dvec3 p) const { return of_.view.world(p); }
    [[nodiscard]] glm::dvec3 view(glm::dvec3 p) const { return of_.view.eye.view(p); }
    [[nodiscard]] bool hidesItsBack(std::uint32_t t) const { return of_.choice.eyeOutside && of_.edges.closed[t] != 0; }

    // Equation 2 at each vertex: n . (x - C). Exactly 0 where only rounding says that it is not.
    void computeViewDots() {
        viewDots_.resize(of_.mesh.positions.size());
        base::inRanges(viewDots_.size(), [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                const glm::dvec3 toEye = view(glm::dvec3{of_.mesh.positions[i]});
                const double dot = glm::dot(glm::dvec3{of_.mesh.normals[i]}, toEye);
                const double sine = double{of_.edges.normalSines[i]};
                viewDots_[i] = dot * dot <= sine * sine * glm::dot(toEye, toEye) ? 0.0 : dot;
            }
        });
    }

    void addRefinedContours() {
        const auto projection =
            of_.screen.orthographic() ? mesh::Projection::Orthographic : mesh::Projection::Perspective;
        const glm::dvec3 eye =
            of_.view.eye.orthographic ? of_.view.eye.direction : of_.view.eye.position + of_.mesh.origin;
        const mesh::RefinedContourMesh refined =
            mesh::refineNear(of_.mesh, of_.choice.limit->control(), eye, projection, of_.choice.refinement);
        std::unordered_map<std::uint64_t, std::uint32_t> edges;
        for (std::size_t t = 0; t < refined.controlTriangles.size(); ++t) {
            Facet facet{refined.controlTriangles[t], longestEdge(of_.mesh, refined.controlTriangles[t])};
            glm::dvec3 normals{0.0};
            const std::uint32_t* const corners = &refined.indices[3 * t];
            for (std::size_t k = 0; k < 3; ++k) {
                facet.corners[k] = refined.positions[corners[k]];
                facet.viewDots[k] = glm::dot(refined.normals[corners[k]], view(facet.corners[k]));
                normals += glm::dvec3{refined.normals[corners[k]]};
                const auto [low, high] = std::minmax(corners[k], corners[(k + 1) % 3]);
                const auto [edge, isNew] = edges.try_emplace((std::uint64_t{low} << 32U) | high, joints_);
                if (isNew) ++joints_;
                facet.edges[k] = refinedKey(of_.instance, edge->second);
            }
            facet.surface = of_.choice.limit->triangle(refined.limitTriangles[t]);
            addContour(facet, facet.planeViewDot(normals, view(facet.corners[0])));
        }
    }

    // How far a contour may lie off a triangle: as far as it is large; one that strays from its surface by less than a
    // pixel as it is wide, for those of a cylinder are as long as it is.
    [[nodiscard]] double slackOf(std::uint32_t t) const {
        return exact_ && of_.mesh.limitTriangles.empty() ? 2.0 * heightOf(t) : longestEdge(of_.mesh, t);
    }

    // The least width of a triangle: those of a cylinder are as long as it is.
    [[nodiscard]] double heightOf(std::uint32_t t) const {
        const glm::dvec3 a = position(3 * t);
        const double twiceArea = glm::length(glm::cross(position(3 * t + 1) - a, position(3 * t + 2) - a));
        const double longest = longestEdge(of_.mesh, t);
        return longest > 0.0 ? twiceArea / longest : 0.0;
    }

    void addMeshContours() {
        computeViewDots();
        for (std::uint32_t t = 0; t < of_.topology.patches.size(); ++t) {
            const std::uint32_t* const corners = &of_.mesh.indices[3 * std::size_t{t}];
            const auto lowHigh = std::minmax({viewDots_[corners[0]], viewDots_[corners[1]], viewDots_[corners[2]]});
            if (lowHigh.first > 0.0 || lowHigh.second < 0.0 || lowHigh.first == lowHigh.second) continue;
            if (!of_.smooth[of_.topology.surfaceOf(t)] || of_.topology.originals[t] != t || of_.large.contains(t))
                continue;
            Facet facet{t, slackOf(t)};
            if (exact_) facet.surface = of_.mesh.surfaces->under(of_.mesh, t);
            glm::dvec3 normals{0.0};
            for (std::uint32_t k = 0; k < 3; ++k) {
                const std::uint32_t h = 3 * t + k;
                const std::uint32_t twin = of_.topology.twins[h];
                facet.corners[k] = position(h);
                facet.viewDots[k] = viewDots_[corners[k]];
                normals += glm::dvec3{of_.mesh.normals[corners[k]]};
                facet.edges[k] = edgeKey(of_.instance, mesh::isHalfEdge(twin) ? std::min(h, twin) : h);
            }
            addContour(facet, facet.planeViewDot(normals, view(facet.corners[0])));
        }
    }

    void addContour(const Facet& facet, double planeViewDot) {
        const auto& [face, size, corners, viewDots, edges, surface] = facet;
        const glm::dvec3 seen = view(corners[0]);
        const int zero = hidesItsBack(face) ? int{of_.edges.closed[face]} : facet.signOfZero(seen);
        const auto isPlus = [&](double dot) { return dot > 0.0 || (dot == 0.0 && zero > 0); };
        const std::array<bool, 3> plus{isPlus(viewDots[0]), isPlus(viewDots[1]), isPlus(viewDots[2])};
        if (plus[0] == plus[1] && plus[1] == plus[2]) return;
        // The surface, followed away from the eye, turns its front to the eye: the surface then hides the contour.
        const bool hidden = hidesItsBack(face) && facet.growthAlong(seen) * of_.edges.closed[face] < 0.0;
        if (hidden && of_.choice.hidden == HiddenLines::None) return;
        Segment segment;
        segment.hidden = hidden;
        segment.occludes = false;  // the mesh contour of the faces does
        segment.faces = {scene::SceneFace{of_.instance, face}, noFace};
        std::array<SurfaceContours::Point, 2> crossings{};
        std::size_t found = 0;
        std::uint32_t inner = 0;
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::uint32_t next = (k + 1) % 3;
            // In the picture the surface lies to the side where n . (x - C) has the sign of the triangle's plane.
            if (viewDots[k] * planeViewDot > viewDots[inner] * planeViewDot) inner = k;
            if (plus[k] == plus[next]) continue;
            const double a = std::abs(viewDots[k]);
            const double b = std::abs(viewDots[next]);
            const glm::dvec3 linear = (b * corners[k] + a * corners[next]) / (a + b);  // equation 4
            if (surface) crossings[found] = exact_->crossing(*surface, k, corners, linear);
            segment.ends[found] = toWorld(linear);
            segment.keys[found++] = edges[k];
        }
        segment.inner = toWorld(corners[inner]);
        segment.slack = size * of_.view.scale;
        surface ? addPieces(segment, exact_->between(surface->face, crossings[0], crossings[1]))
                : to_.push_back(segment);
    }

    // Adds a contour that bends within its triangle.
    void addPieces(const Segment& whole, const std::vector<glm::dvec3>& points) {
        for (std::size_t i = 0; i + 1 < points.size(); ++i) {
            Segment& piece = to_.emplace_back(whole);
            piece.ends = {toWorld(points[i]), toWorld(points[i + 1])};
            if (i > 0) piece.keys[0] = refinedKey(of_.instance, joints_ - 1);
            if (i + 2 < points.size()) piece.keys[1] = refinedKey(of_.instance, joints_++);
        }
    }

    const SmoothContourSearch& of_;
    std::vector<Segment>& to_;
    std::optional<SurfaceContours> exact_;  // where the triangles stand for surfaces
    std::vector<double> viewDots_;          // one per position: n . (x - C)
    std::uint32_t joints_ = 0;              // of contours, that are no edges of the mesh
};

}  // namespace

const FaceSurfaces* surfacesOf(const Mesh& mesh, const CurveChoice& choice) {
    return choice.refinement > 0 ? choice.limit : mesh.surfaces.get();
}

double longestEdge(const Mesh& mesh, std::uint32_t t) {
    double longest = 0.0;
    for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h)
        longest = std::max(longest, glm::length(glm::dvec3{mesh.positions[mesh.indices[mesh::nextHalfEdge(h)]]} -
                                                glm::dvec3{mesh.positions[mesh.indices[h]]}));
    return longest;
}

void addSmoothContours(const SmoothContourSearch& search, std::vector<Segment>& to) {
    Search{search, to}.addContours();
}

}  // namespace inkedge::lines
