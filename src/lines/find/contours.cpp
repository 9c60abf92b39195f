#include "lines/find/contours.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <unordered_map>
#include <unordered_set>

#include <glm/geometric.hpp>

#include "base/parallel.h"
#include "lines/find/beside_edge.h"
#include "lines/find/facet.h"
#include "lines/find/instance_view.h"
#include "lines/find/surface_contours.h"
#include "mesh/subdivide.h"
#include "scene/prepared.h"

namespace inkedge::lines {
namespace {

// Collects the curves of an instance, with the eye in mesh space (MeshEye).
class InstanceCurves {
public:
    InstanceCurves(const Scene& scene, std::uint32_t instance, const InstanceEdges& edges, const Screen& screen,
                   const CurveChoice& choice, std::vector<Segment>& to)
        : instance_{instance},
          mesh_{scene.meshes()[scene.instances()[instance].mesh]},
          topology_{scene::topologyOf(scene, scene.instances()[instance].mesh)},
          search_{edges.search},
          edges_{edges.search.edges()},
          screen_{screen},
          choice_{choice},
          borders_{edges.borders},
          isolines_{edges.isolines},
          to_{to},
          view_{scene, instance, screen},
          eye_{view_.eye} {
        if ((mesh_.surfaces || mesh_.field) && choice.contour != Contour::Mesh) exact_.emplace(mesh_, view_, screen_);
    }

    void collect(ContourMemory& memory) {
        if (view_.scale == 0.0) return;
        contours_ = search_.find(eye_, choice_.finder, memory);
        for (const std::uint32_t e : contours_.edges) isSmooth_.push_back(!isSplit(mesh_, topology_, edges_, e));
        chooseSmoothPatches();
        if (choice_.contour == Contour::Auto && choice_.refinement == 0 && !exact_) findLargeFaces();
        addContourEdges();
        addCreases();
        addBorders();
        addMany();
        addIsolines();
        if (std::ranges::find(smooth_, true) != smooth_.end()) addSmoothContours();
    }

private:
    [[nodiscard]] glm::dvec3 position(std::uint32_t corner) const {
        return glm::dvec3{mesh_.positions[mesh_.indices[corner]]};
    }
    [[nodiscard]] glm::dvec3 toWorld(glm::dvec3 p) const { return view_.world(p); }
    // The vector from the eye to a point: x - C.
    [[nodiscard]] glm::dvec3 view(glm::dvec3 p) const { return eye_.view(p); }
    [[nodiscard]] scene::SceneFace face(std::uint32_t t) const { return {instance_, t}; }
    [[nodiscard]] bool hidesItsBack(std::uint32_t t) const { return choice_.eyeOutside && edges_.closed[t] != 0; }

    [[nodiscard]] bool keepsHidden() const { return choice_.hidden != HiddenLines::None; }

    void chooseSmoothPatches() {
        const bool refined = exact_ || (choice_.refinement > 0 && choice_.contour != Contour::Mesh);
        smooth_.assign(topology_.patchCount(), refined || choice_.contour == Contour::Smooth);
        if (refined || choice_.contour != Contour::Auto) return;
        struct Mean {
            double pixels = 0.0;
            int count = 0;
        };
        std::vector<Mean> means(topology_.patchCount());
        for (std::size_t i = 0; i < contours_.edges.size(); ++i) {
            if (!isSmooth_[i]) continue;
            const std::uint32_t e = contours_.edges[i];
            const std::uint32_t h = edges_.shared.halfEdges[e];
            const glm::dvec3 from = toWorld(position(h));
            const glm::dvec3 to = toWorld(position(mesh::nextHalfEdge(h)));
            if (screen_.depth(from) <= screen_.near()) continue;
            Mean& mean = means[topology_.surfaceOf(h / 3)];
            mean.pixels += glm::length(to - from) / screen_.footprint(from);
            ++mean.count;
        }
        for (std::size_t patch = 0; patch < means.size(); ++patch)
            smooth_[patch] = means[patch].count > 0 && means[patch].pixels <= smoothEdge * means[patch].count;
    }

