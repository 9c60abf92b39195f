#include "mesh/arrange.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/parallel.h"
#include "base/radix_sort.h"
#include "mesh/z_order.h"

namespace inkedge::mesh {
namespace {

constexpr std::size_t minArranged = 100'000;  // triangles: fewer fit into caches in any order
constexpr std::size_t samples = 1024;         // pairs of triangles that follow each other
constexpr double farApart = 0.01;             // of the mesh's diagonal, on average
constexpr unsigned coarse = 39;               // bits of a key that are left out, so that 24 sort

// Brings the values of a list, which may be empty, into an order, or some of them.
// @param count  values for each number of the order
template <class Value>
void reorder(std::vector<Value>& values, const std::vector<std::uint32_t>& order, std::size_t count = 1) {
    if (values.empty()) return;
    std::vector<Value> ordered(count * order.size());
    base::inRanges(order.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            for (std::size_t k = 0; k < count; ++k) ordered[count * i + k] = values[count * order[i] + k];
    });
    values = std::move(ordered);
}

}  // namespace

void arrangeVertices(Mesh& mesh) {
    constexpr std::uint32_t unused = ~0U;
    std::vector<std::uint32_t> to(mesh.positions.size(), unused);
    std::vector<std::uint32_t> order;
    order.reserve(to.size());
    for (std::uint32_t& i : mesh.indices) {
        if (to[i] == unused) {
            to[i] = static_cast<std::uint32_t>(order.size());
            order.push_back(i);
        }
        i = to[i];
    }
    if (order.size() == to.size() && std::ranges::is_sorted(order)) return;
    reorder(mesh.positions, order);
    reorder(mesh.normals, order);
    reorder(mesh.textureCoordinates, order);
    reorder(mesh.parameters, order);
    reorder(mesh.paint, order);
}

void arrangeTriangles(Mesh& mesh) {
    const std::size_t count = mesh.indices.size() / 3;
    if (count < minArranged || !mesh.edges.empty() || !mesh.faces.empty()) return;
    glm::vec3 low = mesh.positions.front();
    glm::vec3 high = low;
    for (const glm::vec3 p : mesh.positions) low = glm::min(low, p), high = glm::max(high, p);
    const auto position = [&](std::size_t t) { return glm::dvec3{mesh.positions[mesh.indices[3 * t]]}; };
    double steps = 0.0;
    for (std::size_t t = 0; t + 1 < count; t += count / samples) steps += glm::distance(position(t), position(t + 1));
    if (steps < farApart * samples * glm::distance(glm::dvec3{low}, glm::dvec3{high})) return;

    const ZOrder curve{low, high};
    std::vector<std::uint64_t> keys(count);  // of triangles, with their numbers in the lower half
    base::inRanges(count, [&](std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t) keys[t] = curve.key(position(t)) >> coarse << 32U | t;
    });
    base::radixSort(keys, [](std::uint64_t key) { return static_cast<std::uint32_t>(key >> 32U); });
    std::vector<std::uint32_t> order(count);
    std::ranges::transform(keys, order.begin(), [](std::uint64_t key) { return static_cast<std::uint32_t>(key); });
    reorder(mesh.indices, order, 3);
    reorder(mesh.materials, order);
    reorder(mesh.limitTriangles, order);
}

void bringForward(Mesh& mesh, const std::vector<bool>& first) {
    if (std::ranges::is_partitioned(first, [](bool is) { return is; })) return;
    std::vector<std::uint32_t> order(first.size());
    std::iota(order.begin(), order.end(), 0U);
    std::stable_partition(order.begin(), order.end(), [&](std::uint32_t t) { return first[t]; });
    reorder(mesh.indices, order, 3);
    reorder(mesh.edges, order, 3);
    reorder(mesh.materials, order);
    reorder(mesh.faces, order);
    reorder(mesh.limitTriangles, order);
}

}  // namespace inkedge::mesh
