#include "mesh/subdivision.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <span>
#include <utility>

#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/sdc/catmarkScheme.h>
#include <opensubdiv/sdc/loopScheme.h>
#include <glm/geometric.hpp>

#include <inkedge/export.h>

#include "mesh/opensubdiv_limit.h"
#include "mesh/opensubdiv_refiner.h"
#include "modules/failure.h"

namespace inkedge::mesh {
namespace {

namespace Far = OpenSubdiv::Far;
namespace Sdc = OpenSubdiv::Sdc;

// A value of which OpenSubdiv computes weighted sums.
template <class Vector>
struct Mixed {
    Vector v{0.0};
    void Clear(void* = nullptr) { v = Vector{0.0}; }
    void AddWithWeight(const Mixed& from, double weight) { v += weight * from.v; }
};
using Point = Mixed<glm::dvec3>;

std::vector<Point> positionsOfLastLevel(const Far::TopologyRefiner& refiner, const ControlMesh& control) {
    const Far::PrimvarRefinerReal<double> primvars{refiner};
    std::vector<Point> points(control.positions.size());
    std::ranges::transform(control.positions, points.begin(), [](glm::dvec3 p) { return Point{p}; });
    for (int level = 1; level <= refiner.GetMaxLevel(); ++level) {
        std::vector<Point> next(static_cast<std::size_t>(refiner.GetLevel(level).GetNumVertices()));
        primvars.Interpolate(level, points, next);
        points = std::move(next);
    }
    return points;
}

// The faces between two sharp edges that meet at a vertex, as a border's vertex for Sdc.
class Sector {
public:
    explicit Sector(int edges) : edges_{edges} {}
    [[nodiscard]] int GetNumEdges() const { return edges_; }
    [[nodiscard]] int GetNumFaces() const { return edges_ - 1; }
    void GetSharpnessPerEdge(float sharpness[]) const {
        std::fill_n(sharpness, edges_, Sdc::Crease::SHARPNESS_SMOOTH);
        sharpness[0] = sharpness[edges_ - 1] = Sdc::Crease::SHARPNESS_INFINITE;
    }

private:
    int edges_;
};

// Weights of a vertex, of its edges' other ends and of its faces.
class Mask {
public:
    using Weight = double;
    explicit Mask(int edges)
        : edgeWeights_(static_cast<std::size_t>(edges)), faceWeights_(static_cast<std::size_t>(edges)) {}

    [[nodiscard]] static int GetNumVertexWeights() { return 1; }
    [[nodiscard]] int GetNumEdgeWeights() const { return edges_; }
    [[nodiscard]] int GetNumFaceWeights() const { return faces_; }
    void SetNumVertexWeights(int) {}
    void SetNumEdgeWeights(int n) { edges_ = n; }
    void SetNumFaceWeights(int n) { faces_ = n; }
    [[nodiscard]] Weight& VertexWeight(int) { return vertexWeight_; }
    [[nodiscard]] Weight& EdgeWeight(int i) { return edgeWeights_[static_cast<std::size_t>(i)]; }
    [[nodiscard]] Weight& FaceWeight(int i) { return faceWeights_[static_cast<std::size_t>(i)]; }
    [[nodiscard]] static bool AreFaceWeightsForFaceCenters() { return false; }
    void SetFaceWeightsForFaceCenters(bool) {}

    [[nodiscard]] glm::dvec3 apply(glm::dvec3 vertex, std::span<const glm::dvec3> acrossEdges,
                                   std::span<const glm::dvec3> acrossFaces) const {
        glm::dvec3 sum = vertexWeight_ * vertex;
        for (std::size_t i = 0; i < static_cast<std::size_t>(edges_) && i < acrossEdges.size(); ++i)
            sum += edgeWeights_[i] * acrossEdges[i];
        for (std::size_t i = 0; i < static_cast<std::size_t>(faces_) && i < acrossFaces.size(); ++i)
            sum += faceWeights_[i] * acrossFaces[i];
        return sum;
    }

private:
    Weight vertexWeight_ = 0.0;
    std::vector<Weight> edgeWeights_;
    std::vector<Weight> faceWeights_;
    int edges_ = 0;
    int faces_ = 0;
};

// Limit positions and normals of the last level's vertices, which are split where sharp edges separate their faces.
class LastLevel {
public:
    LastLevel(const Far::TopologyRefiner& refiner, const ControlMesh& control)
        : loop_{control.scheme == SubdivisionScheme::Loop},
          level_{refiner.GetLevel(refiner.GetMaxLevel())},
          points_{positionsOfLastLevel(refiner, control)},
          limits_(points_.size()),
          tangents1_(points_.size()),
          tangents2_(points_.size()) {
        Far::PrimvarRefinerReal<double>{refiner}.Limit(points_, limits_, tangents1_, tangents2_);
    }

