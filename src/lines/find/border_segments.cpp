#include "lines/find/border_segments.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "mesh/topology.h"
#include "scene/prepared.h"
#include "scene/seams.h"

namespace inkedge::lines {
namespace {

// A stretch of a border along which another border runs.
struct Cover {
    double from;
    double to;
    std::uint32_t other;  // into Borders::edges(); noBorder: the stretch is listed for the other border
    bool bends;
};
constexpr std::uint32_t noBorder = ~0U;

std::vector<std::vector<Cover>> findCovers(const Scene& scene, scene::Borders& borders) {
    const scene::SeamCreases creases{scene::instancedMeshesOf(scene), scene.loadedWith()};
    constexpr double foldedBack = 0.999;  // over this cosine two layers end together: no surface goes on
    std::vector<std::vector<Cover>> covers(borders.edges().size());
    for (std::uint32_t i = 0; i < covers.size(); ++i) {
        const scene::BorderEdge& border = borders.edges()[i];
        borders.forEachNear(i, [&](std::uint32_t j) {
            const scene::BorderEdge& other = borders.edges()[j];
            const double cosine = glm::dot(border.into, other.into);
            if (cosine > foldedBack) return;
            const auto shared = scene::runAlong(border, other, borders.tolerance());
            if (!shared) return;
            const bool bends = creases.meetInCrease(border, other, *shared);
            covers[i].push_back({shared->from[0], shared->to[0], j, bends});
            covers[j].push_back({shared->from[1], shared->to[1], noBorder, bends});
        });
    }
    return covers;
}

bool isMarkedBorder(const Scene& scene, const scene::BorderEdge& edge) {
    const Mesh& mesh = scene.meshes()[scene.instances()[edge.instance].mesh];
    return mesh::isOfKind(mesh, edge.halfEdge, mesh::noHalfEdge, EdgeKind::Marked);
}

// Adds the borders of faces that are too thin to say where the surface goes on.
void addThinBorders(const Scene& scene, std::span<const MeshEdges> meshes, std::vector<BorderSegment>& segments) {
    for (std::uint32_t i = 0; i < scene.instances().size(); ++i) {
        const std::uint32_t mesh = scene.instances()[i].mesh;
        for (const std::uint32_t h : meshes[mesh].thinBorders) {
            segments.push_back({i, h, 0.0, 1.0});
            segments.back().marked = isMarked(scene.meshes()[mesh], scene::topologyOf(scene, mesh), h);
        }
    }
}

}  // namespace

std::vector<BorderSegment> findBorderSegments(const Scene& scene, std::span<const MeshEdges> meshes) {
    scene::Borders borders{scene::instancedMeshesOf(scene), [&](std::uint32_t mesh) -> const std::vector<glm::dvec3>& {
                               return meshes[mesh].faceNormals;
                           }};
    const std::vector<std::vector<Cover>> covers = findCovers(scene, borders);
    std::vector<BorderSegment> segments;
    for (std::uint32_t i = 0; i < covers.size(); ++i) {
        const scene::BorderEdge& edge = borders.edges()[i];
        const bool marked = isMarkedBorder(scene, edge);
        const auto add = [&](double from, double to) {
            segments.push_back({edge.instance, edge.halfEdge, from, to});
            segments.back().marked = marked;
        };
        const double minGap = borders.tolerance() / glm::length(edge.b - edge.a);  // between two covers
        std::vector<Cover> own = covers[i];
        std::ranges::sort(own, [](const Cover& a, const Cover& b) { return a.from < b.from; });
        double reached = 0.0;
        for (const Cover& cover : own) {
            if (cover.from > reached + minGap) add(reached, cover.from);
            const double from = std::max(cover.from, reached);
            reached = std::max(reached, cover.to);
            if (cover.to <= from || cover.other == noBorder) continue;
            const scene::BorderEdge& other = borders.edges()[cover.other];
            segments.push_back({edge.instance,
                                edge.halfEdge,
                                from,
                                cover.to,
                                {other.instance, other.halfEdge / 3},
                                0.5 * (other.a + other.b) + other.into * glm::length(other.b - other.a),
                                cover.bends,
                                marked || isMarkedBorder(scene, other)});
        }
        if (reached < 1.0 - minGap) add(reached, 1.0);
    }
    addThinBorders(scene, meshes, segments);
    std::ranges::stable_sort(segments, [](const BorderSegment& a, const BorderSegment& b) {
        return a.instance != b.instance ? a.instance < b.instance : a.halfEdge < b.halfEdge;
    });
    return segments;
}

}  // namespace inkedge::lines