    Segment& add(Curve curve, std::uint32_t halfEdge, scene::SceneFace other) {
        Segment& segment = to_.emplace_back();
        segment.curve = curve;
        segment.occludes = curve == Curve::Contour || curve == Curve::Boundary;
        const std::uint32_t end = mesh::nextHalfEdge(halfEdge);
        segment.faces = {face(halfEdge / 3), other};
        segment.ends = {toWorld(position(halfEdge)), toWorld(position(end))};
        segment.keys = {pointKey(instance_, topology_.points[halfEdge]), pointKey(instance_, topology_.points[end])};
        segment.inner = toWorld(position(mesh::nextHalfEdge(end)));
        return segment;
    }

    [[nodiscard]] bool isEdgeOn(std::uint32_t t) const { return facing(t) == Facing::EdgeOn; }
    [[nodiscard]] Facing facing(std::uint32_t t) const {
        return contours_.facing.empty() ? search_.facing(eye_, t) : contours_.facing[t];
    }

    // Whether a closed component is concave at an edge: the component itself hides such a contour.
    [[nodiscard]] bool isHiddenFold(std::uint32_t e) const {
        const std::uint32_t h = edges_.shared.halfEdges[e];
        const std::uint32_t t = edges_.shared.faces[2 * e];
        if (!hidesItsBack(t)) return false;
        const std::uint32_t other = topology_.twins[h];
        if (edges_.faceNormals[other / 3] == glm::dvec3{0.0}) return false;  // too thin to say
        const glm::dvec3 opposite = position(mesh::previousHalfEdge(other));
        const double height = glm::dot(edges_.faceNormals[t], opposite - position(h)) * edges_.closed[t];
        if (!isEdgeOn(t) && !isEdgeOn(edges_.shared.faces[2 * e + 1])) return height > 0.0;
        // Two faces of one plane, of which only one counts as edge-on, are no fold.
        const double rounding = 2.0 * double{edges_.edgeOnSines[t]} * glm::length(opposite - position(h));
        return height > rounding;
    }

    [[nodiscard]] bool isLarge(std::uint32_t t) const {
        const glm::dvec3 corner = toWorld(position(3 * t));
        return screen_.depth(corner) > screen_.near() &&
               longestEdge(t) * view_.scale > largeEdge * screen_.footprint(corner);
    }

    // A smooth contour, which may cross a face anywhere, leaves out parts of large ones: mesh contours are drawn there.
    void findLargeFaces() {
        for (std::size_t i = 0; i < contours_.edges.size(); ++i) {
            const std::uint32_t e = contours_.edges[i];
            for (const std::uint32_t t : {edges_.shared.faces[2 * e], edges_.shared.faces[2 * e + 1]})
                if (isReplaced(i) && isLarge(t)) large_.insert(t);
        }
        for (const std::uint32_t t : large_)
            for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) largePoints_.insert(topology_.points[h]);
    }

    // Whether a smooth contour replaces a contour edge.
    // @param i  into the contour edges
    [[nodiscard]] bool isReplaced(std::size_t i) const {
        const std::uint32_t h = edges_.shared.halfEdges[contours_.edges[i]];
        return isSmooth_[i] && smooth_[topology_.surfaceOf(h / 3)] && !largePoints_.contains(topology_.points[h]) &&
               !largePoints_.contains(topology_.points[mesh::nextHalfEdge(h)]);
    }

    [[nodiscard]] bool draws(LineType type) const { return choice_.lines.contains(type); }
    [[nodiscard]] bool isMarked(std::uint32_t halfEdge) const {
        return draws(LineType::Marked) && lines::isMarked(mesh_, topology_, halfEdge);
    }
    // What an edge is that is no contour.
    // @param crease  whether it would be drawn without a mark
    [[nodiscard]] Curve curveOf(bool marked, bool crease) const {
        const bool staysCrease = crease && choice_.markedCreases == MarkedCreases::AreCreasesIfDrawn;
        return marked && !(staysCrease && draws(LineType::Crease)) ? Curve::Marked : Curve::Crease;
    }
    // Whether a contour or boundary may become a marked line; if all their types are drawn none does, and chains need
    // not be divided.
    [[nodiscard]] bool marksOutlines() const {
        return !draws(LineType::Outline) || !draws(LineType::Occlusion) || !draws(LineType::Boundary);
    }

