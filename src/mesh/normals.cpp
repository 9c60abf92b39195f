#include "mesh/normals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <unordered_map>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "base/parallel.h"

namespace inkedge::mesh {
namespace {

using Corners = std::vector<std::uint32_t>;

constexpr std::uint32_t none = ~0U;

constexpr glm::vec3 anyNormal{0.0F, 0.0F, 1.0F};  // of a face without area: it is never drawn

bool isWanted(glm::vec3 normal) { return normal == glm::vec3{0.0F}; }

glm::dvec3 unitOrZero(glm::dvec3 v) {
    const double length = glm::length(v);
    return length > 0.0 ? v / length : glm::dvec3{0.0};
}

// For every corner the first of all corners that share its normal. A corner shares its normal with at most one other
// corner across each of the triangle's two edges there, so that walking both ways finds all.
class SmoothingGroups {
public:
    explicit SmoothingGroups(const MeshTopology& topology)
        : topology_{topology}, first_(topology.points.size(), none) {}

    Corners find() {
        base::inRanges(topology_.pointCount, [&](std::size_t begin, std::size_t end) {  // no group is at two points
            for (std::uint32_t c = 0; c < first_.size(); ++c) {
                if (topology_.points[c] < begin || topology_.points[c] >= end || first_[c] != none) continue;
                first_[c] = c;
                follow(
                    c, [&](std::uint32_t corner) { return nextHalfEdge(topology_.twins[corner]); },
                    [](std::uint32_t corner) { return corner; });
                follow(
                    c, [&](std::uint32_t corner) { return topology_.twins[previousHalfEdge(corner)]; },
                    previousHalfEdge);
            }
        });
        return std::move(first_);
    }

private:
    // Marks the corners that are reached from a corner, until none is new.
    template <class Across, class HalfEdge>
    void follow(std::uint32_t group, Across across, HalfEdge halfEdge) {
        for (std::uint32_t c = group; isSmooth(halfEdge(c));) {
            c = across(c);
            if (first_[c] != none) return;
            first_[c] = group;
        }
    }

    [[nodiscard]] bool isSmooth(std::uint32_t h) const {
        const std::uint32_t twin = topology_.twins[h];
        // Faces wound against each other have normals to opposite sides: they cannot share a normal.
        if (!isHalfEdge(twin) || topology_.points[h] == topology_.points[twin]) return false;
        return !topology_.creases[h] && hasNormal(topology_, h / 3) && hasNormal(topology_, twin / 3);
    }

