#include "lines/find/mesh_edges.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "base/parallel.h"
#include "mesh/closed_surface.h"

namespace inkedge::lines {

bool isMarked(const Mesh& mesh, const mesh::MeshTopology& topology, std::uint32_t halfEdge) {
    return mesh::isOfKind(mesh, halfEdge, topology.twins[halfEdge], EdgeKind::Marked);
}

namespace {

bool takesPart(const mesh::MeshTopology& topology, std::uint32_t t) {
    const std::uint32_t* const p = &topology.points[3 * std::size_t{t}];
    return topology.originals[t] == t && p[0] != p[1] && p[1] != p[2] && p[2] != p[0];
}

bool sameNormals(const Mesh& mesh, const mesh::MeshTopology& topology, std::uint32_t halfEdge, std::uint32_t twin) {
    constexpr float same = 0.9999F;  // cosine of an angle under a degree
    const mesh::TwinEnds ends = mesh::endsOfTwin(topology, halfEdge, twin);
    const auto agree = [&](std::uint32_t a, std::uint32_t b) {
        if (mesh.indices[a] == mesh.indices[b]) return true;
        return glm::dot(mesh.normals[mesh.indices[a]], mesh.normals[mesh.indices[b]]) > same;
    };
    return agree(halfEdge, ends.atStart) && agree(mesh::nextHalfEdge(halfEdge), ends.atEnd);
}

// Sorts the half-edges of edges that many faces share. Those of one edge follow each other.
void sortMany(const mesh::MeshTopology& topology, MeshEdges& edges) {
    auto& many = edges.many;
    const auto ends = [&](std::uint32_t h) {
        return std::minmax(topology.points[h], topology.points[mesh::nextHalfEdge(h)]);
    };
    std::ranges::sort(many, [&](std::uint32_t a, std::uint32_t b) {
        const auto ea = ends(a);
        const auto eb = ends(b);
        if (ea.first != eb.first) return ea.first < eb.first;
        if (ea.second != eb.second) return ea.second < eb.second;
        return a < b;
    });
    for (std::uint32_t i = 0; i < many.size(); ++i)
        if (i == 0 || ends(many[i]) != ends(many[i - 1])) edges.manyBegins.push_back(i);
    edges.manyBegins.push_back(static_cast<std::uint32_t>(many.size()));
}

// The face that a thin face is a part of.
struct Whole {
    std::uint32_t face;
    bool against = false;  // whether the face is wound against the thin one
};

Whole wholeOf(const Mesh& mesh, const mesh::MeshTopology& topology, const std::vector<glm::dvec3>& normals,
              std::uint32_t t) {
    constexpr int maxThin = 32;  // thin faces in a row
    Whole whole{t};
    const auto length = [&](std::uint32_t h) {
        return glm::distance(glm::dvec3{mesh.positions[mesh.indices[mesh::nextHalfEdge(h)]]},
                             glm::dvec3{mesh.positions[mesh.indices[h]]});
    };
    std::uint32_t entry = mesh::noHalfEdge;
    for (int step = 0; step < maxThin && normals[whole.face] == glm::dvec3{0.0}; ++step) {
        std::uint32_t longest = mesh::noHalfEdge;
        for (std::uint32_t h = 3 * whole.face; h < 3 * whole.face + 3; ++h) {
            if (!mesh::isHalfEdge(topology.twins[h]) || h == entry) continue;
            if (longest == mesh::noHalfEdge || length(h) > length(longest)) longest = h;
        }
        if (longest == mesh::noHalfEdge) break;
        entry = topology.twins[longest];
        if (topology.points[longest] == topology.points[entry]) whole.against = !whole.against;
        whole.face = entry / 3;
    }
    return whole;
}

// Collects the edges of a range of half-edges.
class EdgeCollector {
public:
    EdgeCollector(const Mesh& mesh, const mesh::MeshTopology& topology, const std::vector<glm::dvec3>& normals,
                  const std::vector<float>& edgeOnSines, double creaseCosine)
        : mesh_{mesh}, topology_{topology}, normals_{normals}, sines_{edgeOnSines}, creaseCosine_{creaseCosine} {}

    [[nodiscard]] MeshEdges collect(std::uint32_t begin, std::uint32_t end) const {
        MeshEdges edges;
        edges.shared.halfEdges.reserve((end - begin) / 2);
        edges.shared.faces.reserve(end - begin);
        edges.shared.against.reserve((end - begin) / 2);
        for (std::uint32_t h = begin; h < end; ++h) {
            const std::uint32_t twin = topology_.twins[h];
            if (mesh::isHalfEdge(twin)) {
                if (h < twin) addShared(h, twin, edges);
            } else if (twin == mesh::manyHalfEdges) {
                edges.many.push_back(h);
            } else if (isThin(h / 3) && takesPart(topology_, h / 3)) {
                edges.thinBorders.push_back(h);
            }
        }
        return edges;
    }

private:
    [[nodiscard]] bool isThin(std::uint32_t t) const { return sines_[t] < 0.0F; }