    // The third point of one of an edge's two faces: of the face that is seen less edge-on.
    [[nodiscard]] glm::dvec3 innerOf(std::uint32_t h) const {
        const glm::dvec3 from = position(h);
        const glm::dvec3 side = glm::cross(position(mesh::nextHalfEdge(h)) - from, view(from));
        const glm::dvec3 one = position(mesh::previousHalfEdge(h));
        const glm::dvec3 other = position(mesh::previousHalfEdge(topology_.twins[h]));
        const bool first = std::abs(glm::dot(side, one - from)) >= std::abs(glm::dot(side, other - from));
        return toWorld(first ? one : other);
    }

    void addContourEdges() {
        for (std::size_t i = 0; i < contours_.edges.size(); ++i) {
            const std::uint32_t e = contours_.edges[i];
            const bool hidden = isHiddenFold(e);
            if (hidden && !keepsHidden()) continue;
            const std::uint32_t h = edges_.shared.halfEdges[e];
            Segment& segment = add(Curve::Contour, h, face(edges_.shared.faces[2 * e + 1]));
            segment.faces[0] = face(edges_.shared.faces[2 * e]);
            segment.inner = innerOf(h);
            segment.hidden = hidden;
            segment.edgeOn = isEdgeOn(edges_.shared.faces[2 * e]) || isEdgeOn(edges_.shared.faces[2 * e + 1]);
            segment.occludes = !hidden;
            segment.drawn = !isReplaced(i);
            segment.marked = marksOutlines() && isMarked(h);
        }
    }

    [[nodiscard]] bool isBack(std::uint32_t t) const {
        if (!hidesItsBack(t)) return false;
        const Facing seen = facing(t);
        return seen == Facing::EdgeOn || (seen == Facing::Front) != (edges_.closed[t] > 0);
    }

    // Whether a face is seen edge-on and lies before an edge of it.
    [[nodiscard]] bool covers(std::uint32_t t, std::uint32_t halfEdge) const {
        return isEdgeOn(t) && search_.liesBefore(eye_, t, halfEdge);
    }

    void addCreases() {
        addUnlessContours(edges_.creases, [&](std::uint32_t h) { return curveOf(isMarked(h), true); });
        if (draws(LineType::Marked)) addUnlessContours(edges_.marked, [](std::uint32_t) { return Curve::Marked; });
        if (draws(LineType::Tangent)) addUnlessContours(edges_.tangents, [](std::uint32_t) { return Curve::Tangent; });
    }

    // @param curveOf  of a half-edge
    template <class CurveOf>
    void addUnlessContours(const std::vector<std::uint32_t>& edges, CurveOf&& curveOf) {
        std::size_t nextContour = 0;
        for (const std::uint32_t e : edges) {  // both lists are in order
            while (nextContour < contours_.edges.size() && contours_.edges[nextContour] < e) ++nextContour;
            if (nextContour < contours_.edges.size() && contours_.edges[nextContour] == e && !isReplaced(nextContour))
                continue;
            const std::uint32_t first = edges_.shared.faces[2 * e];
            const std::uint32_t other = edges_.shared.faces[2 * e + 1];
            const std::uint32_t h = edges_.shared.halfEdges[e];
            const bool hidden = (isBack(other) && isBack(first)) || covers(first, h) || covers(other, h);
            if (hidden && !keepsHidden()) continue;
            Segment& segment = add(curveOf(h), h, face(other));
            segment.hidden = hidden;
            segment.edgeOn = isEdgeOn(first) || isEdgeOn(other);
        }
    }