    [[nodiscard]] RefinedFaces faces() {
        const int size = loop_ ? 3 : 4;
        const auto count = static_cast<std::size_t>(level_.GetNumFaces());
        result_.positions.reserve(points_.size());
        result_.normals.reserve(points_.size());
        result_.corners.resize(count * static_cast<std::size_t>(size));
        result_.creases.resize(result_.corners.size());
        for (int v = 0; v < level_.GetNumVertices(); ++v) addVertex(v);
        for (int f = 0; f < level_.GetNumFaces(); ++f) {
            const auto edges = level_.GetFaceEdges(f);
            for (int k = 0; k < size; ++k) result_.creases[cornerOf(f, k)] = isSharp(edges[k]);
        }
        return std::move(result_);
    }

private:
    [[nodiscard]] std::size_t cornerOf(int face, int k) const {
        return static_cast<std::size_t>(face) * (loop_ ? 3U : 4U) + static_cast<std::size_t>(k);
    }
    [[nodiscard]] bool isSharp(int edge) const {
        return level_.IsEdgeBoundary(edge) || level_.IsEdgeInfSharp(edge) || level_.IsEdgeNonManifold(edge);
    }
    [[nodiscard]] glm::dvec3 pointAt(int vertex) const { return points_[static_cast<std::size_t>(vertex)].v; }

    // Twice the area of the face's corner, along its normal.
    [[nodiscard]] glm::dvec3 cornerNormal(int face, int k) const {
        const auto vertices = level_.GetFaceVertices(face);
        const int n = vertices.size();
        const glm::dvec3 at = pointAt(vertices[k]);
        return glm::cross(pointAt(vertices[(k + 1) % n]) - at, pointAt(vertices[(k + n - 1) % n]) - at);
    }

    void addVertex(int v) {
        const auto faces = level_.GetVertexFaces(v);
        const int faceCount = faces.size();
        if (faceCount == 0) return;
        if (level_.IsVertexNonManifold(v)) {  // its faces have no order around it
            for (int i = 0; i < faceCount; ++i) addSplit(v, i, 1, glm::dvec3{0.0});
            return;
        }
        const Sdc::Crease::Rule rule = level_.GetVertexRule(v);
        const std::vector<int> sharp = sharpEdges(v);
        // A sharp edge that ends within the surface neither separates faces at its end nor bends the surface there.
        if (rule == Sdc::Crease::RULE_SMOOTH || rule == Sdc::Crease::RULE_DART || sharp.size() < 2) {
            const auto i = static_cast<std::size_t>(v);
            addSplit(v, 0, faceCount, glm::cross(tangents1_[i].v, tangents2_[i].v));
            return;
        }
        const int edgeCount = level_.GetVertexEdges(v).size();
        const bool closed = edgeCount == faceCount;
        for (std::size_t i = 0; i + (closed ? 0 : 1) < sharp.size(); ++i) {
            const int to = i + 1 < sharp.size() ? sharp[i + 1] : sharp[0] + edgeCount;
            addSplit(v, sharp[i], to - sharp[i], sectorNormal(v, sharp[i], to, rule));
        }
    }

    // Indices of the sharp edges in the order of edges around the vertex, ascending.
    [[nodiscard]] std::vector<int> sharpEdges(int v) const {
        std::vector<int> sharp;
        const auto edges = level_.GetVertexEdges(v);
        for (int i = 0; i < edges.size(); ++i)
            if (isSharp(edges[i])) sharp.push_back(i);
        return sharp;
    }

