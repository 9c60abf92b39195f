#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <functional>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <meshoptimizer.h>
#include <nlohmann/json.hpp>

#include <inkedge/error.h>

#include "base/temporary_folder.h"
#include "formats/gltf/bent_grid.h"
#include "formats/gltf/load_gltf.h"

namespace inkedge::compressed_models {

using Json = nlohmann::json;
using Bytes = std::vector<std::uint8_t>;

inline constexpr const char* draco = "KHR_draco_mesh_compression";
inline constexpr const char* meshopt = "EXT_meshopt_compression";

template <class T>
Bytes bytesOfAll(const std::vector<T>& values) {
    Bytes bytes(values.size() * sizeof(T));
    std::memcpy(bytes.data(), values.data(), bytes.size());
    return bytes;
}

// ---- a binary glTF whose buffer 0 holds the compressed data

struct Model {
    Json json = {{"asset", {{"version", "2.0"}}}, {"nodes", {{{"mesh", 0}}}}};
    Bytes bytes;

    Json slice(const Bytes& data) {
        bytes.resize((bytes.size() + 3) / 4 * 4);
        const std::size_t offset = bytes.size();
        bytes.insert(bytes.end(), data.begin(), data.end());
        return {{"buffer", 0}, {"byteOffset", offset}, {"byteLength", data.size()}};
    }

    std::size_t add(const char* list, const Json& item) {
        json[list].push_back(item);
        return json[list].size() - 1;
    }

    [[nodiscard]] std::string glb() const {
        Json whole = json;
        Json buffers = {{{"byteLength", bytes.size()}}};
        if (whole.contains("buffers")) buffers.insert(buffers.end(), whole["buffers"].begin(), whole["buffers"].end());
        whole["buffers"] = buffers;
        std::string text = whole.dump();
        text.resize((text.size() + 3) / 4 * 4, ' ');
        std::string binary{bytes.begin(), bytes.end()};
        binary.resize((binary.size() + 3) / 4 * 4);
        return "glTF" + word(2) + word(28 + text.size() + binary.size()) + word(text.size()) + "JSON" + text +
               word(binary.size()) + std::string{"BIN\0", 4} + binary;
    }

private:
    static std::string word(std::size_t number) {
        std::string text;
        for (int i = 0; i < 4; ++i) text += static_cast<char>(number >> (8 * i) & 255);
        return text;
    }
};

inline Scene::Data loaded(const Model& model) {
    const TemporaryFolder folder;
    put(folder / "a.glb", model.glb());
    return gltf::loadGltf({folder / "a.glb"});
}

inline std::string refusal(const Model& model) {
    try {
        static_cast<void>(loaded(model));
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), Error::Kind::Input);
        EXPECT_THAT(error.what(), testing::Not(testing::HasSubstr("\n")));
        return error.what();
    }
    ADD_FAILURE() << "accepted";
    return {};
}

// The corners of every triangle, each triangle turned to start at its least corner, sorted: order does not count.
inline std::vector<std::vector<double>> trianglesOf(const std::vector<glm::dvec3>& positions,
                                                    const std::vector<std::uint32_t>& indices) {
    std::vector<std::vector<double>> all;
    for (std::size_t i = 0; i < indices.size(); i += 3) {
        std::vector<std::vector<double>> corners;
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::dvec3 p = positions.at(indices[i + k]);
            corners.push_back({p.x, p.y, p.z});
        }
        std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
        all.emplace_back();
        for (const auto& corner : corners) all.back().insert(all.back().end(), corner.begin(), corner.end());
    }
    std::sort(all.begin(), all.end());
    return all;
}

inline std::vector<std::vector<double>> trianglesOf(const Grid& grid) {
    std::vector<glm::dvec3> positions;
    for (std::size_t i = 0; i < grid.positions.size(); i += 3)
        positions.emplace_back(grid.positions[i], grid.positions[i + 1], grid.positions[i + 2]);
    return trianglesOf(positions, grid.indices);
}

inline std::vector<std::vector<double>> trianglesOf(const Scene::Data& data) {
    const Mesh& mesh = data.meshes.at(0);
    std::vector<glm::dvec3> positions;
    for (const glm::vec3& p : mesh.positions) positions.push_back(mesh.origin + glm::dvec3{p});
    return trianglesOf(positions, mesh.indices);
}