    void addBorders() {
        for (const BorderSegment& part : borders_) {
            Curve curve = Curve::Boundary;
            const bool marked = part.marked && draws(LineType::Marked);
            const auto [own, other] = besideBorder(part);
            if (part.other != noFace) {
                if (own.side * other.side >= 0 && own.side + other.side != 0) {
                    curve = Curve::Contour;
                } else if (marked || part.bends) {
                    curve = curveOf(marked, part.bends);
                } else {
                    continue;  // a seam
                }
            }
            const bool hidden = own.covers || other.covers;
            if (hidden && !keepsHidden()) continue;
            Segment& segment = add(curve, part.halfEdge, part.other);
            segment.hidden = hidden;
            segment.occludes = segment.occludes && !hidden;
            segment.edgeOn = own.side == 0 || (part.other != noFace && other.side == 0);
            if (curve == Curve::Contour && own.side == 0) segment.inner = part.otherInner;
            segment.marked = segment.occludes && marked && marksOutlines();
            const std::array<glm::dvec3, 2> whole = segment.ends;
            const auto cut = [&](std::size_t end, double at) {
                segment.ends[end] = whole[0] + at * (whole[1] - whole[0]);
                segment.keys[end] = noKey;
            };
            if (part.from > 0.0) cut(0, part.from);
            if (part.to < 1.0) cut(1, part.to);
        }
    }

    // The face of a border, and the face that goes on beyond the border. If both lie to one side, or one of them is
    // seen edge-on, the seam between them is a contour.
    [[nodiscard]] std::pair<BesideEdge, BesideEdge> besideBorder(const BorderSegment& part) const {
        const std::uint32_t h = part.halfEdge;
        const std::array<glm::dvec3, 2> edge{toWorld(position(h)), toWorld(position(mesh::nextHalfEdge(h)))};
        const glm::dvec3 view = screen_.ray(edge[0]);
        const BesideEdge own = besideEdge(edge, toWorld(position(mesh::previousHalfEdge(h))), view, isEdgeOn(h / 3));
        if (part.other == noFace) return {own, {0, false}};
        const glm::dvec3 normal = glm::cross(edge[1] - edge[0], part.otherInner - edge[0]);
        const double sine = std::abs(glm::dot(normal, view)) / (glm::length(normal) * glm::length(view));
        return {own, besideEdge(edge, part.otherInner, view, sine <= double{edges_.edgeOnSines[h / 3]})};
    }

    // Adds edges of many faces. Such an edge is a contour if all its faces lie to one side of it in the picture.
    void addMany() {
        for (std::size_t i = 0; i + 1 < edges_.manyBegins.size(); ++i) {
            const std::uint32_t begin = edges_.manyBegins[i];
            const std::uint32_t end = edges_.manyBegins[i + 1];
            const std::uint32_t first = edges_.many[begin];
            const std::array<glm::dvec3, 2> edge{position(first), position(mesh::nextHalfEdge(first))};
            bool left = false;
            bool right = false;
            bool marked = false;
            bool edgeOn = false;
            bool hidden = false;
            std::uint32_t inner = first;  // a half-edge of a face that is not seen edge-on, if there is one
            for (std::uint32_t k = begin; k < end; ++k) {
                const std::uint32_t h = edges_.many[k];
                const BesideEdge at =
                    besideEdge(edge, position(mesh::previousHalfEdge(h)), view(edge[0]), isEdgeOn(h / 3));
                left = left || at.side > 0;
                right = right || at.side < 0;
                marked = marked || isMarked(h);
                edgeOn = edgeOn || at.side == 0;
                hidden = hidden || at.covers;
                if (isEdgeOn(inner / 3)) inner = h;
            }
            if (hidden && !keepsHidden()) continue;
            const Curve curve = left != right ? Curve::Contour : curveOf(marked, true);
            Segment& segment = add(curve, first, face(edges_.many[begin + 1] / 3));
            segment.marked = segment.occludes && marked && marksOutlines();
            segment.hidden = hidden;
            segment.occludes = segment.occludes && !hidden;
            segment.edgeOn = edgeOn;
            segment.inner = toWorld(position(mesh::previousHalfEdge(inner)));
        }
    }

    void addIsolines() {
        for (const IsolineSegment& line : isolines_) {
            const scene::SceneFace other = faceBeside(line);
            const bool hidden = isBack(line.triangle) && (other == noFace || isBack(other.triangle));
            if (hidden && !keepsHidden()) continue;
            Segment& segment = to_.emplace_back();
            segment.curve = Curve::Isoparametric;
            segment.hidden = hidden;
            segment.occludes = false;
            segment.faces = {face(line.triangle), other};
            for (std::size_t k = 0; k < 2; ++k) {
                segment.ends[k] = toWorld(line.ends[k]);
                segment.keys[k] = isolineKey(instance_, line.nodes[k]);
            }
        }
    }