    // Zero where the sector ends in a corner: the faces there are not smooth.
    [[nodiscard]] glm::dvec3 sectorNormal(int v, int from, int to, Sdc::Crease::Rule rule) const {
        if (rule != Sdc::Crease::RULE_CREASE) return glm::dvec3{0.0};
        const auto edges = level_.GetVertexEdges(v);
        const auto faces = level_.GetVertexFaces(v);
        const auto indicesInFaces = level_.GetVertexFaceLocalIndices(v);
        std::vector<glm::dvec3> acrossEdges;
        std::vector<glm::dvec3> acrossFaces;
        for (int i = from; i <= to; ++i) {
            const auto ends = level_.GetEdgeVertices(edges[i % edges.size()]);
            acrossEdges.push_back(pointAt(ends[0] == v ? ends[1] : ends[0]));
        }
        for (int i = from; i < to && !loop_; ++i) {
            const auto corners = level_.GetFaceVertices(faces[i % faces.size()]);
            acrossFaces.push_back(pointAt(corners[(indicesInFaces[i % faces.size()] + 2) % corners.size()]));
        }
        const Sector sector{to - from + 1};
        Mask position{to - from + 1};
        Mask tangent1{to - from + 1};
        Mask tangent2{to - from + 1};
        if (loop_) {
            Sdc::Scheme<Sdc::SCHEME_LOOP>{}.ComputeVertexLimitMask(sector, position, tangent1, tangent2, rule);
        } else {
            Sdc::Scheme<Sdc::SCHEME_CATMARK>{}.ComputeVertexLimitMask(sector, position, tangent1, tangent2, rule);
        }
        return glm::cross(tangent1.apply(pointAt(v), acrossEdges, acrossFaces),
                          tangent2.apply(pointAt(v), acrossEdges, acrossFaces));
    }

    // Adds a vertex for some of the faces around v, in their order. Where the limit surface has no normal, the mean of
    // the faces' normals is taken.
    void addSplit(int v, int from, int count, glm::dvec3 normal) {
        const auto faces = level_.GetVertexFaces(v);
        const auto indicesInFaces = level_.GetVertexFaceLocalIndices(v);
        glm::dvec3 ofFaces{0.0};
        for (int i = from; i < from + count; ++i) {
            const int at = i % faces.size();
            ofFaces += cornerNormal(faces[at], indicesInFaces[at]);
            result_.corners[cornerOf(faces[at], indicesInFaces[at])] =
                static_cast<std::uint32_t>(result_.positions.size());
        }
        // Where the surface turns over in a cusp the two tangents of the limit may be in reverse order.
        if (glm::dot(normal, ofFaces) < 0.0) normal = -normal;
        const double tiny = 1e-9 * glm::length(ofFaces);
        if (!(glm::length(normal) > tiny)) normal = ofFaces;
        const double length = glm::length(normal);
        result_.positions.push_back(limits_[static_cast<std::size_t>(v)].v);
        result_.normals.push_back(length > 0.0 ? normal / length : glm::dvec3{0.0, 0.0, 1.0});
    }

