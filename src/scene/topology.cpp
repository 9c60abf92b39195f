#include "scene/topology.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "scene/union_find.h"
#include "scene/weld.h"

namespace inkedge {
namespace {

constexpr std::uint32_t none = ~0U;

std::array<std::uint32_t, 3> sortedPoints(const MeshTopology& topology, std::uint32_t t) {
    std::array p{topology.points[3 * t], topology.points[3 * t + 1], topology.points[3 * t + 2]};
    std::ranges::sort(p);
    return p;
}

// For each triangle the first one with the same three points: itself, unless it repeats another.
std::vector<std::uint32_t> firstOfItsKind(const MeshTopology& topology) {
    const auto count = static_cast<std::uint32_t>(topology.points.size() / 3);
    std::vector<std::uint32_t> first(count);
    std::vector<std::uint32_t> slots(std::bit_ceil(2 * static_cast<std::size_t>(count) + 1), none);
    const std::uint64_t mask = slots.size() - 1;
    for (std::uint32_t t = 0; t < count; ++t) {
        const auto key = sortedPoints(topology, t);
        std::uint64_t h = 0;
        for (const std::uint32_t p : key) h = (h ^ p) * 0x9E3779B97F4A7C15U, h ^= h >> 29U;
        std::uint64_t slot = h & mask;
        while (slots[slot] != none && sortedPoints(topology, slots[slot]) != key) slot = (slot + 1) & mask;
        if (slots[slot] == none) slots[slot] = t;
        first[t] = slots[slot];
    }
    return first;
}

bool collapsed(const MeshTopology& topology, std::uint32_t t) {
    const auto p = sortedPoints(topology, t);
    return p[0] == p[1] || p[1] == p[2];
}

std::vector<std::uint32_t> twinHalfEdges(const MeshTopology& topology) {
    struct Entry {
        std::uint32_t greaterPoint;
        std::uint32_t halfEdge;
    };
    const auto& points = topology.points;
    const auto ends = [&](std::uint32_t h) { return std::minmax(points[h], points[nextHalfEdge(h)]); };
    const auto forEachHalfEdge = [&](auto&& visit) {
        for (std::uint32_t t = 0; t < topology.originals.size(); ++t) {
            if (topology.originals[t] != t || collapsed(topology, t)) continue;
            for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) visit(h);
        }
    };

    // Counting sort by the lesser point; the few edges that share it are then sorted by the greater one.
    std::vector<std::uint32_t> begin(topology.pointCount + 1, 0);
    forEachHalfEdge([&](std::uint32_t h) { ++begin[ends(h).first + 1]; });
    for (std::uint32_t p = 0; p < topology.pointCount; ++p) begin[p + 1] += begin[p];
    std::vector<Entry> entries(begin.back());
    std::vector<std::uint32_t> fill(begin.begin(), begin.end() - 1);
    forEachHalfEdge([&](std::uint32_t h) { entries[fill[ends(h).first]++] = {ends(h).second, h}; });

    std::vector<std::uint32_t> twins(points.size(), noHalfEdge);
    for (std::uint32_t p = 0; p < topology.pointCount; ++p) {
        const auto from = entries.begin() + begin[p];
        const auto to = entries.begin() + begin[p + 1];
        std::sort(from, to, [](const Entry& a, const Entry& b) {
            return a.greaterPoint != b.greaterPoint ? a.greaterPoint < b.greaterPoint : a.halfEdge < b.halfEdge;
        });
        for (auto run = from; run != to;) {
            const auto end = std::find_if(run, to, [&](const Entry& e) { return e.greaterPoint != run->greaterPoint; });
            if (end - run == 2) {
                twins[run[0].halfEdge] = run[1].halfEdge;
                twins[run[1].halfEdge] = run[0].halfEdge;
            } else if (end - run > 2) {
                std::for_each(run, end, [&](const Entry& e) { twins[e.halfEdge] = manyHalfEdges; });
            }
            run = end;
        }
    }
    return twins;
}

std::vector<glm::dvec3> faceNormals(const Mesh& mesh, double thin) {
    std::vector<glm::dvec3> normals(mesh.indices.size() / 3);
    for (std::size_t t = 0; t < normals.size(); ++t) {
        const glm::dvec3 a{mesh.positions[mesh.indices[3 * t]]};
        const glm::dvec3 b{mesh.positions[mesh.indices[3 * t + 1]]};
        const glm::dvec3 c{mesh.positions[mesh.indices[3 * t + 2]]};
        const glm::dvec3 area = glm::cross(b - a, c - a);
        const double length = glm::length(area);
        const double longest = std::max({glm::length(b - a), glm::length(c - b), glm::length(a - c)});
        normals[t] = length > thin * longest ? area / length : glm::dvec3{0.0};
    }
    return normals;
}

// The corners of two half-edges that meet at the first one's start and at its end.
struct SharedEnds {
    std::uint32_t atStart;
    std::uint32_t atEnd;
};

SharedEnds endsOfTwin(const MeshTopology& topology, std::uint32_t halfEdge, std::uint32_t twin) {
    const bool opposite = topology.points[halfEdge] != topology.points[twin];
    return opposite ? SharedEnds{nextHalfEdge(twin), twin} : SharedEnds{twin, nextHalfEdge(twin)};
}

bool normalsSplit(const Mesh& mesh, const MeshTopology& topology, std::uint32_t halfEdge, std::uint32_t twin,
                  double creaseCosine) {
    const auto split = [&](std::uint32_t a, std::uint32_t b) {
        // Normals wound against each other may point to opposite sides of one surface.
        const double cosine =
            static_cast<double>(glm::dot(mesh.normals[mesh.indices[a]], mesh.normals[mesh.indices[b]]));
        return (topology.points[halfEdge] == topology.points[twin] ? -cosine : cosine) < creaseCosine;
    };
    const SharedEnds ends = endsOfTwin(topology, halfEdge, twin);
    return split(halfEdge, ends.atStart) && split(nextHalfEdge(halfEdge), ends.atEnd);
}

bool hasNormal(const MeshTopology& topology, std::uint32_t t) { return topology.faceNormals[t] != glm::dvec3{0.0}; }

// A face that is too thin only connects: its neighbours are joined as if they touched each other.
void joinAcrossThinFace(const MeshTopology& topology, std::uint32_t t, double creaseCosine, UnionFind& sets) {
    for (std::uint32_t i = 3 * t; i < 3 * t + 3; ++i) {
        const std::uint32_t a = topology.twins[i];
        if (!isHalfEdge(a)) continue;
        sets.unite(t, a / 3);
        for (std::uint32_t j = i + 1; j < 3 * t + 3; ++j) {
            const std::uint32_t b = topology.twins[j];
            if (!isHalfEdge(b)) continue;
            const double cosine = std::abs(glm::dot(topology.faceNormals[a / 3], topology.faceNormals[b / 3]));
            if (cosine >= creaseCosine) sets.unite(a / 3, b / 3);
        }
    }
}

}  // namespace

