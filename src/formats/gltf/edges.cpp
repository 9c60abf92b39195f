#include "formats/gltf/edges.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "base/message.h"

namespace inkedge::gltf {

namespace {

constexpr const char* extensionName = "EXT_mesh_primitive_edge_visibility";

struct Edge {
    std::uint64_t vertices;  // the smaller one in the upper half
    bool found = false;      // on a triangle
};

std::uint64_t keyOf(std::uint32_t a, std::uint32_t b) {
    const auto [lesser, greater] = std::minmax(a, b);
    return std::uint64_t{lesser} << 32U | greater;
}

int accessorIn(const tinygltf::Value& object, const char* name) {
    const tinygltf::Value& index = member(object, name);
    if (!index.IsInt()) base::refuse(fmt::format("{}: expected the number of an accessor, found something else", name));
    return index.GetNumberAsInt();
}

// One value per edge of each triangle, those left out included: 0 hidden, 1 silhouette, 2 hard, 3 hard and already
// given in another triangle.
std::vector<std::uint8_t> readVisibility(const tinygltf::Model& model, const tinygltf::Value& extension,
                                         std::size_t triangles) {
    const std::vector<double> bytes =
        readNumbers(model, accessorIn(extension, "visibility"), "visibility", {scalar, {Component::Uint8}});
    if (const std::size_t expected = (6 * triangles + 7) / 8; bytes.size() != expected)
        base::refuse(
            fmt::format("visibility: expected {} bytes for {} triangles, found {}", expected, triangles, bytes.size()));
    std::vector<std::uint8_t> edges(3 * triangles);
    for (std::size_t i = 0; i < edges.size(); ++i)
        edges[i] = static_cast<std::uint8_t>(static_cast<unsigned>(bytes[i / 4]) >> 2 * (i % 4) & 3U);
    return edges;
}

// Reads strings of vertices, which the largest value of the component type separates.
void readLineString(const tinygltf::Model& model, const tinygltf::Value& line, std::size_t vertexCount,
                    std::vector<Edge>& edges) {
    const int accessor = accessorIn(line, "indices");
    const std::vector<double> indices =
        readNumbers(model, accessor, "indices", {scalar, {Component::Uint8, Component::Uint16, Component::Uint32}});
    const Component component{model.accessors[static_cast<std::size_t>(accessor)].componentType};
    const double restart = component == Component::Uint8    ? 255.0
                           : component == Component::Uint16 ? 65535.0
                                                            : 4294967295.0;
    for (std::size_t i = 0; i < indices.size(); ++i) {
        if (indices[i] == restart) continue;
        if (!(indices[i] < static_cast<double>(vertexCount)))
            base::refuse(fmt::format("indices: expected vertex indices below {}, found {} at index {}", vertexCount,
                                     indices[i], i));
        if (i > 0 && indices[i - 1] != restart && indices[i - 1] != indices[i])
            edges.push_back(
                {keyOf(static_cast<std::uint32_t>(indices[i - 1]), static_cast<std::uint32_t>(indices[i]))});
    }
}

std::vector<Edge> readLineStrings(const tinygltf::Model& model, const tinygltf::Value& lines, std::size_t vertexCount) {
    if (!lines.IsArray()) base::refuse("lineStrings: expected an array, found something else");
    std::vector<Edge> edges;
    const auto& strings = lines.Get<tinygltf::Value::Array>();
    for (std::size_t i = 0; i < strings.size(); ++i)
        base::within(base::label("line string", i), [&] { readLineString(model, strings[i], vertexCount, edges); });
    std::ranges::sort(edges, {}, &Edge::vertices);
    const auto same = [](const Edge& a, const Edge& b) { return a.vertices == b.vertices; };
    edges.erase(std::unique(edges.begin(), edges.end(), same), edges.end());
    return edges;
}

void mark(const std::vector<std::uint8_t>& visibility, std::span<const std::uint32_t> numbers, EdgeVisibility& edges) {
    for (std::size_t t = 0; t < numbers.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k)
            edges.kinds[3 * t + k] = visibility[3 * numbers[t] + k] >= 2 ? EdgeKind::Marked : EdgeKind::Inner;
    }
}

void mark(std::vector<Edge> lines, std::span<const std::uint32_t> triangles, EdgeVisibility& edges) {
    for (std::size_t c = 0; c < triangles.size(); ++c) {
        const std::uint64_t key = keyOf(triangles[c], triangles[c % 3 == 2 ? c - 2 : c + 1]);
        const auto line = std::ranges::lower_bound(lines, key, {}, &Edge::vertices);
        if (line == lines.end() || line->vertices != key) continue;
        line->found = true;
        edges.kinds[c] = EdgeKind::Marked;
    }
    edges.lost = static_cast<std::size_t>(std::ranges::count(lines, false, &Edge::found));
}

}  // namespace

EdgeVisibility readEdgeVisibility(const tinygltf::Model& model, const tinygltf::Primitive& primitive, Mode mode,
                                  std::span<const std::uint32_t> corners, std::size_t vertexCount) {
    const auto found = primitive.extensions.find(extensionName);
    if (found == primitive.extensions.end()) return {};
    return base::within(extensionName, [&] {
        const tinygltf::Value& extension = found->second;
        if (!extension.Has("visibility") && !extension.Has("lineStrings"))
            base::refuse("expected visibility or lineStrings, found neither");
        const std::vector<std::uint32_t> triangles = triangleList(mode, {corners.begin(), corners.end()});
        EdgeVisibility edges;
        edges.kinds.resize(triangles.size());
        if (extension.Has("visibility"))
            mark(readVisibility(model, extension, triangleCount(mode, corners.size())), triangleNumbers(mode, corners),
                 edges);
        if (extension.Has("lineStrings"))
            mark(readLineStrings(model, extension.Get("lineStrings"), vertexCount), triangles, edges);
        return edges;
    });
}

}  // namespace inkedge::gltf