    bool loop_;
    const Far::TopologyLevel& level_;
    std::vector<Point> points_;
    std::vector<Point> limits_;
    std::vector<Point> tangents1_;
    std::vector<Point> tangents2_;
    RefinedFaces result_;
};

// Values of the last level's corners, from those of the control mesh's corners.
template <class Vector, class Value, class Part>
std::vector<Vector> refinedValues(const Far::TopologyRefiner& refiner, const std::vector<Value>& ofCorners, Part part) {
    if (ofCorners.empty()) return {};
    const Far::PrimvarRefinerReal<double> primvars{refiner};
    std::vector<Mixed<Vector>> values(ofCorners.size());
    std::ranges::transform(ofCorners, values.begin(), [&](const Value& v) { return Mixed<Vector>{Vector{part(v)}}; });
    for (int level = 1; level <= refiner.GetMaxLevel(); ++level) {
        std::vector<Mixed<Vector>> next(static_cast<std::size_t>(refiner.GetLevel(level).GetNumFVarValues()));
        primvars.InterpolateFaceVarying(level, values, next);
        values = std::move(next);
    }
    const Far::TopologyLevel& last = refiner.GetLevel(refiner.GetMaxLevel());
    std::vector<Vector> refined;
    for (int f = 0; f < last.GetNumFaces(); ++f) {
        const auto corners = last.GetFaceFVarValues(f);
        for (int k = 0; k < corners.size(); ++k) refined.push_back(values[static_cast<std::size_t>(corners[k])].v);
    }
    return refined;
}

std::vector<glm::vec2> refinedCoordinates(const Far::TopologyRefiner& refiner, const ControlMesh& control) {
    const auto refined = refinedValues<glm::dvec2>(refiner, control.coordinates, std::identity{});
    return {refined.begin(), refined.end()};
}

std::vector<VertexPaint> refinedPaint(const Far::TopologyRefiner& refiner, const ControlMesh& control) {
    const auto colors = refinedValues<glm::dvec4>(refiner, control.paint, [](const VertexPaint& p) { return p.color; });
    const auto uvs = refinedValues<glm::dvec2>(refiner, control.paint, [](const VertexPaint& p) { return p.uv; });
    std::vector<VertexPaint> paint;
    paint.reserve(colors.size());
    for (std::size_t c = 0; c < colors.size(); ++c) paint.push_back({glm::vec4{colors[c]}, glm::vec2{uvs[c]}});
    return paint;
}

// The kinds of the last level's edges: the parts of an edge keep its kinds.
std::vector<EdgeKinds> refinedEdges(const Far::TopologyRefiner& refiner, const ControlMesh& control) {
    if (control.edges.empty()) return {};
    const Far::TopologyLevel& first = refiner.GetLevel(0);
    std::vector<EdgeKinds> kinds(static_cast<std::size_t>(first.GetNumEdges()));
    std::size_t corner = 0;
    for (int f = 0; f < first.GetNumFaces(); ++f) {
        const auto edges = first.GetFaceEdges(f);
        for (int k = 0; k < edges.size(); ++k) kinds[static_cast<std::size_t>(edges[k])] |= control.edges[corner++];
    }
    for (int level = 0; level < refiner.GetMaxLevel(); ++level) {
        std::vector<EdgeKinds> next(static_cast<std::size_t>(refiner.GetLevel(level + 1).GetNumEdges()));
        for (int e = 0; e < refiner.GetLevel(level).GetNumEdges(); ++e) {
            const EdgeKinds its = kinds[static_cast<std::size_t>(e)];
            if (its.empty()) continue;
            const auto children = refiner.GetLevel(level).GetEdgeChildEdges(e);
            for (int k = 0; k < children.size(); ++k) next[static_cast<std::size_t>(children[k])] = its;
        }
        kinds = std::move(next);
    }
    const Far::TopologyLevel& last = refiner.GetLevel(refiner.GetMaxLevel());
    std::vector<EdgeKinds> ofCorners;
    for (int f = 0; f < last.GetNumFaces(); ++f) {
        const auto edges = last.GetFaceEdges(f);
        for (int k = 0; k < edges.size(); ++k) ofCorners.push_back(kinds[static_cast<std::size_t>(edges[k])]);
    }
    return ofCorners;
}

std::vector<std::uint32_t> controlFaces(const Far::TopologyRefiner& refiner) {
    std::vector<std::uint32_t> faces(static_cast<std::size_t>(refiner.GetLevel(refiner.GetMaxLevel()).GetNumFaces()));
    for (std::size_t f = 0; f < faces.size(); ++f) {
        int parent = static_cast<int>(f);
        for (int level = refiner.GetMaxLevel(); level > 0; --level)
            parent = refiner.GetLevel(level).GetFaceParentFace(parent);
        faces[f] = static_cast<std::uint32_t>(parent);
    }
    return faces;
}

RefinedFaces refine(const ControlMesh& control, int levels) {
    const Refiner refiner = makeRefiner(control);
    Far::TopologyRefiner::UniformOptions options{levels};
    options.fullTopologyInLastLevel = true;
    refiner->RefineUniform(options);
    RefinedFaces faces = LastLevel{*refiner, control}.faces();
    faces.parents = controlFaces(*refiner);
    faces.coordinates = refinedCoordinates(*refiner, control);
    faces.paint = refinedPaint(*refiner, control);
    faces.edges = refinedEdges(*refiner, control);
    return faces;
}

}  // namespace

extern "C" INKEDGE_API const Subdivision* inkedge_subdivision_5() noexcept {
    static constexpr Subdivision functions{
        [](const ControlMesh& control, int levels) {
            return modules::guarded([&] { return refine(control, levels); });
        },
        [](const ControlMesh& control) {
            return modules::guarded([&] { return MadeLimitSurface{limitSurface(control), {}}; });
        }};
    return &functions;
}

}  // namespace inkedge::mesh