    // If thin faces lie beside the edge, looks for the two faces beyond, and whether they meet in a crease.
    void addShared(std::uint32_t h, std::uint32_t twin, MeshEdges& edges) const {
        bool against = topology_.points[h] == topology_.points[twin];
        bool crease = topology_.creases[h];
        std::uint32_t first = h / 3;
        std::uint32_t second = twin / 3;
        if (isThin(first) || isThin(second)) {
            const Whole a = wholeOf(mesh_, topology_, normals_, first);
            const Whole b = wholeOf(mesh_, topology_, normals_, second);
            first = a.face;
            second = b.face;
            if (first == second) return;
            against = against != (a.against != b.against);
            const double cosine = glm::dot(normals_[first], normals_[second]);
            const bool bends = !isThin(first) && !isThin(second) && (against ? -cosine : cosine) < creaseCosine_;
            crease =
                mesh::isOfKind(mesh_, h, twin, EdgeKind::Sharp) || (bends && !mesh::isSmoothByKind(mesh_, h, twin));
        }
        MeshEdges::Shared& shared = edges.shared;
        const auto number = static_cast<std::uint32_t>(shared.halfEdges.size());
        if (crease)
            edges.creases.push_back(number);
        else if (isMarked(mesh_, topology_, h))
            edges.marked.push_back(number);
        else if (mesh::isOfKind(mesh_, h, twin, EdgeKind::Tangent))
            edges.tangents.push_back(number);
        shared.faces.push_back(first);
        shared.faces.push_back(second);
        shared.halfEdges.push_back(h);
        shared.against.push_back(against ? 1 : 0);
    }

    const Mesh& mesh_;
    const mesh::MeshTopology& topology_;
    const std::vector<glm::dvec3>& normals_;
    const std::vector<float>& sines_;
    double creaseCosine_;
};

// Adds the edges that were collected from the next range.
void append(MeshEdges&& part, MeshEdges& to) {
    const auto first = static_cast<std::uint32_t>(to.shared.halfEdges.size());
    const auto addAll = [](auto&& from, auto& all) {
        if (all.empty())
            all = std::move(from);
        else
            all.insert(all.end(), from.begin(), from.end());
    };
    for (auto numbers : {&MeshEdges::creases, &MeshEdges::marked, &MeshEdges::tangents}) {
        for (std::uint32_t& number : part.*numbers) number += first;
        addAll(std::move(part.*numbers), to.*numbers);
    }
    addAll(std::move(part.shared.faces), to.shared.faces);
    addAll(std::move(part.shared.halfEdges), to.shared.halfEdges);
    addAll(std::move(part.shared.against), to.shared.against);
    addAll(std::move(part.many), to.many);
    addAll(std::move(part.thinBorders), to.thinBorders);
}

// A corner that is off by an error tilts its face by up to the error through the face's height there.
std::vector<float> edgeOnSinesOf(const Mesh& mesh, const std::vector<glm::dvec3>& normals) {
    constexpr float sixDigits = 5e-6F;  // of the largest coordinate: what most programs write by default
    constexpr float largest = 1e-3F;    // slivers have no smaller angle, but are seen at all others
    float reach = 0.0F;
    for (const glm::vec3 p : mesh.positions) reach = std::max({reach, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    std::vector<float> sines(normals.size());
    base::inRanges(sines.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t) {
            const std::uint32_t* const i = &mesh.indices[3 * t];
            const glm::vec3 a = (mesh.positions[i[1]] - mesh.positions[i[0]]) / reach;
            const glm::vec3 b = (mesh.positions[i[2]] - mesh.positions[i[0]]) / reach;
            const float longest = std::max({glm::dot(a, a), glm::dot(b, b), glm::dot(b - a, b - a)});
            const glm::vec3 cross = glm::cross(a, b);
            const float area = std::sqrt(glm::dot(cross, cross));  // of both the face and its mirror image
            const float error = sixDigits * std::sqrt(longest);
            sines[t] = normals[t] == glm::dvec3{0.0} ? -1.0F : error < largest * area ? error / area : largest;
        }
    });
    return sines;
}

}  // namespace

bool isSplit(const Mesh& mesh, const mesh::MeshTopology& topology, const MeshEdges& edges, std::uint32_t edge) {
    const std::uint32_t h = edges.shared.halfEdges[edge];
    return std::ranges::binary_search(edges.creases, edge) || !sameNormals(mesh, topology, h, topology.twins[h]);
}

MeshEdges findEdges(const Mesh& mesh, const mesh::MeshTopology& topology, double creaseAngle) {
    const double creaseCosine = std::cos(glm::radians(creaseAngle));
    MeshEdges edges;
    edges.faceNormals = mesh::makeFaceNormals(mesh, topology);
    edges.edgeOnSines = edgeOnSinesOf(mesh, edges.faceNormals);
    edges.normalSines.resize(mesh.positions.size(), 0.0F);
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        float& sine = edges.normalSines[mesh.indices[i]];
        sine = std::max(sine, edges.edgeOnSines[i / 3]);
    }
    const EdgeCollector collector{mesh, topology, edges.faceNormals, edges.edgeOnSines, creaseCosine};
    for (MeshEdges& part : base::partsOf(topology.twins.size(), [&](std::size_t begin, std::size_t end) {
             return collector.collect(static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end));
         }))
        append(std::move(part), edges);
    sortMany(topology, edges);
    edges.closed = mesh::componentOrientations(mesh, topology);
    return edges;
}

}  // namespace inkedge::lines
