#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include <unistd.h>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <nlohmann/json.hpp>

#include <inkedge/error.h>

#include "formats/gltf/load_gltf.h"

/// glTF files made for tests.
namespace inkedge::gltf_files {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using Bytes = std::vector<std::uint8_t>;

template <class T>
constexpr int componentType() {
    if constexpr (std::is_same_v<T, std::int8_t>) return 5120;
    if constexpr (std::is_same_v<T, std::uint8_t>) return 5121;
    if constexpr (std::is_same_v<T, std::int16_t>) return 5122;
    if constexpr (std::is_same_v<T, std::uint16_t>) return 5123;
    if constexpr (std::is_same_v<T, std::uint32_t>) return 5125;
    return 5126;
}

inline std::string base64(const Bytes& bytes) {
    constexpr const char* alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t bits = 0;
        for (std::size_t k = 0; k < 3; ++k) bits = bits << 8 | (i + k < bytes.size() ? bytes[i + k] : 0U);
        for (std::size_t k = 0; k < 4; ++k) text += i + k > bytes.size() ? '=' : alphabet[bits >> (18 - 6 * k) & 63];
    }
    return text;
}

// A glTF model under construction: everything lies in buffer 0.
struct Model {
    Json json = {{"asset", {{"version", "2.0"}}}};
    Bytes bytes;

    int add(const char* list, const Json& item) {
        json[list].push_back(item);
        return static_cast<int>(json[list].size()) - 1;
    }

    template <class T>
    int bufferView(const std::vector<T>& numbers) {
        bytes.resize((bytes.size() + 3) / 4 * 4);
        const std::size_t offset = bytes.size();
        bytes.resize(offset + numbers.size() * sizeof(T));
        std::memcpy(bytes.data() + offset, numbers.data(), numbers.size() * sizeof(T));
        return add("bufferViews", {{"buffer", 0}, {"byteOffset", offset}, {"byteLength", numbers.size() * sizeof(T)}});
    }

    template <class T>
    int accessor(const std::vector<T>& numbers, const std::string& type) {
        static const std::map<std::string, std::size_t> components{
            {"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT4", 16}};
        return add("accessors", {{"bufferView", bufferView(numbers)},
                                 {"componentType", componentType<T>()},
                                 {"count", numbers.size() / components.at(type)},
                                 {"type", type}});
    }

    int mesh(const Json& primitive) { return add("meshes", {{"primitives", {primitive}}}); }

    // A node that is a root of scene 0.
    int root(const Json& node) {
        const int index = add("nodes", node);
        if (!json.contains("scenes")) add("scenes", {{"nodes", Json::array()}});
        json["scenes"][0]["nodes"].push_back(index);
        return index;
    }

    [[nodiscard]] std::string gltf() const {
        Json whole = json;
        if (!bytes.empty() && !whole.contains("buffers"))
            whole["buffers"] = {
                {{"byteLength", bytes.size()}, {"uri", "data:application/octet-stream;base64," + base64(bytes)}}};
        return whole.dump();
    }

    [[nodiscard]] std::string glb(char padding = ' ') const {
        Json whole = json;
        if (!whole.contains("buffers")) whole["buffers"] = {{{"byteLength", bytes.size()}}};
        std::string text = whole.dump();
        text.resize((text.size() + 3) / 4 * 4, padding);
        std::string binary{bytes.begin(), bytes.end()};
        binary.resize((binary.size() + 3) / 4 * 4, '\0');
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

inline const std::vector<float> square{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};

inline Json positions(int accessor) { return {{"attributes", {{"POSITION", accessor}}}}; }

// One triangle, drawn by one node.
inline Model triangle() {
    Model model;
    const int position = model.accessor<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3");
    model.root({{"mesh", model.mesh(positions(position))}});
    return model;
}

// One indexed triangle with a name, accessor 0 its positions, accessor 1 its indices.
inline Model indexedTriangle() {
    Model model;
    Json primitive = positions(model.accessor<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3"));
    primitive["indices"] = model.accessor<std::uint16_t>({0, 1, 2}, "SCALAR");
    model.mesh(primitive);
    model.json["meshes"][0]["name"] = "gear";
    model.root({{"mesh", 0}, {"name", "wheel"}});
    return model;
}

class GltfFileTest : public testing::Test {
protected:
    GltfFileTest() : folder_{fs::path{testing::TempDir()} / fmt::format("inkedge-gltf-{}", getpid())} {
        fs::remove_all(folder_);
        fs::create_directories(folder_);
    }
    ~GltfFileTest() override {
        std::error_code ignored;
        fs::remove_all(folder_, ignored);
    }

    [[nodiscard]] fs::path write(const fs::path& name, const std::string& content) const {
        const fs::path file = folder_ / name;
        fs::create_directories(file.parent_path());
        std::ofstream{file, std::ios::binary} << content;
        return file;
    }

    [[nodiscard]] Scene::Data load(const Model& model, const LoadSettings& settings = {}) const {
        return gltf::loadGltf({write("model.gltf", model.gltf())}, settings);
    }

    // The message with which a file is refused, less the path and ": " that it must start with.
    [[nodiscard]] static std::string refusal(const fs::path& file, const LoadSettings& settings = {},
                                             Error::Kind kind = Error::Kind::Input) {
        using namespace testing;
        try {
            static_cast<void>(gltf::loadGltf({file}, settings));
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), kind);
            const std::string message = error.what();
            EXPECT_THAT(message, StartsWith(file.string() + ": "));
            EXPECT_THAT(message, Not(HasSubstr("\n")));
            EXPECT_THAT(message, Not(HasSubstr("inkedge: error")));
            return message.substr(std::min(message.size(), file.string().size() + 2));
        }
        ADD_FAILURE() << file << " was accepted";
        return {};
    }

    [[nodiscard]] std::string refusal(const Model& model, const LoadSettings& settings = {},
                                      Error::Kind kind = Error::Kind::Input) const {
        return refusal(write("model.gltf", model.gltf()), settings, kind);
    }
    [[nodiscard]] std::string refusalOf(const std::string& content) const {
        return refusal(write("model.gltf", content));
    }

    fs::path folder_;
};

inline glm::dvec3 position(const Mesh& mesh, std::size_t vertex) {
    return mesh.origin + glm::dvec3{mesh.positions.at(vertex)};
}

// The ends of the pieces of a mesh's lines.
inline std::vector<glm::dvec3> lineEnds(const Mesh& mesh) {
    std::vector<glm::dvec3> ends;
    for (const glm::vec3 p : mesh.lines) ends.push_back(mesh.origin + glm::dvec3{p});
    return ends;
}

// Every corner of every triangle in world space, in the order drawn.
inline std::vector<glm::dvec3> worldCorners(const Scene::Data& data) {
    std::vector<glm::dvec3> corners;
    for (const Instance& instance : data.instances) {
        const Mesh& mesh = data.meshes.at(instance.mesh);
        for (const std::uint32_t index : mesh.indices)
            corners.emplace_back(instance.transform * glm::dvec4{position(mesh, index), 1.0});
    }
    return corners;
}

inline void expectNear(const std::vector<glm::dvec3>& found, const std::vector<glm::dvec3>& expected,
                       double tolerance = 1e-6) {
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i)
        EXPECT_LE(glm::length(found[i] - expected[i]), tolerance)
            << "corner " << i << ": expected " << expected[i].x << " " << expected[i].y << " " << expected[i].z
            << ", found " << found[i].x << " " << found[i].y << " " << found[i].z;
}

inline const std::vector<glm::dvec3> triangleCorners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

}  // namespace inkedge::gltf_files
