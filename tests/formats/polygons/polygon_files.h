#pragma once

#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <glm/geometric.hpp>

#include <inkedge/error.h>

#include "base/temporary_folder.h"
#include "formats/polygons/load_polygons.h"

namespace inkedge::polygon_files {

namespace fs = std::filesystem;
using polygons::PolygonFormat;

template <class T>
std::string raw(const T& value) {
    std::string bytes(sizeof value, '\0');
    std::memcpy(bytes.data(), &value, sizeof value);
    return bytes;
}

template <class T>
std::string raw(std::initializer_list<T> values) {
    std::string bytes;
    for (const T& value : values) bytes += raw(value);
    return bytes;
}

inline const std::string triangleObj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
inline const std::string triangleStl =
    "solid one\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n"
    "endsolid one\n";

// A binary STL of as many equal triangles.
inline std::string binaryStl(std::uint32_t count, const std::string& header = "") {
    std::string bytes = header;
    bytes.resize(80);
    bytes += raw(count);
    for (std::uint32_t i = 0; i < count; ++i)
        bytes += raw<float>({0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0}) + std::string(2, '\0');
    return bytes;
}

inline std::string ply(const std::string& format, const std::string& vertexProperties, const std::string& body,
                       int vertices = 4, int faces = 1) {
    return fmt::format(
        "ply\nformat {} 1.0\nelement vertex {}\n{}element face {}\nproperty list uchar int "
        "vertex_indices\nend_header\n{}",
        format, vertices, vertexProperties, faces, body);
}

inline const std::string floatXyz = "property float x\nproperty float y\nproperty float z\n";
inline const std::string squarePly = ply("ascii", floatXyz, "0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n");

inline std::string binarySquarePly() {
    return ply(
        "binary_little_endian", floatXyz,
        raw<float>({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}) + raw<std::uint8_t>(4) + raw<std::int32_t>({0, 1, 2, 3}));
}

class LoadPolygons : public testing::Test {
protected:
    [[nodiscard]] Scene::Data load(PolygonFormat format, const std::string& content) const {
        const fs::path file = folder_ / "model";
        put(file, content);
        return polygons::loadPolygons({file}, format);
    }
    [[nodiscard]] Scene::Data obj(const std::string& content) const { return load(PolygonFormat::Obj, content); }
    [[nodiscard]] Scene::Data stl(const std::string& content) const { return load(PolygonFormat::Stl, content); }
    [[nodiscard]] Scene::Data plyFile(const std::string& content) const { return load(PolygonFormat::Ply, content); }

    // The message with which content is refused, less the path and ": " that it starts with.
    [[nodiscard]] std::string refusal(PolygonFormat format, const std::string& content) const {
        const std::string start = (folder_ / "model").string() + ": ";
        std::string message;
        try {
            static_cast<void>(load(format, content));
            ADD_FAILURE() << "accepted: " << content.substr(0, 300);
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), Error::Kind::Input);
            message = error.what();
        }
        EXPECT_THAT(message, testing::AllOf(testing::StartsWith(start), testing::Not(testing::HasSubstr("\n"))));
        return message.substr(std::min(message.size(), start.size()));
    }

    TemporaryFolder folder_;
};

inline std::vector<glm::dvec3> corners(const Scene::Data& data) {
    const Mesh& mesh = data.meshes.at(0);
    std::vector<glm::dvec3> all;
    for (const std::uint32_t index : mesh.indices) all.push_back(mesh.origin + glm::dvec3{mesh.positions.at(index)});
    return all;
}

// The sum of the triangles' areas as vectors: the surface and its orientation, however it is cut.
inline glm::dvec3 area(const Scene::Data& data) {
    const std::vector<glm::dvec3> all = corners(data);
    glm::dvec3 sum{0.0};
    for (std::size_t i = 0; i < all.size(); i += 3) sum += 0.5 * glm::cross(all[i + 1] - all[i], all[i + 2] - all[i]);
    return sum;
}

inline double unsignedArea(const Scene::Data& data) {
    const std::vector<glm::dvec3> all = corners(data);
    double sum = 0.0;
    for (std::size_t i = 0; i < all.size(); i += 3)
        sum += 0.5 * glm::length(glm::cross(all[i + 1] - all[i], all[i + 2] - all[i]));
    return sum;
}

// An L with a corner on a straight side, at 1.
inline const std::string letterL = "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 2 1 0\nv 2 2 0\nv 1 2 0\nv 1 1 0\nv 0 1 0\n";

inline const std::vector<glm::dvec3> triangleCorners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

}  // namespace inkedge::polygon_files
