#include "lines/find/contours.h"

#include <algorithm>
#include <cmath>
#include <unordered_set>

#include <glm/geometric.hpp>

#include "lines/find/beside_edge.h"
#include "lines/find/instance_view.h"
#include "lines/find/smooth_contours.h"
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
          eye_{view_.eye} {}

    void collect(ContourMemory& memory) {
        if (view_.scale == 0.0) return;
        contours_ = search_.find(eye_, choice_.finder, memory);
        for (const std::uint32_t e : contours_.edges) isSmooth_.push_back(!isSplit(mesh_, topology_, edges_, e));
        chooseSmoothPatches();
        if (choice_.contour == Contour::Auto && surfacesOf(mesh_, choice_) == nullptr) findLargeFaces();
        addContourEdges();
        addCreases();
        addBorders();
        addMany();
        addIsolines();
        if (std::ranges::find(smooth_, true) != smooth_.end())
            addSmoothContours({instance_, mesh_, topology_, edges_, screen_, choice_, view_, smooth_, large_}, to_);
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
        const bool refined = surfacesOf(mesh_, choice_) != nullptr && choice_.contour != Contour::Mesh;
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
               longestEdge(mesh_, t) * view_.scale > largeEdge * screen_.footprint(corner);
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
    FoundContours contours_;
    std::vector<bool> isSmooth_;               // one per contour edge: whether its faces are one smooth surface
    std::vector<bool> smooth_;                 // one per patch
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