    // The other face at the edge that a line follows.
    [[nodiscard]] scene::SceneFace faceBeside(const IsolineSegment& line) const {
        for (int k = 0; k < 3; ++k) {
            if (line.weights[0][k] != 0.0 || line.weights[1][k] != 0.0) continue;
            const std::uint32_t twin =
                topology_.twins[mesh::nextHalfEdge(3 * line.triangle + static_cast<std::uint32_t>(k))];
            if (mesh::isHalfEdge(twin)) return face(twin / 3);
        }
        return noFace;
    }

    // Equation 2 at each vertex: n . (x - C). Exactly 0 where only rounding says that it is not.
    void computeViewDots() {
        viewDots_.resize(mesh_.positions.size());
        base::inRanges(viewDots_.size(), [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                const glm::dvec3 toEye = view(glm::dvec3{mesh_.positions[i]});
                const double dot = glm::dot(glm::dvec3{mesh_.normals[i]}, toEye);
                const double sine = double{edges_.normalSines[i]};
                viewDots_[i] = dot * dot <= sine * sine * glm::dot(toEye, toEye) ? 0.0 : dot;
            }
        });
    }

    void addRefinedContours() {
        const auto projection = screen_.orthographic() ? mesh::Projection::Orthographic : mesh::Projection::Perspective;
        const glm::dvec3 eye = eye_.orthographic ? eye_.direction : eye_.position + mesh_.origin;
        const mesh::RefinedContourMesh refined =
            mesh::refineNear(mesh_, *choice_.control, eye, projection, choice_.refinement);
        std::unordered_map<std::uint64_t, std::uint32_t> edges;
        for (std::size_t t = 0; t < refined.controlTriangles.size(); ++t) {
            Facet facet{refined.controlTriangles[t], longestEdge(refined.controlTriangles[t])};
            glm::dvec3 normals{0.0};
            const std::uint32_t* const corners = &refined.indices[3 * t];
            for (std::size_t k = 0; k < 3; ++k) {
                facet.corners[k] = refined.positions[corners[k]];
                facet.viewDots[k] = glm::dot(refined.normals[corners[k]], view(facet.corners[k]));
                normals += glm::dvec3{refined.normals[corners[k]]};
                const auto [low, high] = std::minmax(corners[k], corners[(k + 1) % 3]);
                const auto next = static_cast<std::uint32_t>(edges.size());
                facet.edges[k] =
                    refinedKey(instance_, edges.try_emplace((std::uint64_t{low} << 32U) | high, next).first->second);
            }
            addSmoothContour(facet, facet.planeViewDot(normals, view(facet.corners[0])));
        }
    }