// ---- meshopt, as EXT_meshopt_compression

inline Bytes encodeVertices(const void* data, std::size_t count, std::size_t stride) {
    Bytes bytes(meshopt_encodeVertexBufferBound(count, stride));
    bytes.resize(meshopt_encodeVertexBuffer(bytes.data(), bytes.size(), data, count, stride));
    return bytes;
}

inline Bytes encodeTriangles(const Grid& grid) {
    Bytes bytes(meshopt_encodeIndexBufferBound(grid.indices.size(), grid.vertexCount()));
    bytes.resize(meshopt_encodeIndexBuffer(bytes.data(), bytes.size(), grid.indices.data(), grid.indices.size()));
    return bytes;
}

inline Bytes encodeIndices(const Grid& grid) {
    Bytes bytes(meshopt_encodeIndexSequenceBound(grid.indices.size(), grid.vertexCount()));
    bytes.resize(meshopt_encodeIndexSequence(bytes.data(), bytes.size(), grid.indices.data(), grid.indices.size()));
    return bytes;
}

// A bufferView of buffer 1, which has no data.
inline std::size_t compressedView(Model& model, const Bytes& data, const std::string& mode, std::size_t count,
                                  std::size_t stride, const std::string& filter = {}) {
    Json extension = model.slice(data);
    extension.update({{"mode", mode}, {"count", count}, {"byteStride", stride}});
    if (!filter.empty()) extension["filter"] = filter;
    return model.add("bufferViews",
                     {{"buffer", 1}, {"byteLength", count * stride}, {"extensions", {{meshopt, extension}}}});
}

inline std::size_t accessor(Model& model, std::size_t view, int component, std::size_t count, const std::string& type) {
    return model.add("accessors",
                     {{"bufferView", view}, {"componentType", component}, {"count", count}, {"type", type}});
}

inline Model meshoptModel(const Grid& grid, const std::string& mode = "TRIANGLES", std::size_t indexSize = 4) {
    Model model;
    model.json["extensionsRequired"] = {meshopt};
    model.json["buffers"] = {{{"byteLength", 1 << 20}, {"extensions", {{meshopt, {{"fallback", true}}}}}}};
    const std::size_t vertices = compressedView(model, encodeVertices(grid.positions.data(), grid.vertexCount(), 12),
                                                "ATTRIBUTES", grid.vertexCount(), 12);
    const std::size_t indices = compressedView(model, mode == "TRIANGLES" ? encodeTriangles(grid) : encodeIndices(grid),
                                               mode, grid.indices.size(), indexSize);
    const Json primitive{
        {"attributes", {{"POSITION", accessor(model, vertices, 5126, grid.vertexCount(), "VEC3")}}},
        {"indices", accessor(model, indices, indexSize == 4 ? 5125 : 5123, grid.indices.size(), "SCALAR")}};
    model.add("meshes", {{"primitives", {primitive}}});
    return model;
}

// The same with another extension for meshopt's.
inline Model renamed(Model model, const std::string& extension) {
    std::string text = model.json.dump();
    for (std::size_t at = text.find(meshopt); at != std::string::npos; at = text.find(meshopt, at + 1))
        text.replace(at, std::strlen(meshopt), extension);
    model.json = Json::parse(text);
    return model;
}

struct Fault {
    std::string name;
    std::function<void(Model&)> breakIt;
    std::string expected;
};

inline void expectRefused(const std::function<Model()>& sound, const std::vector<Fault>& faults) {
    ASSERT_NO_THROW(static_cast<void>(loaded(sound())));
    for (const Fault& fault : faults) {
        Model model = sound();
        fault.breakIt(model);
        EXPECT_THAT(refusal(model), testing::HasSubstr(fault.expected)) << fault.name;
    }
}

inline std::function<void(Model&)> setInView(std::size_t view, const std::string& key, const Json& value) {
    return [=](Model& model) { model.json["bufferViews"][view]["extensions"][meshopt][key] = value; };
}

}  // namespace inkedge::compressed_models
