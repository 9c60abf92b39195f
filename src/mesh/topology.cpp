#include "mesh/topology.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>
#include <span>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "base/later.h"
#include "base/parallel.h"
#include "base/union_find.h"
#include "mesh/weld.h"

namespace inkedge::mesh {
namespace {

std::array<std::uint32_t, 3> sortedPoints(const MeshTopology& topology, std::uint32_t t) {
    std::array p{topology.points[3 * t], topology.points[3 * t + 1], topology.points[3 * t + 2]};
    std::ranges::sort(p);
    return p;
}

bool collapsed(const MeshTopology& topology, std::uint32_t t) {
    const std::uint32_t* const p = &topology.points[3 * std::size_t{t}];
    return p[0] == p[1] || p[1] == p[2] || p[2] == p[0];
}

// A half-edge, with the points of its triangle, except the smaller of the half-edge's own two points.
struct Entry {
    std::uint32_t greaterPoint;
    std::uint32_t thirdPoint;
    std::uint32_t halfEdge;
    friend auto operator<=>(const Entry&, const Entry&) = default;
};

// Joins the half-edges of one edge. They are sorted, so that triangles with the same three points follow each other.
void joinAlongEdge(std::span<Entry> edge, MeshTopology& topology) {
    std::size_t kept = 0;
    for (const Entry& entry : edge) {
        if (kept == 0 || edge[kept - 1].thirdPoint != entry.thirdPoint)
            edge[kept++] = entry;
        else if (entry.thirdPoint > entry.greaterPoint)  // at only one of the three edges: that of the smallest points
            topology.originals[entry.halfEdge / 3] = edge[kept - 1].halfEdge / 3;
    }
    if (kept == 2) {
        topology.twins[edge[0].halfEdge] = edge[1].halfEdge;
        topology.twins[edge[1].halfEdge] = edge[0].halfEdge;
    } else if (kept > 2) {
        for (const Entry& entry : edge.first(kept)) topology.twins[entry.halfEdge] = manyHalfEdges;
    }
}

// Finds twins and originals along the edges whose smaller point is in a range.
void joinAtPoints(std::uint32_t low, std::uint32_t high, MeshTopology& topology) {
    const auto& points = topology.points;
    const auto triangleCount = static_cast<std::uint32_t>(points.size() / 3);
    const auto forEachHalfEdge = [&](auto&& visit) {
        for (std::uint32_t t = 0; t < triangleCount; ++t) {
            const std::uint32_t a = points[3 * t];
            const std::uint32_t b = points[3 * t + 1];
            const std::uint32_t c = points[3 * t + 2];
            if (a == b || b == c || c == a) continue;
            const std::array lesser{std::min(a, b), std::min(b, c), std::min(c, a)};
            for (std::uint32_t k = 0; k < 3; ++k)
                if (lesser[k] >= low && lesser[k] < high) visit(lesser[k] - low, 3 * t + k);
        }
    };
    // Counting sort by the smaller point: next[p + 1] runs from the first of p's half-edges to the first of p + 1's.
    std::vector<std::uint32_t> next(std::size_t{high} - low + 2, 0);
    forEachHalfEdge([&](std::uint32_t p, std::uint32_t) { ++next[p + 2]; });
    for (std::size_t p = 2; p < next.size(); ++p) next[p] += next[p - 1];
    std::vector<std::uint32_t> halfEdges(next.back());
    forEachHalfEdge([&](std::uint32_t p, std::uint32_t h) { halfEdges[next[p + 1]++] = h; });

    std::vector<Entry> entries;
    for (std::uint32_t p = low; p < high; ++p) {
        entries.clear();
        for (std::uint32_t i = next[p - low]; i < next[p - low + 1]; ++i) {
            const std::uint32_t h = halfEdges[i];
            const std::uint32_t end = nextHalfEdge(h);
            entries.push_back({std::max(points[h], points[end]), points[nextHalfEdge(end)], h});
        }
        std::ranges::sort(entries);
        for (auto edge = entries.begin(); edge != entries.end();) {
            const auto end =
                std::find_if(edge, entries.end(), [&](const Entry& e) { return e.greaterPoint != edge->greaterPoint; });
            joinAlongEdge({edge, end}, topology);
            edge = end;
        }
    }
}

// Finds the originals of collapsed triangles, which have no edges.
void findCollapsedOriginals(MeshTopology& topology) {
    std::vector<std::pair<std::array<std::uint32_t, 3>, std::uint32_t>> all;
    for (std::uint32_t t = 0; t < topology.originals.size(); ++t)
        if (collapsed(topology, t)) all.emplace_back(sortedPoints(topology, t), t);
    std::ranges::sort(all);
    for (std::size_t i = 1; i < all.size(); ++i)
        if (all[i].first == all[i - 1].first) topology.originals[all[i].second] = topology.originals[all[i - 1].second];
}

struct TriangleNormals {
    std::vector<glm::dvec3> normals;
    std::vector<std::uint32_t> slim;  // triangles with a normal and of less height than maxFoldHeight
};

TriangleNormals triangleNormals(const Mesh& mesh) {
    const double tolerance = weldToleranceOf(mesh.positions);
    const double thin = minHeight * tolerance;
    const double slim = maxFoldHeight / weldTolerance * tolerance;
    TriangleNormals made{std::vector<glm::dvec3>(mesh.indices.size() / 3), {}};
    const auto parts = base::partsOf(made.normals.size(), [&](std::size_t begin, std::size_t end) {
        std::vector<std::uint32_t> found;
        for (std::size_t t = begin; t < end; ++t) {
            const glm::dvec3 a{mesh.positions[mesh.indices[3 * t]]};
            const glm::dvec3 b{mesh.positions[mesh.indices[3 * t + 1]]};
            const glm::dvec3 c{mesh.positions[mesh.indices[3 * t + 2]]};
            const glm::dvec3 area = glm::cross(b - a, c - a);
            const double length = glm::length(area);
            const double longest =
                std::sqrt(std::max({glm::dot(b - a, b - a), glm::dot(c - b, c - b), glm::dot(a - c, a - c)}));
            made.normals[t] = length > thin * longest ? area / length : glm::dvec3{0.0};
            if (length > thin * longest && length <= slim * longest) found.push_back(static_cast<std::uint32_t>(t));
        }
        return found;
    });
    for (const std::vector<std::uint32_t>& part : parts) made.slim.insert(made.slim.end(), part.begin(), part.end());
    return made;
}

// Whether a triangle lies between two others, folded over both, that go on into each other without it.
bool isFold(const Mesh& mesh, const MeshTopology& topology, const std::vector<glm::dvec3>& normals, std::uint32_t t) {
    constexpr double foldedBack = -0.5;
    constexpr double goesOn = 0.5;
    const auto squaredLength = [&](std::uint32_t h) {
        const glm::dvec3 along =
            glm::dvec3{mesh.positions[mesh.indices[nextHalfEdge(h)]]} - glm::dvec3{mesh.positions[mesh.indices[h]]};
        return glm::dot(along, along);
    };
    std::array edges{3 * t, 3 * t + 1, 3 * t + 2};
    std::ranges::sort(edges, std::ranges::greater{}, squaredLength);
    std::array<glm::dvec3, 2> beyond;  // the neighbours' normals, as if all were wound alike
    for (std::size_t k = 0; k < 2; ++k) {
        const std::uint32_t twin = topology.twins[edges[k]];
        if (!isHalfEdge(twin)) return false;
        const bool against = topology.points[edges[k]] == topology.points[twin];
        beyond[k] = against ? -normals[twin / 3] : normals[twin / 3];
        if (!(glm::dot(beyond[k], normals[t]) < foldedBack)) return false;
    }
    return glm::dot(beyond[0], beyond[1]) > goesOn;
}

std::vector<glm::dvec3> withoutFolds(const Mesh& mesh, const MeshTopology& topology, TriangleNormals made) {
    std::vector<std::uint32_t> folds;
    for (const std::uint32_t t : made.slim)
        if (isFold(mesh, topology, made.normals, t)) folds.push_back(t);
    for (const std::uint32_t t : folds) made.normals[t] = glm::dvec3{0.0};
    return std::move(made.normals);
}

// A face that is too thin to have a normal only connects its neighbours, as if they touched each other.
void joinAcrossThinFace(const MeshTopology& topology, std::uint32_t t, double creaseCosine, base::UnionFind& sets) {
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

// Whether faces are connected across an edge that is no crease.
enum class Link : std::uint8_t { None, Bent, Flat };  // Bent: by more than the crease angle

// One per half-edge, None for the second of each edge.
std::vector<Link> linksOf(const MeshTopology& topology, double creaseCosine) {
    std::vector<Link> links(topology.twins.size(), Link::None);
    base::inRanges(links.size(), [&](std::size_t begin, std::size_t end) {
        for (auto h = static_cast<std::uint32_t>(begin); h < end; ++h) {
            const std::uint32_t twin = topology.twins[h];
            if (!isHalfEdge(twin) || twin < h || topology.creases[h]) continue;
            if (!hasNormal(topology, h / 3) || !hasNormal(topology, twin / 3)) continue;
            links[h] = bendCosine(topology, h, twin) < creaseCosine ? Link::Bent : Link::Flat;
        }
    });
    return links;
}

// Faces that are connected by flat links.
base::UnionFind connected(const MeshTopology& topology, const std::vector<Link>& links, double creaseCosine) {
    const auto triangleCount = static_cast<std::uint32_t>(topology.originals.size());
    base::UnionFind sets{triangleCount};
    for (std::uint32_t t = 0; t < triangleCount; ++t) {
        if (topology.originals[t] != t) sets.unite(t, topology.originals[t]);
        if (!hasNormal(topology, t)) joinAcrossThinFace(topology, t, creaseCosine, sets);
        for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h)
            if (links[h] == Link::Flat) sets.unite(t, topology.twins[h] / 3);
    }
    return sets;
}

// Creases that connected faces, of one surface or not, show.
struct Creases {
    std::vector<std::uint32_t> between;  // half-edges between surfaces
    double innerCosine = -1.0;           // the largest of those within a surface
};

Creases creasesBetween(const MeshTopology& topology, std::size_t begin, std::size_t end) {
    Creases found;
    for (auto h = static_cast<std::uint32_t>(begin); h < end; ++h) {
        const std::uint32_t twin = topology.twins[h];
        if (!isHalfEdge(twin)) continue;
        const bool apart = topology.patches[h / 3] != topology.patches[twin / 3] &&
                           topology.surfaceOf(h / 3) != topology.surfaceOf(twin / 3);
        if (apart)
            found.between.push_back(h);
        else if (topology.creases[h])
            found.innerCosine = std::max(found.innerCosine, bendCosine(topology, h, twin));
    }
    return found;
}

}  // namespace

void turnOver(Mesh& mesh, std::size_t first) {
    std::swap(mesh.indices[first + 1], mesh.indices[first + 2]);
    if (!mesh.edges.empty()) std::swap(mesh.edges[first], mesh.edges[first + 2]);
}

double bendCosine(const MeshTopology& topology, std::uint32_t halfEdge, std::uint32_t twin) {
    const double cosine = glm::dot(topology.faceNormals[halfEdge / 3], topology.faceNormals[twin / 3]);
    return topology.points[halfEdge] == topology.points[twin] ? -cosine : cosine;
}

std::vector<glm::dvec3> makeFaceNormals(const Mesh& mesh, const MeshTopology& topology) {
    return withoutFolds(mesh, topology, triangleNormals(mesh));
}

std::vector<glm::dvec3> normalsOfTriangles(const Mesh& mesh) { return triangleNormals(mesh).normals; }

MeshTopology buildTopology(const Mesh& mesh) {
    MeshTopology topology;
    const auto triangleCount = static_cast<std::uint32_t>(mesh.indices.size() / 3);
    base::Later<TriangleNormals> normals{[&] { return triangleNormals(mesh); }, triangleCount};
    {
        const Weld weld = weldByPosition(mesh.positions);
        topology.pointCount = weld.pointCount;
        topology.points.resize(mesh.indices.size());
        std::ranges::transform(mesh.indices, topology.points.begin(), [&](std::uint32_t i) { return weld.point[i]; });
    }
    topology.originals.resize(triangleCount);
    std::iota(topology.originals.begin(), topology.originals.end(), 0U);
    topology.twins.assign(mesh.indices.size(), noHalfEdge);
    base::inRanges(topology.pointCount, [&](std::size_t begin, std::size_t end) {
        joinAtPoints(static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end), topology);
    });
    findCollapsedOriginals(topology);
    topology.faceNormals = withoutFolds(mesh, topology, normals.take());
    return topology;
}

