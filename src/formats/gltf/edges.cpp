#include "formats/gltf/edges.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "base/message.h"

namespace inkedge::gltf {

namespace {

constexpr const char* visibilityExtension = "EXT_mesh_primitive_edge_visibility";
constexpr const char* outlineExtension = "CESIUM_primitive_outline";

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

void checkVertex(double index, std::size_t at, std::size_t vertexCount) {
    if (!(index < static_cast<double>(vertexCount)))
        base::refuse(
            fmt::format("indices: expected vertex indices below {}, found {} at index {}", vertexCount, index, at));
}

// Sorted, and without repeats.
std::vector<Edge> onceEach(std::vector<Edge> edges) {
    std::ranges::sort(edges, {}, &Edge::vertices);
    const auto same = [](const Edge& a, const Edge& b) { return a.vertices == b.vertices; };
    edges.erase(std::unique(edges.begin(), edges.end(), same), edges.end());
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
        checkVertex(indices[i], i, vertexCount);
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
    return onceEach(std::move(edges));
}

// Reads pairs of vertices.
std::vector<Edge> readPairs(const tinygltf::Model& model, const tinygltf::Value& extension, std::size_t vertexCount) {
    const std::vector<double> indices = readNumbers(model, accessorIn(extension, "indices"), "indices",
                                                    {scalar, {Component::Uint8, Component::Uint16, Component::Uint32}});
    if (indices.size() % 2 != 0)
        base::refuse(fmt::format("indices: expected two for each edge, found {}", indices.size()));
    std::vector<Edge> edges;
    for (std::size_t i = 0; i < indices.size(); ++i) {
        checkVertex(indices[i], i, vertexCount);
        if (i % 2 == 1 && indices[i - 1] != indices[i])
            edges.push_back(
                {keyOf(static_cast<std::uint32_t>(indices[i - 1]), static_cast<std::uint32_t>(indices[i]))});
    }
    return onceEach(std::move(edges));
}

void mark(const std::vector<std::uint8_t>& visibility, std::span<const std::uint32_t> numbers, FileEdges& edges) {
    for (std::size_t t = 0; t < numbers.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k)
            edges.kinds[3 * t + k] = visibility[3 * numbers[t] + k] >= 2 ? EdgeKind::Marked : EdgeKind::Inner;
    }
}

void mark(std::vector<Edge> lines, std::span<const std::uint32_t> triangles, FileEdges& edges) {
    for (std::size_t c = 0; c < triangles.size(); ++c) {
        const std::uint64_t key = keyOf(triangles[c], triangles[c % 3 == 2 ? c - 2 : c + 1]);
        const auto line = std::ranges::lower_bound(lines, key, {}, &Edge::vertices);
        if (line == lines.end() || line->vertices != key) continue;
        line->found = true;
        edges.kinds[c] = EdgeKind::Marked;
    }
    for (const Edge& line : lines) {
        if (line.found) continue;
        edges.lines.push_back(static_cast<std::uint32_t>(line.vertices >> 32U));
        edges.lines.push_back(static_cast<std::uint32_t>(line.vertices));
    }
}

// Calls read(extension) if the primitive has it.
template <class Read>
void withExtension(const tinygltf::Primitive& primitive, const char* name, Read&& read) {
    const auto found = primitive.extensions.find(name);
    if (found != primitive.extensions.end()) base::within(name, [&] { read(found->second); });
}

}  // namespace

FileEdges readEdges(const tinygltf::Model& model, const tinygltf::Primitive& primitive, Mode mode,
                    std::span<const std::uint32_t> corners, std::size_t vertexCount) {
    FileEdges edges;
    if (!primitive.extensions.contains(visibilityExtension) && !primitive.extensions.contains(outlineExtension))
        return edges;
    const std::vector<std::uint32_t> triangles = triangleList(mode, {corners.begin(), corners.end()});
    edges.kinds.resize(triangles.size());
    withExtension(primitive, visibilityExtension, [&](const tinygltf::Value& extension) {
        if (!extension.Has("visibility") && !extension.Has("lineStrings"))
            base::refuse("expected visibility or lineStrings, found neither");
        if (extension.Has("visibility"))
            mark(readVisibility(model, extension, triangleCount(mode, corners)), triangleNumbers(mode, corners), edges);
        if (extension.Has("lineStrings"))
            mark(readLineStrings(model, extension.Get("lineStrings"), vertexCount), triangles, edges);
    });
    withExtension(primitive, outlineExtension, [&](const tinygltf::Value& extension) {
        mark(readPairs(model, extension, vertexCount), triangles, edges);
    });
    return edges;
}

}  // namespace inkedge::gltf
