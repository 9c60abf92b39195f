#include "lines/find/file_lines.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <tuple>

#include "base/stop.h"

namespace inkedge::lines {
namespace {

constexpr double slack = 0.5;  // footprints

// For each end the first one at its position.
std::vector<std::uint32_t> firstsAtPositions(const std::vector<glm::vec3>& ends) {
    const auto position = [&](std::uint32_t i) { return std::tuple{ends[i].x, ends[i].y, ends[i].z}; };
    std::vector<std::uint32_t> order(ends.size());
    std::iota(order.begin(), order.end(), 0U);
    std::ranges::stable_sort(order, {}, position);
    std::vector<std::uint32_t> firsts(ends.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool same = i > 0 && position(order[i]) == position(order[i - 1]);
        firsts[order[i]] = same ? firsts[order[i - 1]] : order[i];
    }
    return firsts;
}

}  // namespace

FileLines findFileLines(const Mesh& mesh) {
    const std::vector<std::uint32_t> firsts = firstsAtPositions(mesh.lines);
    FileLines pieces;
    for (std::size_t i = 0; i < firsts.size(); i += 2) {
        const auto [lesser, greater] = std::minmax(firsts[i], firsts[i + 1]);
        if (lesser != greater) pieces.push_back({lesser, greater});
    }
    std::ranges::sort(pieces);
    const auto repeats = std::unique(pieces.begin(), pieces.end());
    pieces.erase(repeats, pieces.end());
    return pieces;
}

void addFileLines(const Scene& scene, std::span<const FileLines> ofMeshes, std::vector<Segment>& to) {
    for (std::uint32_t i = 0; i < scene.instances().size(); ++i) {
        base::stopIfAsked();
        const Instance& instance = scene.instances()[i];
        const Mesh& mesh = scene.meshes()[instance.mesh];
        glm::dmat4 toWorld = instance.transform;
        toWorld[3] += toWorld * glm::dvec4{mesh.origin, 0.0} - glm::dvec4{scene.bounds().centre, 0.0};
        for (const std::array<std::uint32_t, 2>& piece : ofMeshes[instance.mesh]) {
            Segment& segment = to.emplace_back();
            segment.curve = Curve::Marked;
            segment.occludes = false;
            segment.faces[0] = {i, noTriangle};
            segment.pixelSlack = slack;
            for (std::size_t k = 0; k < 2; ++k) {
                segment.ends[k] = glm::dvec3{toWorld * glm::dvec4{mesh.lines[piece[k]], 1.0}};
                segment.keys[k] = fileLineKey(i, piece[k]);
            }
        }
    }
}

}  // namespace inkedge::lines