void buildPatches(double creaseAngle, MeshTopology& topology) {
    const double creaseCosine = std::cos(glm::radians(creaseAngle));
    const std::vector<Link> links = linksOf(topology, creaseCosine);
    base::UnionFind patches = connected(topology, links, creaseCosine);
    base::UnionFind surfaces = patches;
    for (std::uint32_t h = 0; h < links.size(); ++h)
        if (links[h] == Link::Bent) surfaces.unite(h / 3, topology.twins[h] / 3);
    const auto triangleCount = static_cast<std::uint32_t>(topology.originals.size());
    topology.patches.resize(triangleCount);
    topology.surfaces.clear();
    for (std::uint32_t t = 0; t < triangleCount; ++t) {  // a set's root is its smallest member, so it comes first
        const std::uint32_t root = patches.root(t);
        topology.patches[t] = root == t ? topology.patchCount() : topology.patches[root];
        if (root == t) topology.surfaces.push_back(topology.patches[surfaces.root(t)]);
    }
    topology.innerCreaseCosine = -1.0;
    for (const Creases& found : base::partsOf(topology.twins.size(), [&](std::size_t begin, std::size_t end) {
             return creasesBetween(topology, begin, end);
         })) {
        for (const std::uint32_t h : found.between) topology.creases[h] = true;  // what thin faces keep apart, too
        topology.innerCreaseCosine = std::max(topology.innerCreaseCosine, found.innerCosine);
    }
}

}  // namespace inkedge::mesh
