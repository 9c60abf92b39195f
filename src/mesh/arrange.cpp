#include "mesh/arrange.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace inkedge::mesh {
namespace {

// Keeps some values of a list, which may be empty.
template <class Value>
void keep(std::vector<Value>& values, const std::vector<std::uint32_t>& kept) {
    if (values.empty()) return;
    for (std::size_t i = 0; i < kept.size(); ++i) values[i] = values[kept[i]];  // kept ascends
    values.resize(kept.size());
}

// @param count  values per triangle
template <class Value>
void reorder(std::vector<Value>& values, const std::vector<std::uint32_t>& order, std::size_t count) {
    if (values.empty()) return;
    std::vector<Value> ordered;
    ordered.reserve(values.size());
    for (const std::uint32_t t : order)
        for (std::size_t k = 0; k < count; ++k) ordered.push_back(values[count * t + k]);
    values = std::move(ordered);
}

}  // namespace

void dropUnusedVertices(Mesh& mesh) {
    constexpr std::uint32_t unused = ~0U;
    std::vector<std::uint32_t> to(mesh.positions.size(), unused);
    for (const std::uint32_t i : mesh.indices) to[i] = 0;
    std::vector<std::uint32_t> kept;
    for (std::uint32_t i = 0; i < to.size(); ++i) {
        if (to[i] == unused) continue;
        to[i] = static_cast<std::uint32_t>(kept.size());
        kept.push_back(i);
    }
    if (kept.size() == to.size()) return;
    keep(mesh.positions, kept);
    keep(mesh.normals, kept);
    keep(mesh.textureCoordinates, kept);
    keep(mesh.parameters, kept);
    keep(mesh.paint, kept);
    for (std::uint32_t& i : mesh.indices) i = to[i];
}

void bringForward(Mesh& mesh, const std::vector<bool>& first) {
    if (std::ranges::is_partitioned(first, [](bool is) { return is; })) return;
    std::vector<std::uint32_t> order(first.size());
    std::iota(order.begin(), order.end(), 0U);
    std::stable_partition(order.begin(), order.end(), [&](std::uint32_t t) { return first[t]; });
    reorder(mesh.indices, order, 3);
    reorder(mesh.edges, order, 3);
    reorder(mesh.materials, order, 1);
    reorder(mesh.faces, order, 1);
}

}  // namespace inkedge::mesh