    [[nodiscard]] double longestEdge(std::uint32_t t) const {
        double longest = 0.0;
        for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h)
            longest = std::max(longest, glm::length(position(mesh::nextHalfEdge(h)) - position(h)));
        return longest;
    }

    // The least width of a triangle: those of a cylinder are as long as it is.
    [[nodiscard]] double heightOf(std::uint32_t t) const {
        const glm::dvec3 a = position(3 * t);
        const double twiceArea = glm::length(glm::cross(position(3 * t + 1) - a, position(3 * t + 2) - a));
        const double longest = longestEdge(t);
        return longest > 0.0 ? twiceArea / longest : 0.0;
    }

    void addSmoothContours() {
        if (choice_.refinement > 0) return addRefinedContours();
        computeViewDots();
        for (std::uint32_t t = 0; t < topology_.patches.size(); ++t) {
            const std::uint32_t* const corners = &mesh_.indices[3 * std::size_t{t}];
            const auto lowHigh = std::minmax({viewDots_[corners[0]], viewDots_[corners[1]], viewDots_[corners[2]]});
            if (lowHigh.first > 0.0 || lowHigh.second < 0.0 || lowHigh.first == lowHigh.second) continue;
            if (!smooth_[topology_.surfaceOf(t)] || topology_.originals[t] != t || large_.contains(t)) continue;
            Facet facet{t, exact_ ? 2.0 * heightOf(t) : longestEdge(t)};
            glm::dvec3 normals{0.0};
            for (std::uint32_t k = 0; k < 3; ++k) {
                const std::uint32_t h = 3 * t + k;
                const std::uint32_t twin = topology_.twins[h];
                facet.corners[k] = position(h);
                facet.viewDots[k] = viewDots_[corners[k]];
                normals += glm::dvec3{mesh_.normals[corners[k]]};
                facet.edges[k] = edgeKey(instance_, mesh::isHalfEdge(twin) ? std::min(h, twin) : h);
            }
            addSmoothContour(facet, facet.planeViewDot(normals, view(facet.corners[0])));
        }
    }

    void addSmoothContour(const Facet& facet, double planeViewDot) {
        const auto& [face, size, corners, viewDots, edges] = facet;
        const glm::dvec3 seen = view(corners[0]);
        const int zero = hidesItsBack(face) ? int{edges_.closed[face]} : facet.signOfZero(seen);
        const auto isPlus = [&](double dot) { return dot > 0.0 || (dot == 0.0 && zero > 0); };
        const std::array<bool, 3> plus{isPlus(viewDots[0]), isPlus(viewDots[1]), isPlus(viewDots[2])};
        if (plus[0] == plus[1] && plus[1] == plus[2]) return;
        // The surface, followed away from the eye, turns its front to the eye: the surface then hides the contour.
        const bool hidden = hidesItsBack(face) && facet.growthAlong(seen) * edges_.closed[face] < 0.0;
        if (hidden && !keepsHidden()) return;
        Segment segment;
        segment.hidden = hidden;
        segment.occludes = false;  // the mesh contour of the faces does
        segment.faces = {scene::SceneFace{instance_, face}, noFace};
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
            if (exact_)
                crossings[found] = exact_->crossing(
                    face, {mesh_.indices[3 * std::size_t{face} + k], mesh_.indices[3 * std::size_t{face} + next]},
                    linear);
            segment.ends[found] = toWorld(linear);
            segment.keys[found++] = edges[k];
        }
        segment.inner = toWorld(corners[inner]);
        segment.slack = size * view_.scale;
        exact_ ? addPieces(segment, exact_->between(face, crossings[0], crossings[1])) : to_.push_back(segment);
    }

    // Adds a contour that bends within its triangle.
    void addPieces(const Segment& whole, const std::vector<glm::dvec3>& points) {
        for (std::size_t i = 0; i + 1 < points.size(); ++i) {
            Segment& piece = to_.emplace_back(whole);
            piece.ends = {toWorld(points[i]), toWorld(points[i + 1])};
            if (i > 0) piece.keys[0] = refinedKey(instance_, joints_ - 1);
            if (i + 2 < points.size()) piece.keys[1] = refinedKey(instance_, joints_++);
        }
    }

    std::uint32_t instance_;
    const Mesh& mesh_;
    const mesh::MeshTopology& topology_;
    const ContourSearch& search_;
    const MeshEdges& edges_;
    const Screen& screen_;
    const CurveChoice& choice_;
    std::span<const BorderSegment> borders_;
    std::span<const IsolineSegment> isolines_;
    std::vector<Segment>& to_;
    InstanceView view_;
    const MeshEye& eye_;
    std::optional<SurfaceContours> exact_;  // where the faces have surfaces
    std::uint32_t joints_ = 0;              // within triangles, of exact contours
    FoundContours contours_;
    std::vector<bool> isSmooth_;               // one per contour edge: whether its faces are one smooth surface
    std::vector<bool> smooth_;                 // one per patch
    std::vector<double> viewDots_;             // one per position: n . (x - C)
    std::unordered_set<std::uint32_t> large_;  // faces at contour edges
    std::unordered_set<std::uint32_t> largePoints_;
};

}  // namespace

void collectInstanceCurves(const Scene& scene, std::uint32_t instance, const InstanceEdges& edges,
                           ContourMemory& memory, const Screen& screen, const CurveChoice& choice,
                           std::vector<Segment>& to) {
    InstanceCurves{scene, instance, edges, screen, choice, to}.collect(memory);
}

}  // namespace inkedge::lines
