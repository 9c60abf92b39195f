// Writes small .glb files compressed with Draco and meshopt into a folder, for the glTF fuzzer to start from:
// compressed_seeds FOLDER
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include <draco/attributes/geometry_attribute.h>
#include <draco/compression/encode.h>
#include <draco/mesh/mesh.h>
#include <meshoptimizer.h>
#include <nlohmann/json.hpp>

#include "formats/gltf/bent_grid.h"
#include "formats/gltf/encode_exponential.h"
#include "formats/gltf/encode_vertices.h"
#include "fuzz/promise.h"

namespace {

using Json = nlohmann::json;
using Bytes = std::vector<std::uint8_t>;

constexpr std::uint32_t side = 3;
constexpr std::size_t vertexCount = std::size_t{side} * side;

void append(Bytes& bytes, std::size_t number, const std::string& text) {
    for (int i = 0; i < 4; ++i) bytes.push_back(static_cast<std::uint8_t>(number >> (8 * i) & 255));
    bytes.insert(bytes.end(), text.begin(), text.end());
}

void writeGlb(const std::filesystem::path& file, const Json& json, const Bytes& data) {
    const std::string text = json.dump();
    Bytes bytes{'g', 'l', 'T', 'F', 2, 0, 0, 0};
    append(bytes, 28 + text.size() + data.size(), {});
    append(bytes, text.size(), "JSON" + text);
    append(bytes, data.size(), std::string{"BIN\0", 4});
    bytes.insert(bytes.end(), data.begin(), data.end());
    inkedge::fuzz::write(file, bytes);
}

Json accessors(std::size_t indexCount) {
    return {{{"componentType", 5126}, {"count", vertexCount}, {"type", "VEC3"}},
            {{"componentType", 5125}, {"count", indexCount}, {"type", "SCALAR"}}};
}

Json document(const char* extension) {
    return {{"asset", {{"version", "2.0"}}},
            {"nodes", Json::array({{{"mesh", 0}}})},
            {"extensionsRequired", Json::array({extension})}};
}

Json meshes(const Json& primitive) { return Json::array({{{"primitives", Json::array({primitive})}}}); }

void writeDraco(const std::filesystem::path& file, int method, int bits) {
    const inkedge::compressed_models::Grid grid{side};
    draco::Mesh mesh;
    mesh.set_num_points(vertexCount);
    draco::GeometryAttribute description;
    description.Init(draco::GeometryAttribute::POSITION, nullptr, 3, draco::DT_FLOAT32, false, 12, 0);
    const int position = mesh.AddAttribute(description, true, vertexCount);
    for (std::uint32_t i = 0; i < vertexCount; ++i)
        mesh.attribute(position)->SetAttributeValue(draco::AttributeValueIndex{i}, &grid.positions[i * 3]);
    for (std::size_t i = 0; i < grid.indices.size(); i += 3)
        mesh.AddFace({draco::PointIndex{grid.indices[i]}, draco::PointIndex{grid.indices[i + 1]},
                      draco::PointIndex{grid.indices[i + 2]}});
    draco::Encoder encoder;
    encoder.SetEncodingMethod(method);
    if (bits > 0) encoder.SetAttributeQuantization(draco::GeometryAttribute::POSITION, bits);
    draco::EncoderBuffer buffer;
    inkedge::fuzz::expect(encoder.EncodeMeshToBuffer(mesh, &buffer).ok(), "a mesh that Draco encodes", "another");

    Json json = document("KHR_draco_mesh_compression");
    json["accessors"] = accessors(grid.indices.size());
    const Json whole{{"buffer", 0}, {"byteLength", buffer.size()}};
    json["bufferViews"] = Json::array({whole});
    json["buffers"] = Json::array({{{"byteLength", buffer.size()}}});
    const Json compressed{{"bufferView", 0}, {"attributes", {{"POSITION", 0}}}};
    json["meshes"] = meshes({{"attributes", {{"POSITION", 0}}},
                             {"indices", 1},
                             {"extensions", {{"KHR_draco_mesh_compression", compressed}}}});
    writeGlb(file, json, {buffer.data(), buffer.data() + buffer.size()});
}

// Positions and indices, each in a view of its own; the filter is that of the positions. The positions are in version 1
// of the codec if channel modes are given.
void writeMeshopt(const std::filesystem::path& file, const std::string& mode, const std::string& filter,
                  const char* extension = "EXT_meshopt_compression", const Bytes& channelModes = {}) {
    const inkedge::compressed_models::Grid grid{side};
    std::vector<float> filtered = grid.positions;
    if (filter == "EXPONENTIAL") encodeExponential(filtered.data(), vertexCount, 12, 15, grid.positions.data());
    Bytes vertices(meshopt_encodeVertexBufferBound(vertexCount, 12));
    vertices.resize(meshopt_encodeVertexBuffer(vertices.data(), vertices.size(), filtered.data(), vertexCount, 12));
    if (!channelModes.empty())
        vertices = inkedge::vertex_codec::encode(reinterpret_cast<const std::uint8_t*>(filtered.data()), vertexCount,
                                                 12, channelModes);
    const bool triangles = mode == "TRIANGLES";
    const std::size_t count = grid.indices.size();
    Bytes indices(triangles ? meshopt_encodeIndexBufferBound(count, vertexCount)
                            : meshopt_encodeIndexSequenceBound(count, vertexCount));
    indices.resize(triangles ? meshopt_encodeIndexBuffer(indices.data(), indices.size(), grid.indices.data(), count)
                             : meshopt_encodeIndexSequence(indices.data(), indices.size(), grid.indices.data(), count));

    const auto view = [&](std::size_t offset, std::size_t length, std::size_t elements, std::size_t stride,
                          const std::string& viewMode, const std::string& viewFilter) -> Json {
        const Json compressed{{"buffer", 0},          {"byteOffset", offset}, {"byteLength", length},
                              {"byteStride", stride}, {"count", elements},    {"mode", viewMode},
                              {"filter", viewFilter}};
        return {{"buffer", 1}, {"byteLength", elements * stride}, {"extensions", {{extension, compressed}}}};
    };
    Json json = document(extension);
    json["accessors"] = accessors(count);
    for (std::size_t i = 0; i < 2; ++i) json["accessors"][i]["bufferView"] = i;
    json["bufferViews"] = Json::array({view(0, vertices.size(), vertexCount, 12, "ATTRIBUTES", filter),
                                       view(vertices.size(), indices.size(), count, 4, mode, "NONE")});
    if (!channelModes.empty()) {  // colors, which nothing uses
        const Bytes colors = inkedge::vertex_codec::encode(reinterpret_cast<const std::uint8_t*>(filtered.data()),
                                                           vertexCount, 4, {channelModes[0]});
        json["bufferViews"].push_back(
            view(vertices.size() + indices.size(), colors.size(), vertexCount, 4, "ATTRIBUTES", "COLOR"));
        indices.insert(indices.end(), colors.begin(), colors.end());
    }
    const Json fallback{{"byteLength", 4096}, {"extensions", {{extension, {{"fallback", true}}}}}};
    json["buffers"] = Json::array({{{"byteLength", vertices.size() + indices.size()}}, fallback});
    json["meshes"] = meshes({{"attributes", {{"POSITION", 0}}}, {"indices", 1}});
    vertices.insert(vertices.end(), indices.begin(), indices.end());
    writeGlb(file, json, vertices);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "compressed_seeds: error: expected one folder, found %d arguments\n", argc - 1);
        return 2;
    }
    const std::filesystem::path folder{argv[1]};
    std::filesystem::create_directories(folder);
    for (const int bits : {0, 11}) {
        writeDraco(folder / ("draco_edgebreaker_" + std::to_string(bits) + ".glb"), draco::MESH_EDGEBREAKER_ENCODING,
                   bits);
        writeDraco(folder / ("draco_sequential_" + std::to_string(bits) + ".glb"), draco::MESH_SEQUENTIAL_ENCODING,
                   bits);
    }
    writeMeshopt(folder / "meshopt_triangles.glb", "TRIANGLES", "NONE");
    writeMeshopt(folder / "meshopt_indices.glb", "INDICES", "NONE");
    writeMeshopt(folder / "meshopt_exponential.glb", "TRIANGLES", "EXPONENTIAL");
    constexpr const char* khr = "KHR_meshopt_compression";
    writeMeshopt(folder / "meshopt_bytes.glb", "TRIANGLES", "NONE", khr, {0, 0, 0});
    writeMeshopt(folder / "meshopt_pairs.glb", "INDICES", "EXPONENTIAL", khr, {1, 1, 1});
    writeMeshopt(folder / "meshopt_turned.glb", "TRIANGLES", "NONE", khr, {2, 0x42, 0});
    return 0;
}
