#include "lines/find/file_faces.h"

#include <algorithm>
#include <cstddef>

namespace inkedge::lines {
namespace {

std::uint64_t pairOf(std::uint32_t a, std::uint32_t b) {
    return std::uint64_t{std::min(a, b)} << 32U | std::uint64_t{std::max(a, b)};
}

}  // namespace

FileFaces::FileFaces(const FaceTree& tree, const Mesh& mesh, const mesh::MeshTopology& topology) {
    if (!hasFileFaces(mesh) || tree.boxes.empty()) return;
    std::vector<std::uint32_t>& packets = levels_.emplace_back();
    for (std::size_t p = 0; p < tree.packets.size(); ++p)  // a packet is of one face
        packets.push_back(mesh.faces[tree.triangles[4 * p]]);
    while (levels_.size() < tree.boxes.top()) {
        const std::vector<std::uint32_t>& below = levels_.back();
        std::vector<std::uint32_t> above;
        for (std::size_t first = 0; first < below.size(); first += 4) {
            const auto end = below.begin() + static_cast<std::ptrdiff_t>(std::min(first + 4, below.size()));
            const auto begin = below.begin() + static_cast<std::ptrdiff_t>(first);
            const bool alike = std::all_of(begin, end, [&](std::uint32_t face) { return face == *begin; });
            above.push_back(alike ? *begin : several);
        }
        levels_.push_back(std::move(above));
    }
    findNeighbours(mesh, topology);
}

void FileFaces::findNeighbours(const Mesh& mesh, const mesh::MeshTopology& topology) {
    for (std::uint32_t h = 0; h < topology.twins.size(); ++h) {
        const std::uint32_t twin = topology.twins[h];
        if (!mesh::isHalfEdge(twin) || twin < h || mesh.faces[h / 3] == mesh.faces[twin / 3]) continue;
        const bool isShared = mesh.edges.empty() || !(mesh.edges[h] | mesh.edges[twin]).has(EdgeKind::Free);
        const std::uint64_t pair = pairOf(mesh.faces[h / 3], mesh.faces[twin / 3]);
        if (isShared && (neighbours_.empty() || neighbours_.back() != pair)) neighbours_.push_back(pair);
    }
    std::ranges::sort(neighbours_);
    neighbours_.erase(std::unique(neighbours_.begin(), neighbours_.end()), neighbours_.end());
}

bool FileFaces::areBeside(std::uint32_t level, std::uint32_t index, std::uint32_t otherLevel,
                          std::uint32_t otherIndex) const noexcept {
    if (levels_.empty()) return false;
    const std::uint32_t face = levels_[level][index];
    const std::uint32_t other = levels_[otherLevel][otherIndex];
    if (face == several || other == several) return false;
    return face == other || std::ranges::binary_search(neighbours_, pairOf(face, other));
}

}  // namespace inkedge::lines
