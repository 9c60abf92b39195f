#include "mesh/control_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>
#include <tuple>
#include <utility>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "base/message.h"
#include "base/union_find.h"

namespace inkedge::mesh {
namespace {

constexpr std::uint32_t maxFaces = 65'000;  // OpenSubdiv counts them with 16 bits

bool takesPart(const MeshTopology& topology, std::uint32_t t) {
    const std::uint32_t* const p = &topology.points[3 * std::size_t{t}];
    return topology.originals[t] == t && p[0] != p[1] && p[1] != p[2] && p[2] != p[0];
}

// Whether an edge connects two faces of one manifold, wound alike.
bool joins(const MeshTopology& topology, std::uint32_t h) {
    const std::uint32_t twin = topology.twins[h];
    return isHalfEdge(twin) && topology.points[h] != topology.points[twin];
}

bool isSharp(const Mesh& mesh, const MeshTopology& topology, std::uint32_t h) {
    if (!joins(topology, h)) return true;
    return topology.creases[h] && !isSmoothByKind(mesh, h, topology.twins[h]);
}

// The connected corners of a point are one vertex.
struct Vertices {
    std::vector<std::uint32_t> ofCorner;  // one per corner of the mesh; noFace where its triangle takes no part
    std::vector<std::uint32_t> points;    // one per vertex
    std::vector<std::uint32_t> corners;   // one per vertex: one of its corners
};

Vertices connectedCorners(const MeshTopology& topology) {
    const auto count = static_cast<std::uint32_t>(topology.points.size());
    base::UnionFind sets{count};
    for (std::uint32_t h = 0; h < count; ++h) {
        if (!joins(topology, h)) continue;
        sets.unite(h, nextHalfEdge(topology.twins[h]));
        sets.unite(nextHalfEdge(h), topology.twins[h]);
    }
    Vertices vertices;
    vertices.ofCorner.assign(count, noFace);
    for (std::uint32_t c = 0; c < count; ++c) {  // a set's root is its smallest member, so it comes first
        if (!takesPart(topology, c / 3)) continue;
        if (sets.root(c) == c) {
            vertices.ofCorner[c] = static_cast<std::uint32_t>(vertices.points.size());
            vertices.points.push_back(topology.points[c]);
            vertices.corners.push_back(c);
        } else {
            vertices.ofCorner[c] = vertices.ofCorner[sets.root(c)];
        }
    }
    return vertices;
}

// The half-edges in the mesh that surround a face.
using Loop = std::vector<std::uint32_t>;

// The outline of triangles that inner edges join; none if the outline is not one loop around all of them.
std::optional<Loop> outline(const Mesh& mesh, const MeshTopology& topology, const Vertices& vertices,
                            std::span<const std::uint32_t> triangles) {
    std::vector<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>> edges;  // start, end, half-edge
    for (const std::uint32_t t : triangles)
        for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h)
            if (!joins(topology, h) || !isInner(mesh, h, topology.twins[h]))
                edges.emplace_back(vertices.ofCorner[h], vertices.ofCorner[nextHalfEdge(h)], h);
    if (edges.size() != triangles.size() + 2 || edges.size() >= maxFaces) return {};
    const std::uint32_t first = std::get<0>(edges.front());
    std::ranges::sort(edges);
    Loop loop;
    for (std::uint32_t at = first; loop.size() < edges.size();) {
        const auto edge = std::ranges::lower_bound(edges, std::tuple{at, 0U, 0U});
        if (edge == edges.end() || std::get<0>(*edge) != at) return {};
        loop.push_back(std::get<2>(*edge));
        at = std::get<1>(*edge);
        if (at == first) break;
    }
    if (loop.size() != edges.size()) return {};
    return loop;
}

void addFace(ControlMesh& control, const Mesh& mesh, const Vertices& vertices, std::span<const std::uint32_t> halfEdges,
             std::span<const std::uint32_t> triangles) {
    for (const std::uint32_t t : triangles) control.faces[t] = static_cast<std::uint32_t>(control.faceSizes.size());
    control.faceSizes.push_back(static_cast<std::int32_t>(halfEdges.size()));
    for (const std::uint32_t h : halfEdges) {
        control.corners.push_back(static_cast<std::int32_t>(vertices.ofCorner[h]));
        if (!mesh.textureCoordinates.empty()) control.coordinates.push_back(mesh.textureCoordinates[mesh.indices[h]]);
        if (!mesh.paint.empty()) control.paint.push_back(mesh.paint[mesh.indices[h]]);
        if (!mesh.edges.empty()) control.edges.push_back(mesh.edges[h]);
    }
    control.firstTriangles.push_back(triangles.front());
}

void addFaces(ControlMesh& control, const Mesh& mesh, const MeshTopology& topology, const Vertices& vertices) {
    const auto count = static_cast<std::uint32_t>(topology.originals.size());
    base::UnionFind polygons{count};
    for (std::uint32_t h = 0; h < topology.twins.size(); ++h)
        if (joins(topology, h) && isInner(mesh, h, topology.twins[h])) polygons.unite(h / 3, topology.twins[h] / 3);
    std::vector<std::uint32_t> order;
    for (std::uint32_t t = 0; t < count; ++t)
        if (takesPart(topology, t)) order.push_back(t);
    std::ranges::stable_sort(order, {}, [&](std::uint32_t t) { return polygons.root(t); });

    control.faces.assign(count, noFace);
    for (auto begin = order.begin(); begin != order.end();) {
        const std::uint32_t root = polygons.root(*begin);
        const auto end = std::find_if(begin, order.end(), [&](std::uint32_t t) { return polygons.root(t) != root; });
        const std::span<const std::uint32_t> triangles{begin, end};
        if (const auto loop = outline(mesh, topology, vertices, triangles)) {
            addFace(control, mesh, vertices, *loop, triangles);
        } else {
            for (const std::uint32_t& t : triangles) {
                const std::array halfEdges{3 * t, 3 * t + 1, 3 * t + 2};
                addFace(control, mesh, vertices, halfEdges, {&t, 1});
            }
        }
        begin = end;
    }
}

double cornerAngle(const Mesh& mesh, std::uint32_t corner) {
    const auto at = [&](std::uint32_t c) { return glm::dvec3{mesh.positions[mesh.indices[c]]}; };
    const glm::dvec3 a = at(nextHalfEdge(corner)) - at(corner);
    const glm::dvec3 b = at(previousHalfEdge(corner)) - at(corner);
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

// Where a border has a corner on purpose: one face ends there, or two halves of a square.
std::vector<bool> borderCorners(const ControlMesh& control, const Mesh& mesh, const MeshTopology& topology,
                                const Vertices& vertices) {
    std::vector<std::uint32_t> faces(vertices.points.size(), 0);
    std::vector<double> angles(vertices.points.size(), 0.0);
    std::vector<bool> border(vertices.points.size(), false);
    for (const std::int32_t v : control.corners) ++faces[static_cast<std::size_t>(v)];
    for (std::uint32_t c = 0; c < vertices.ofCorner.size(); ++c) {
        if (control.faces[c / 3] == noFace) continue;
        angles[vertices.ofCorner[c]] += cornerAngle(mesh, c);
        if (!joins(topology, c)) border[vertices.ofCorner[c]] = border[vertices.ofCorner[nextHalfEdge(c)]] = true;
    }
    constexpr double square = 0.505 * std::numbers::pi;  // a right angle and what a modeller's rounding adds
    const bool triangles = control.scheme == SubdivisionScheme::Loop;
    std::vector<bool> result(vertices.points.size());
    for (std::size_t v = 0; v < result.size(); ++v)
        result[v] = border[v] && (faces[v] == 1 || (triangles && faces[v] == 2 && angles[v] <= square));
    return result;
}

// A point with several vertices stays one point only if all of them lie on the same two sharp edges; else none may
// move.
void fixSplitPoints(const Mesh& mesh, const MeshTopology& topology, const Vertices& vertices,
                    std::vector<bool>& fixed) {
    std::vector<std::uint32_t> parts(topology.pointCount, 0);
    for (const std::uint32_t p : vertices.points) ++parts[p];
    std::vector<std::pair<std::uint32_t, std::uint32_t>> sharp;  // vertex, the point at the edge's other end
    for (std::uint32_t h = 0; h < topology.twins.size(); ++h) {
        const std::uint32_t next = nextHalfEdge(h);
        if (vertices.ofCorner[h] == noFace || !isSharp(mesh, topology, h)) continue;
        if (parts[topology.points[h]] > 1) sharp.emplace_back(vertices.ofCorner[h], topology.points[next]);
        if (parts[topology.points[next]] > 1) sharp.emplace_back(vertices.ofCorner[next], topology.points[h]);
    }
    std::ranges::sort(sharp);
    sharp.erase(std::unique(sharp.begin(), sharp.end()), sharp.end());

    using Ends = std::array<std::uint32_t, 2>;
    constexpr Ends unknown{noFace, noFace};
    std::vector<Ends> ends(topology.pointCount, unknown);
    std::vector<bool> comesApart(topology.pointCount, false);
    for (std::uint32_t v = 0; v < vertices.points.size(); ++v) {
        const std::uint32_t p = vertices.points[v];
        if (parts[p] < 2) continue;
        const auto from = std::ranges::lower_bound(sharp, std::pair{v, 0U});
        const bool two = sharp.end() - from >= 2 && from[0].first == v && from[1].first == v &&
                         (sharp.end() - from == 2 || from[2].first != v);
        const Ends its = two ? Ends{from[0].second, from[1].second} : unknown;
        if (!two || fixed[v] || (ends[p] != unknown && ends[p] != its)) comesApart[p] = true;
        ends[p] = its;
    }
    for (std::uint32_t v = 0; v < vertices.points.size(); ++v)
        if (comesApart[vertices.points[v]]) fixed[v] = true;
}

// Two vertices each, the lesser first; sorted.
std::vector<std::pair<std::int32_t, std::int32_t>> edgesOf(const ControlMesh& control) {
    std::vector<std::pair<std::int32_t, std::int32_t>> edges;
    std::size_t first = 0;
    for (const std::int32_t size : control.faceSizes) {
        const auto n = static_cast<std::size_t>(size);
        for (std::size_t k = 0; k < n; ++k)
            edges.push_back(std::minmax(control.corners[first + k], control.corners[first + (k + 1) % n]));
        first += n;
    }
    std::ranges::sort(edges);
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    return edges;
}

void refuseManyAround(const ControlMesh& control, const Mesh& mesh) {
    std::vector<std::uint32_t> faces(control.positions.size(), 0);
    for (const std::int32_t v : control.corners) ++faces[static_cast<std::size_t>(v)];
    const auto largest = std::ranges::max_element(faces);
    if (largest != faces.end() && *largest >= maxFaces)
        base::refuse(fmt::format("mesh {}: expected fewer than {} faces around a point to subdivide, found {}",
                                 base::quote(mesh.name), maxFaces, *largest));
}

}  // namespace

ControlMesh controlMesh(const Mesh& mesh, const MeshTopology& topology) {
    ControlMesh control;
    const bool polygons = std::ranges::any_of(mesh.edges, [](EdgeKinds kinds) { return kinds.has(EdgeKind::Inner); });
    control.scheme = polygons ? SubdivisionScheme::CatmullClark : SubdivisionScheme::Loop;
    const Vertices vertices = connectedCorners(topology);
    addFaces(control, mesh, topology, vertices);
    std::vector<std::uint32_t> firstOfPoint(topology.pointCount, noFace);
    for (std::uint32_t c = 0; c < topology.points.size(); ++c)
        if (firstOfPoint[topology.points[c]] == noFace) firstOfPoint[topology.points[c]] = mesh.indices[c];
    for (const std::uint32_t p : vertices.points) control.positions.emplace_back(mesh.positions[firstOfPoint[p]]);
    refuseManyAround(control, mesh);

    for (std::uint32_t h = 0; h < topology.twins.size(); ++h) {
        const std::uint32_t twin = topology.twins[h];
        if (vertices.ofCorner[h] == noFace || twin == noHalfEdge || !isSharp(mesh, topology, h)) continue;
        if (joins(topology, h) && twin < h) continue;  // once an edge
        for (const std::uint32_t end : {h, nextHalfEdge(h)})
            control.sharpEdges.push_back(static_cast<std::int32_t>(vertices.ofCorner[end]));
    }
    std::vector<bool> fixed = borderCorners(control, mesh, topology, vertices);
    fixSplitPoints(mesh, topology, vertices, fixed);
    for (std::size_t v = 0; v < fixed.size(); ++v)
        if (fixed[v]) control.sharpVertices.push_back(static_cast<std::int32_t>(v));
    return control;
}

ControlMesh subsetOf(const ControlMesh& whole, const std::vector<std::uint32_t>& chosen) {
    ControlMesh part;
    part.scheme = whole.scheme;
    std::vector<std::int32_t> renumbered(whole.positions.size(), -1);
    std::size_t corner = 0;
    auto next = chosen.begin();
    for (std::uint32_t f = 0; f < whole.faceSizes.size(); corner += static_cast<std::size_t>(whole.faceSizes[f++])) {
        if (next == chosen.end() || *next != f) continue;
        ++next;
        part.faceSizes.push_back(whole.faceSizes[f]);
        part.firstTriangles.push_back(whole.firstTriangles[f]);
        for (std::size_t k = 0; k < static_cast<std::size_t>(whole.faceSizes[f]); ++k) {
            const auto v = static_cast<std::size_t>(whole.corners[corner + k]);
            if (renumbered[v] < 0) {
                renumbered[v] = static_cast<std::int32_t>(part.positions.size());
                part.positions.push_back(whole.positions[v]);
            }
            part.corners.push_back(renumbered[v]);
        }
    }
    const auto edges = edgesOf(part);
    for (std::size_t i = 0; i + 1 < whole.sharpEdges.size(); i += 2) {
        const std::int32_t a = renumbered[static_cast<std::size_t>(whole.sharpEdges[i])];
        const std::int32_t b = renumbered[static_cast<std::size_t>(whole.sharpEdges[i + 1])];
        if (std::ranges::binary_search(edges, std::pair{std::min(a, b), std::max(a, b)}))
            part.sharpEdges.insert(part.sharpEdges.end(), {a, b});
    }
    for (const std::int32_t v : whole.sharpVertices)
        if (const std::int32_t to = renumbered[static_cast<std::size_t>(v)]; to >= 0) part.sharpVertices.push_back(to);
    return part;
}

double refinedElements(const ControlMesh& control, int levels) {
    auto vertices = static_cast<double>(control.positions.size());
    auto corners = static_cast<double>(control.corners.size());
    auto faces = static_cast<double>(control.faceSizes.size());
    auto edges = static_cast<double>(edgesOf(control).size());
    const bool triangles = control.scheme == SubdivisionScheme::Loop;
    for (int level = 0; level < levels; ++level) {
        vertices += triangles ? edges : edges + faces;
        edges = 2.0 * edges + corners;
        faces = triangles ? 4.0 * faces : corners;
        corners = triangles ? 3.0 * faces : 4.0 * faces;
    }
    return vertices + (triangles ? 3.0 : 6.0) * faces;
}

}  // namespace inkedge::mesh