void turnOver(Mesh& mesh, std::size_t first) {
    std::swap(mesh.indices[first + 1], mesh.indices[first + 2]);
    if (mesh.innerEdges.empty()) return;
    const bool edge = mesh.innerEdges[first];
    mesh.innerEdges[first] = mesh.innerEdges[first + 2];
    mesh.innerEdges[first + 2] = edge;
}

double bendCosine(const MeshTopology& topology, std::uint32_t halfEdge, std::uint32_t twin) {
    const double cosine = glm::dot(topology.faceNormals[halfEdge / 3], topology.faceNormals[twin / 3]);
    return topology.points[halfEdge] == topology.points[twin] ? -cosine : cosine;
}

MeshTopology buildTopology(const Mesh& mesh) {
    MeshTopology topology;
    const Weld weld = weldByPosition(mesh.positions);
    topology.pointCount = weld.pointCount;
    topology.points.resize(mesh.indices.size());
    std::ranges::transform(mesh.indices, topology.points.begin(), [&](std::uint32_t i) { return weld.point[i]; });
    topology.faceNormals = faceNormals(mesh, leastHeight * weld.tolerance);
    topology.originals = firstOfItsKind(topology);
    topology.twins = twinHalfEdges(topology);
    return topology;
}

void buildPatches(const Mesh& mesh, double creaseAngle, MeshTopology& topology) {
    const double creaseCosine = std::cos(glm::radians(creaseAngle));
    const auto triangleCount = static_cast<std::uint32_t>(topology.originals.size());
    UnionFind sets{triangleCount};
    topology.creases.assign(topology.twins.size(), false);
    for (std::uint32_t t = 0; t < triangleCount; ++t) {
        sets.unite(t, topology.originals[t]);
        if (!hasNormal(topology, t)) {
            joinAcrossThinFace(topology, t, creaseCosine, sets);
            continue;
        }
        for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
            const std::uint32_t twin = topology.twins[h];
            if (!isHalfEdge(twin) || twin < h || !hasNormal(topology, twin / 3)) continue;
            const bool bends =
                bendCosine(topology, h, twin) < creaseCosine || normalsSplit(mesh, topology, h, twin, creaseCosine);
            if (bends && !isInner(mesh, h, twin)) {
                topology.creases[h] = topology.creases[twin] = true;
            } else {
                sets.unite(t, twin / 3);
            }
        }
    }
    topology.patches.resize(triangleCount);
    topology.patchCount = 0;
    for (std::uint32_t t = 0; t < triangleCount; ++t) {  // a set's root is its least member, so it comes first
        const std::uint32_t root = sets.root(t);
        topology.patches[t] = root == t ? topology.patchCount++ : topology.patches[root];
    }
    for (std::uint32_t h = 0; h < topology.twins.size(); ++h) {  // what thin faces keep apart
        const std::uint32_t twin = topology.twins[h];
        if (isHalfEdge(twin) && topology.patches[h / 3] != topology.patches[twin / 3]) topology.creases[h] = true;
    }
}

}  // namespace inkedge
