#include "lines/find/face_tree.h"

#include <algorithm>
#include <utility>

#include <glm/common.hpp>

#include "base/parallel.h"
#include "base/radix_sort.h"
#include "lines/find/file_faces.h"
#include "mesh/z_order.h"

namespace inkedge::lines {
namespace {

constexpr std::uint32_t nodeFaces = 16;  // four packets of four

std::vector<glm::vec3> pointsOf(const Mesh& mesh, const mesh::MeshTopology& topology) {
    std::vector<glm::vec3> points(topology.pointCount);
    for (std::size_t c = topology.points.size(); c-- > 0;)  // the last assignment is that of a point's first corner
        points[topology.points[c]] = mesh.positions[mesh.indices[c]];
    return points;
}

// The number of a code of Gray along a Z-order curve: neighbours differ in one bit, so that jumps are shorter
// (Faloutsos 1988).
std::uint64_t grayed(std::uint64_t code) {
    for (unsigned shift = 1; shift < 64; shift *= 2) code ^= code >> shift;
    return code;
}

std::vector<std::uint32_t> sorted(const mesh::MeshTopology& topology, const std::vector<glm::vec3>& points) {
    glm::vec3 low{points.empty() ? glm::vec3{0.0F} : points.front()};
    glm::vec3 high = low;
    for (const glm::vec3& p : points) low = glm::min(low, p), high = glm::max(high, p);
    const mesh::ZOrder order{low, high};
    std::vector<std::uint64_t> keys(topology.originals.size());  // along the curve
    base::inRanges(keys.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t) {
            const std::uint32_t* const p = &topology.points[3 * t];
            const glm::dvec3 sum = glm::dvec3{points[p[0]]} + glm::dvec3{points[p[1]]} + glm::dvec3{points[p[2]]};
            keys[t] = grayed(order.key(sum / 3.0));
        }
    });
    // First by the upper half, which is enough for almost all.
    struct Upper {
        std::uint32_t key;
        std::uint32_t triangle;
    };
    std::vector<Upper> uppers;
    uppers.reserve(keys.size());
    for (std::uint32_t t = 0; t < keys.size(); ++t)
        if (topology.originals[t] == t) uppers.push_back({static_cast<std::uint32_t>(keys[t] >> 31U), t});
    base::radixSort(uppers, [](const Upper& each) { return each.key; });
    for (auto run = uppers.begin(); run != uppers.end();) {
        const auto end = std::find_if(run, uppers.end(), [&](const Upper& each) { return each.key != run->key; });
        if (end - run > 1)
            std::stable_sort(run, end,
                             [&](const Upper& x, const Upper& y) { return keys[x.triangle] < keys[y.triangle]; });
        run = end;
    }
    std::vector<std::uint32_t> triangles(uppers.size());
    std::ranges::transform(uppers, triangles.begin(), &Upper::triangle);
    return triangles;
}

// The same triangles, those of a face of the file one after the other: faces by where the middle of their triangles is
// along the curve, each from a packet of its own on.
std::vector<std::uint32_t> byFileFace(const std::vector<std::uint32_t>& triangles, const Mesh& mesh) {
    struct FileFace {
        double middle = 0.0;
        std::uint32_t count = 0;
        std::uint32_t begin = 0;
    };
    std::vector<FileFace> faces;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const std::size_t number = mesh.faces[triangles[i]];
        if (number >= faces.size()) faces.resize(number + 1);
        faces[number].middle += static_cast<double>(i);
        ++faces[number].count;
    }
    std::vector<std::uint32_t> order;
    for (std::uint32_t number = 0; number < faces.size(); ++number) {
        if (faces[number].count == 0) continue;
        faces[number].middle /= faces[number].count;
        order.push_back(number);
    }
    std::ranges::stable_sort(order, {}, [&](std::uint32_t number) { return faces[number].middle; });
    std::uint32_t end = 0;
    for (const std::uint32_t number : order) {
        faces[number].begin = end;
        end += (faces[number].count + 3) / 4 * 4;
    }
    std::vector<std::uint32_t> sorted(end, FaceTree::none);
    for (const std::uint32_t t : triangles) sorted[faces[mesh.faces[t]].begin++] = t;
    return sorted;
}

void fill(FaceTree::Packet& packet, const FaceTree& tree, const mesh::MeshTopology& topology, std::size_t first) {
    for (std::size_t face = 0; face < 4; ++face) {
        const bool isNone = first + face >= tree.triangles.size() || tree.triangles[first + face] == FaceTree::none;
        const std::uint32_t* const p =
            isNone ? nullptr : &topology.points[3 * std::size_t{tree.triangles[first + face]}];
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::vec3 corner = isNone ? glm::vec3{FourBoxes::none} : tree.points[p[k]];
            for (int axis = 0; axis < 3; ++axis) packet.corners[k][axis][face] = corner[axis];
        }
    }
}

void setBox(FourBoxes& boxes, std::size_t k, const FaceTree::Packet& packet, std::size_t faces) {
    const FourBoxes own = packet.boxes();
    glm::vec3 low = own.min(0);
    glm::vec3 high = own.max(0);
    for (std::size_t face = 1; face < faces; ++face) {
        low = glm::min(low, own.min(face));
        high = glm::max(high, own.max(face));
    }
    boxes.set(k, low, high);
}

}  // namespace

FaceTree buildFaceTree(const Mesh& mesh, const mesh::MeshTopology& topology) {
    FaceTree tree;
    tree.points = pointsOf(mesh, topology);
    tree.triangles = sorted(topology, tree.points);
    if (hasFileFaces(mesh)) tree.triangles = byFileFace(tree.triangles, mesh);
    const std::size_t count = tree.triangles.size();
    tree.packets.resize((count + 3) / 4);
    std::vector<FourBoxes> bottom((count + nodeFaces - 1) / nodeFaces);
    base::inRanges(count, [&](std::size_t begin, std::size_t end) {
        for (std::size_t node = (begin + nodeFaces - 1) / nodeFaces; node * nodeFaces < end; ++node) {
            for (std::size_t p = 4 * node; p < std::min(4 * node + 4, tree.packets.size()); ++p) {
                fill(tree.packets[p], tree, topology, 4 * p);
                setBox(bottom[node], p - 4 * node, tree.packets[p], tree.facesIn(static_cast<std::uint32_t>(p)));
            }
        }
    });
    tree.boxes = BoxLevels{std::move(bottom), tree.packets.size()};
    return tree;
}

}  // namespace inkedge::lines