    const MeshTopology& topology_;
    Corners first_;
};

// Rewrites the mesh so that a vertex is one position with one normal; a normal that is yet to be made stays (0, 0, 0).
// @param groups  of each corner the first corner of its group; becomes the vertex of its group, or none
void splitVertices(Mesh& mesh, Corners& groups) {
    Corners vertexOfGroup(groups.size(), none);
    Corners keptVertex(mesh.positions.size(), none);
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    positions.reserve(mesh.positions.size());
    normals.reserve(mesh.positions.size());
    for (std::uint32_t c = 0; c < groups.size(); ++c) {
        const std::uint32_t vertex = mesh.indices[c];
        std::uint32_t& to = isWanted(mesh.normals[vertex]) ? vertexOfGroup[groups[c]] : keptVertex[vertex];
        if (to == none) {
            to = static_cast<std::uint32_t>(positions.size());
            positions.push_back(mesh.positions[vertex]);
            normals.push_back(mesh.normals[vertex]);
        }
        mesh.indices[c] = to;
    }
    mesh.positions = std::move(positions);
    mesh.normals = std::move(normals);
    for (std::uint32_t& group : groups) group = vertexOfGroup[group];
}

// Splits vertices once more where texture coordinates, paint or parameters have a seam that a smoothing group crosses.
// @param before  of each corner the vertex before splitVertices()
void splitAtSeams(Mesh& mesh, const Corners& before) {
    std::unordered_map<std::uint64_t, std::uint32_t> vertices;  // by the vertices now and before
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    std::vector<glm::vec2> coordinates;
    std::vector<VertexPaint> paint;
    std::vector<glm::dvec2> parameters;
    for (std::size_t c = 0; c < before.size(); ++c) {
        const std::uint32_t vertex = mesh.indices[c];
        const auto next = static_cast<std::uint32_t>(positions.size());
        const auto [found, isNew] = vertices.try_emplace(std::uint64_t{vertex} << 32U | before[c], next);
        if (isNew) {
            positions.push_back(mesh.positions[vertex]);
            normals.push_back(mesh.normals[vertex]);
            if (!mesh.textureCoordinates.empty()) coordinates.push_back(mesh.textureCoordinates[before[c]]);
            if (!mesh.paint.empty()) paint.push_back(mesh.paint[before[c]]);
            if (!mesh.parameters.empty()) parameters.push_back(mesh.parameters[before[c]]);
        }
        mesh.indices[c] = found->second;
    }
    mesh.positions = std::move(positions);
    mesh.normals = std::move(normals);
    mesh.textureCoordinates = std::move(coordinates);
    mesh.paint = std::move(paint);
    mesh.parameters = std::move(parameters);
}

std::array<double, 3> cornerAngles(const Mesh& mesh, std::size_t triangle) {
    const auto position = [&](std::size_t k) { return glm::dvec3{mesh.positions[mesh.indices[3 * triangle + k]]}; };
    const glm::dvec3 a = unitOrZero(position(1) - position(0));
    const glm::dvec3 b = unitOrZero(position(2) - position(1));
    const glm::dvec3 c = unitOrZero(position(0) - position(2));
    const auto between = [](glm::dvec3 to, glm::dvec3 from) {
        return std::acos(std::clamp(-glm::dot(to, from), -1.0, 1.0));
    };
    return {between(c, a), between(a, b), between(b, c)};
}

// @param vertices  of each corner the vertex to whose normal its face contributes, or none
void makeNormals(Mesh& mesh, const std::vector<glm::dvec3>& faces, const Corners& vertices) {
    base::inRanges(mesh.normals.size(), [&](std::size_t begin, std::size_t end) {
        std::vector<glm::dvec3> sums(end - begin, glm::dvec3{0.0});
        const auto within = [&](std::uint32_t vertex) { return vertex >= begin && vertex < end && vertex != none; };
        for (std::size_t t = 0; t < faces.size(); ++t) {
            const std::uint32_t* const v = &vertices[3 * t];
            if (!within(v[0]) && !within(v[1]) && !within(v[2])) continue;
            const std::array angles = cornerAngles(mesh, t);
            for (std::size_t k = 0; k < 3; ++k)
                if (within(v[k])) sums[v[k] - begin] += angles[k] * faces[t];
        }
        for (std::size_t v = begin; v < end; ++v) {
            if (!isWanted(mesh.normals[v])) continue;
            const glm::dvec3 unit = unitOrZero(sums[v - begin]);
            mesh.normals[v] = unit == glm::dvec3{0.0} ? anyNormal : glm::vec3{unit};
        }
    });
}

}  // namespace

void completeNormals(Mesh& mesh, const MeshTopology& topology, const LoadSettings& settings) {
    if (std::ranges::none_of(mesh.normals, isWanted)) return;
    Corners groups;
    if (settings.normals == Normals::Auto) {
        groups = SmoothingGroups{topology}.find();
    } else {
        groups.resize(mesh.indices.size());
        std::iota(groups.begin(), groups.end(), 0U);
    }
    const bool keepsMore = !mesh.textureCoordinates.empty() || !mesh.paint.empty() || !mesh.parameters.empty();
    const Corners before = keepsMore ? mesh.indices : Corners{};
    splitVertices(mesh, groups);
    makeNormals(mesh, topology.faceNormals, groups);
    if (!before.empty()) splitAtSeams(mesh, before);
}

}  // namespace inkedge::mesh
