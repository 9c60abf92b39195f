#include "formats/polygons/load_assimp.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <string>
#include <vector>

#include <assimp/scene.h>
#include <fmt/format.h>
#include <assimp/IOSystem.hpp>
#include <assimp/Importer.hpp>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/read_file.h"
#include "base/message.h"
#include "formats/polygons/obj.h"
#include "formats/polygons/ply.h"
#include "formats/polygons/polygons.h"
#include "formats/polygons/stl.h"

namespace inkedge {
namespace {

using load::Coordinates;
using load::label;
using load::PolygonFormat;
using load::refuse;
using load::within;

// Has no files: of material libraries and the like only the names are known.
class NoFiles : public Assimp::IOSystem {
public:
    bool Exists(const char*) const override { return false; }
    char getOsSeparator() const override { return '/'; }
    Assimp::IOStream* Open(const char*, const char*) override { return nullptr; }
    void Close(Assimp::IOStream*) override {}
};

// By its extension assimp chooses the reader.
const char* extensionOf(PolygonFormat format) noexcept {
    switch (format) {
        case PolygonFormat::Obj:
            return "obj";
        case PolygonFormat::Stl:
            return "stl";
        case PolygonFormat::Ply:
            return "ply";
    }
    return "";
}

// The importer owns the scene.
const aiScene& import(Assimp::Importer& importer, const load::Bytes& bytes, PolygonFormat format) {
    importer.SetIOHandler(new NoFiles);  // which it deletes
    const aiScene* const scene = importer.ReadFileFromMemory(bytes.data(), bytes.size(), 0, extensionOf(format));
    if (scene == nullptr)
        refuse(fmt::format("expected {}, found: {}", name(format), load::quote(importer.GetErrorString())));
    return *scene;
}

glm::dvec3 toVector(const aiVector3D& v) { return {v.x, v.y, v.z}; }

bool finite(const aiVector3D& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

std::span<const aiVector3D> positionsOf(const aiMesh& mesh) {
    return {mesh.mVertices, mesh.mVertices == nullptr ? 0 : mesh.mNumVertices};
}

std::span<const aiFace> facesOf(const aiMesh& mesh) {
    return {mesh.mFaces, mesh.mFaces == nullptr ? 0 : mesh.mNumFaces};
}

glm::vec3 unitOrZero(const aiVector3D& v) {
    const double length = glm::length(toVector(v));
    return length > 0.0 && std::isfinite(length) ? glm::vec3{toVector(v) / length} : glm::vec3{0.0F};
}

// A file's content in a form that assimp may be trusted with: version 5.2 crashes or hangs on many a malformed file.
// What assimp need not know stands beside it.
struct Content {
    load::Bytes bytes;
    std::vector<std::uint32_t> faceMaterials;  // one a face, or none
    std::uint64_t points = 0;
    std::uint64_t lines = 0;
    bool finerThanFloat = false;  // the file's coordinates
};

// @param origin  taken off all positions
Content readContent(const std::filesystem::path& file, PolygonFormat format, const LoadLimits& limits,
                    const glm::dvec3& origin, Coordinates coordinates) {
    std::uint64_t bytesLeft = limits.fileSize;
    Content content;
    content.bytes = load::readBytes(file, bytesLeft);
    if (format == PolygonFormat::Obj) {
        load::ObjContent obj = load::checkedObj(load::textOf(content.bytes), origin, coordinates);
        return {std::move(obj.text), std::move(obj.faceMaterials), obj.points, obj.lines, true};
    }
    if (format == PolygonFormat::Stl) content.bytes = load::safeStl(std::move(content.bytes));
    if (format == PolygonFormat::Ply) {
        load::PlyContent ply = load::safePly(load::textOf(content.bytes), origin, coordinates);
        content.bytes = std::move(ply.bytes);
        content.finerThanFloat = ply.finerThanFloat;
    }
    return content;
}

std::string warningOf(std::uint64_t points, std::uint64_t lines) {
    return fmt::format("{} points and {} lines are not drawn", points, lines);
}

Scene::Data withoutFaces(const Content& content) {
    if (content.points + content.lines == 0) refuse("expected faces, found none");
    Scene::Data data;
    data.warnings.push_back(warningOf(content.points, content.lines));
    return data;
}

// Makes one mesh of all of a file's.
class Joiner {
public:
    Joiner(const aiScene& source, PolygonFormat format, const Content& content, const LoadLimits& limits)
        : source_{source},
          format_{format},
          faceMaterials_{content.faceMaterials},
          points_{content.points},
          lines_{content.lines},
          most_{limits.vertices} {}

    Scene::Data join(const std::string& name) {
        mesh_.name = name;
        forEachMesh([&](const aiMesh& mesh) { measure(mesh); });
        if (!faceMaterials_.empty() && faceCount_ != faceMaterials_.size())
            refuse(fmt::format("expected {} faces, found {}", faceMaterials_.size(), faceCount_));
        if (vertexCount_ > 0) mesh_.origin = centre();
        mesh_.positions.reserve(vertexCount_);
        mesh_.indices.reserve(cornerCount_);
        forEachMesh([&](const aiMesh& mesh) { add(mesh); });
        warn();
        dropWhatSaysNothing();
        if (!mesh_.indices.empty()) {
            data_.meshes.push_back(std::move(mesh_));
            data_.instances.push_back({name, 0, glm::dmat4{1.0}});
        }
        data_.source.format = load::name(format_);
        return std::move(data_);
    }

    // Whether floats that far from the origin cannot tell the model's points apart well enough.
    [[nodiscard]] bool coarse() const {
        constexpr double visible = 1e-5;  // of the diagonal
        return vertexCount_ > 0 && spacing() > visible * glm::distance(low_, high_);
    }
    [[nodiscard]] glm::dvec3 centre() const { return 0.5 * (low_ + high_); }

private:
    template <class Action>
    void forEachMesh(Action&& action) const {
        for (unsigned int i = 0; i < source_.mNumMeshes; ++i)
            within(label("mesh", i, source_.mMeshes[i]->mName.C_Str()), [&] { action(*source_.mMeshes[i]); });
    }

    // ---- before anything is copied

    void measure(const aiMesh& mesh) {
        const std::span<const aiVector3D> positions = positionsOf(mesh);
        for (std::size_t i = 0; i < positions.size(); ++i) {
            const aiVector3D& p = positions[i];
            if (!finite(p))
                refuse(fmt::format("expected finite positions, found ({}, {}, {}) at vertex {}", p.x, p.y, p.z, i));
            low_ = glm::min(low_, toVector(p));
            high_ = glm::max(high_, toVector(p));
        }
        vertexCount_ += positions.size();
        faceCount_ += facesOf(mesh).size();
        for (const aiFace& face : facesOf(mesh)) cornerCount_ += face.mNumIndices;
        if (vertexCount_ + cornerCount_ > most_)
            refuse(fmt::format("expected at most {} vertices and corners, found more; raise max-vertices", most_));
        authored_ = authored_ || (mesh.mNormals != nullptr && format_ != PolygonFormat::Stl);
    }

    // ---- the copy

    void add(const aiMesh& mesh) {
        const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
        for (const aiVector3D& position : positionsOf(mesh))
            mesh_.positions.emplace_back(toVector(position) - mesh_.origin);
        if (authored_) addNormals(mesh);
        addCoordinates(mesh);
        const std::span<const aiFace> faces = facesOf(mesh);
        for (std::size_t i = 0; i < faces.size(); ++i) {
            addFace(mesh, i, first);
            mesh_.materials.resize(mesh_.indices.size() / 3, faceMaterials_.empty() ? 0 : faceMaterials_[face_]);
            ++face_;
        }
        if (faces.empty()) points_ += mesh.mNumVertices;  // a PLY file of points alone
    }

    void addNormals(const aiMesh& mesh) {
        for (unsigned int i = 0; mesh.mNormals != nullptr && i < positionsOf(mesh).size(); ++i)
            mesh_.normals.push_back(unitOrZero(mesh.mNormals[i]));
        mesh_.normals.resize(mesh_.positions.size());
    }

    void addCoordinates(const aiMesh& mesh) {
        const aiVector3D* const coordinates = mesh.mTextureCoords[0];
        if (coordinates == nullptr && mesh_.textureCoordinates.empty()) return;
        mesh_.textureCoordinates.resize(mesh_.positions.size() - positionsOf(mesh).size());
        for (std::size_t i = 0; coordinates != nullptr && i < positionsOf(mesh).size(); ++i) {
            if (!std::isfinite(coordinates[i].x) || !std::isfinite(coordinates[i].y))
                refuse(fmt::format("expected finite texture coordinates, found ({}, {}) at vertex {}", coordinates[i].x,
                                   coordinates[i].y, i));
            mesh_.textureCoordinates.emplace_back(coordinates[i].x, 1.0F - coordinates[i].y);
        }
        mesh_.textureCoordinates.resize(mesh_.positions.size());
    }

    void addFace(const aiMesh& mesh, std::size_t number, std::uint32_t first) {
        const aiFace& face = mesh.mFaces[number];
        for (unsigned int i = 0; i < face.mNumIndices; ++i)
            if (face.mIndices[i] >= mesh.mNumVertices)
                refuse(fmt::format("expected vertices below {}, found {} in face {}", mesh.mNumVertices,
                                   face.mIndices[i], number));
        if (face.mNumIndices == 3) return addTriangle(face, {0, 1, 2}, first);
        mesh_.edges.resize(mesh_.indices.size());
        if (face.mNumIndices < 3) {
            ++(face.mNumIndices == 2 ? lines_ : points_);
            return;
        }
        corners_.clear();
        for (unsigned int i = 0; i < face.mNumIndices; ++i)
            corners_.push_back(toVector(mesh.mVertices[face.mIndices[i]]));
        for (const load::PolygonCutter::Triangle& triangle : cutter_.cut(corners_)) addTriangle(face, triangle, first);
    }

    void addTriangle(const aiFace& face, const load::PolygonCutter::Triangle& corners, std::uint32_t first) {
        const std::uint32_t a = face.mIndices[corners[0]];
        const std::uint32_t b = face.mIndices[corners[1]];
        const std::uint32_t c = face.mIndices[corners[2]];
        if (a == b || b == c || c == a) return;
        mesh_.indices.insert(mesh_.indices.end(), {first + a, first + b, first + c});
        if (face.mNumIndices == 3) return;
        for (std::size_t i = 0; i < 3; ++i)
            mesh_.edges.push_back(corners[(i + 1) % 3] != (corners[i] + 1) % face.mNumIndices ? EdgeKind::Inner
                                                                                              : EdgeKinds{});
    }

    // ---- after it

    void warn() {
        if (points_ + lines_ > 0) data_.warnings.push_back(warningOf(points_, lines_));
        if (!coarse()) return;
        data_.warnings.push_back(fmt::format(
            "coordinates are kept to {:.2g}, as {} files are read as floats: much for a model {:.3g} across "
            "that far from the origin",
            spacing(), name(format_), glm::distance(low_, high_)));
    }

    // Of floats as far off as the vertices.
    [[nodiscard]] double spacing() const {
        const glm::dvec3 largest = glm::max(glm::abs(low_), glm::abs(high_));
        return std::max({largest.x, largest.y, largest.z}) * double{std::numeric_limits<float>::epsilon()};
    }

    void dropWhatSaysNothing() {
        if (!mesh_.edges.empty()) mesh_.edges.resize(mesh_.indices.size());
        if (std::ranges::all_of(mesh_.materials, [](std::uint32_t material) { return material == 0; }))
            mesh_.materials.clear();
        if (std::ranges::all_of(mesh_.normals, [](const glm::vec3& normal) { return normal == glm::vec3{0.0F}; }))
            mesh_.normals.clear();
    }

    const aiScene& source_;
    PolygonFormat format_;
    const std::vector<std::uint32_t>& faceMaterials_;
    std::uint64_t points_;
    std::uint64_t lines_;
    std::uint64_t most_;    // vertices and corners
    std::size_t face_ = 0;  // the next, of all meshes
    glm::dvec3 low_{std::numeric_limits<double>::max()};
    glm::dvec3 high_{std::numeric_limits<double>::lowest()};
    std::uint64_t vertexCount_ = 0;
    std::uint64_t cornerCount_ = 0;
    std::uint64_t faceCount_ = 0;
    bool authored_ = false;
    std::vector<glm::dvec3> corners_;  // of the polygon at hand
    load::PolygonCutter cutter_;
    Mesh mesh_;
    Scene::Data data_;
};

}  // namespace

bool readsPolygonFormats() noexcept { return true; }

Scene::Data loadAssimp(const std::filesystem::path& file, PolygonFormat format, const LoadLimits& limits,
                       Coordinates coordinates) {
    return within(load::printable(file.string()), [&] {
        try {
            glm::dvec3 origin{0.0};
            for (;;) {
                const Content content = readContent(file, format, limits, origin, coordinates);
                if (format == PolygonFormat::Obj && content.faceMaterials.empty()) return withoutFaces(content);
                Assimp::Importer importer;
                Joiner joiner{import(importer, content.bytes, format), format, content, limits};
                Scene::Data data = joiner.join(file.stem().string());
                if (origin == glm::dvec3{0.0} && content.finerThanFloat && joiner.coarse()) {
                    origin = joiner.centre();  // once more, from near by
                    continue;
                }
                for (Mesh& mesh : data.meshes) mesh.origin += origin;
                return data;
            }
        } catch (const Error&) {
            throw;
        } catch (const std::bad_alloc&) {
            refuse("expected a model that fits into memory, found one that does not");
        } catch (const std::exception& error) {
            refuse(fmt::format("expected {}, found: {}", name(format), load::printable(error.what())));
        }
    });
}

}  // namespace inkedge
