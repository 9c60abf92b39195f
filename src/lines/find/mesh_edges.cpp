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

// Collects the half-edges of edges that many faces share. Those of one edge follow each other.
void collectMany(const mesh::MeshTopology& topology, MeshEdges& edges) {
    auto& many = edges.many;
    for (std::uint32_t h = 0; h < topology.twins.size(); ++h)
        if (topology.twins[h] == mesh::manyHalfEdges) many.push_back(h);
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

// Adds an edge that two faces share. If thin faces lie between them it looks for the two faces beyond, and whether they
// meet in a crease.
void addShared(const Mesh& mesh, const mesh::MeshTopology& topology, std::uint32_t h, double creaseCosine,
               MeshEdges& edges) {
    const std::uint32_t twin = topology.twins[h];
    const auto isThin = [&](std::uint32_t t) { return edges.faceNormals[t] == glm::dvec3{0.0}; };
    bool against = topology.points[h] == topology.points[twin];
    bool crease = topology.creases[h];
    std::uint32_t first = h / 3;
    std::uint32_t second = twin / 3;
    if (isThin(first) || isThin(second)) {
        const Whole a = wholeOf(mesh, topology, edges.faceNormals, first);
        const Whole b = wholeOf(mesh, topology, edges.faceNormals, second);
        first = a.face;
        second = b.face;
        if (first == second) return;
        against = against != (a.against != b.against);
        const double cosine = glm::dot(edges.faceNormals[first], edges.faceNormals[second]);
        const bool bends = !isThin(first) && !isThin(second) && (against ? -cosine : cosine) < creaseCosine;
        crease = mesh::isOfKind(mesh, h, twin, EdgeKind::Sharp) || (bends && !mesh::isSmoothByKind(mesh, h, twin));
    }
    MeshEdges::Shared& shared = edges.shared;
    const auto number = static_cast<std::uint32_t>(shared.halfEdges.size());
    if (crease)
        edges.creases.push_back(number);
    else if (isMarked(mesh, topology, h))
        edges.marked.push_back(number);
    else if (mesh::isOfKind(mesh, h, twin, EdgeKind::Tangent))
        edges.tangents.push_back(number);
    shared.faces.push_back(first);
    shared.faces.push_back(second);
    shared.halfEdges.push_back(h);
    shared.against.push_back(against ? 1 : 0);
    shared.split.push_back(crease || !sameNormals(mesh, topology, h, twin) ? 1 : 0);
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
    for (std::uint32_t h = 0; h < topology.twins.size(); ++h) {
        if (mesh::isHalfEdge(topology.twins[h]) && h < topology.twins[h])
            addShared(mesh, topology, h, creaseCosine, edges);
        const bool thin = topology.twins[h] == mesh::noHalfEdge && edges.faceNormals[h / 3] == glm::dvec3{0.0};
        if (thin && takesPart(topology, h / 3)) edges.thinBorders.push_back(h);
    }
    collectMany(topology, edges);
    edges.closed = mesh::componentOrientations(mesh, topology);
    return edges;
}

}  // namespace inkedge::lines
