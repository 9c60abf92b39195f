#include "formats/polygons/load_polygons.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/message.h"
#include "base/read_file.h"
#include "formats/polygons/obj.h"
#include "formats/polygons/ply.h"
#include "formats/polygons/polygon_file.h"
#include "formats/polygons/polygons.h"
#include "formats/polygons/stl.h"
#include "formats/text.h"

namespace inkedge::polygons {
namespace {

// A file that is too large is refused by its start, before it takes memory.
void expectStartWithin(const formats::ModelInput& input, PolygonFormat format, const LoadLimits& limits) {
    if (!input.isFile() || format == PolygonFormat::Obj) return;
    constexpr std::size_t longestHeader = std::size_t{1} << 16U;
    const base::Bytes start = formats::startOf(input, longestHeader);
    std::error_code failure;
    const std::uint64_t size = std::filesystem::file_size(input.name, failure);
    if (failure || size > limits.fileSize) return;  // what reads it says so
    if (format == PolygonFormat::Stl)
        expectStlWithin(start, size, limits.vertices);
    else
        expectPlyWithin(base::textOf(start), limits.vertices);
}

PolygonFile readFile(const formats::ModelInput& input, PolygonFormat format, const LoadLimits& limits,
                     Coordinates coordinates) {
    std::uint64_t bytesLeft = limits.fileSize;
    expectStartWithin(input, format, limits);
    const formats::Content content{input, bytesLeft};
    const std::span<const std::uint8_t> bytes = content.bytes();
    switch (format) {
        case PolygonFormat::Obj:
            return readObj(base::textOf(bytes), coordinates, limits.vertices);
        case PolygonFormat::Stl:
            return readStl(bytes, limits.vertices);
        case PolygonFormat::Ply:
            return readPly(base::textOf(bytes), coordinates, limits.vertices);
    }
    return {};
}

glm::vec3 unitOrZero(const glm::vec3& v) {
    const glm::dvec3 exact{v};
    const double length = glm::length(exact);
    return length > 0.0 && std::isfinite(length) ? glm::vec3{exact / length} : glm::vec3{0.0F};
}

// Makes the mesh of a file.
class Builder {
public:
    Builder(PolygonFile file, PolygonFormat format) : file_{std::move(file)}, format_{format} {}

    Scene::Data build(const std::string& name, std::uint64_t maxElements) {
        if (vertexCount() + file_.corners.size() + file_.lines.size() > maxElements)
            base::refuse(
                fmt::format("expected at most {} vertices, corners and ends of lines, found more; raise max-vertices",
                            maxElements));
        measure();
        checkIndices();
        checkCoordinates();
        file_.faceSizes.empty() ? takeTriangles() : cutPolygons();
        convertPositions();
        takeLines();
        takeNormals();
        mesh_.textureCoordinates = std::move(file_.textureCoordinates);
        mesh_.name = name;
        warn();
        if (mesh_.indices.empty() && mesh_.lines.empty()) {
            data_.undrawn = whatIsThere();
        } else {
            data_.meshes.push_back(std::move(mesh_));
            data_.instances.push_back({name, 0, glm::dmat4{1.0}});
        }
        return std::move(data_);
    }

private:
    [[nodiscard]] bool isFine() const { return !file_.finePositions.empty(); }
    [[nodiscard]] std::size_t vertexCount() const {
        return isFine() ? file_.finePositions.size() : file_.positions.size();
    }
    [[nodiscard]] glm::dvec3 position(std::size_t i) const {
        return isFine() ? file_.finePositions[i] : glm::dvec3{file_.positions[i]};
    }

    // ---- what is there

    void measure() {
        for (std::size_t i = 0; i < vertexCount(); ++i) {
            const glm::dvec3 p = position(i);
            const double size = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
            if (!(size <= double{std::numeric_limits<float>::max()}) || std::isnan(p.x + p.y + p.z))
                base::refuse(
                    fmt::format("expected finite positions, found ({}, {}, {}) at vertex {}", p.x, p.y, p.z, i));
            low_ = glm::min(low_, p);
            high_ = glm::max(high_, p);
        }
        constexpr double visible = 1e-5;  // of the diagonal
        const bool coarse = vertexCount() > 0 && spacing() > visible * glm::distance(low_, high_);
        warnsOfFloats_ = coarse && !isFine();
        if (!coarse && isFine()) roundPositions();
    }

    // Where floats are precise enough, so that a file of text and one of floats give the same mesh.
    void roundPositions() {
        file_.positions.reserve(file_.finePositions.size());
        for (const glm::dvec3& p : file_.finePositions) file_.positions.emplace_back(p);
        file_.finePositions = {};
        low_ = glm::dvec3{std::numeric_limits<double>::max()};
        high_ = glm::dvec3{std::numeric_limits<double>::lowest()};
        // From the rounded floats: the origin must be the same as that of a file of floats.
        for (const glm::vec3& p : file_.positions) {
            low_ = glm::min(low_, glm::dvec3{p});
            high_ = glm::max(high_, glm::dvec3{p});
        }
    }

    // The spacing of floats at the vertices.
    [[nodiscard]] double spacing() const {
        const glm::dvec3 largest = glm::max(glm::abs(low_), glm::abs(high_));
        return std::max({largest.x, largest.y, largest.z}) * double{std::numeric_limits<float>::epsilon()};
    }

    [[nodiscard]] std::size_t sizeOf(std::size_t face) const {
        return file_.faceSizes.empty() ? 3 : file_.faceSizes[face];
    }

    void checkIndices() const {
        const std::size_t count = vertexCount();
        std::size_t corner = 0;
        for (std::size_t face = 0; face < file_.faceCount; ++face)
            for (const std::size_t end = corner + sizeOf(face); corner < end; ++corner)
                if (file_.corners[corner] >= count)
                    base::refuse(fmt::format("expected vertices below {}, found {} in face {}", count,
                                             file_.corners[corner], face));
        for (std::size_t end = 0; end < file_.lines.size(); ++end)
            if (file_.lines[end] >= count)
                base::refuse(
                    fmt::format("expected vertices below {}, found {} in line {}", count, file_.lines[end], end / 2));
    }

    void checkCoordinates() const {
        for (std::size_t i = 0; i < file_.textureCoordinates.size(); ++i)
            if (const glm::vec2 c = file_.textureCoordinates[i]; !std::isfinite(c.x) || !std::isfinite(c.y))
                base::refuse(fmt::format("expected finite texture coordinates, found ({}, {}) at vertex {}", c.x,
                                         1.0F - c.y, i));
    }

    // ---- faces

    void addTriangle(std::size_t face, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        mesh_.indices.insert(mesh_.indices.end(), {a, b, c});
        if (!file_.faceMaterials.empty()) mesh_.materials.push_back(file_.faceMaterials[face]);
    }

    // Whether triangles with a repeated vertex are left out. OBJ and STL keep them: their corners have vertices of
    // their own.
    [[nodiscard]] bool leavesOutRepeats() const { return format_ == PolygonFormat::Ply; }

    // Makes the file's corners the indices, without a copy unless a triangle repeats a vertex.
    void takeTriangles() {
        std::vector<std::uint32_t> corners = std::move(file_.corners);
        const auto repeats = [&](std::size_t t) {
            return leavesOutRepeats() &&
                   (corners[t] == corners[t + 1] || corners[t + 1] == corners[t + 2] || corners[t + 2] == corners[t]);
        };
        std::size_t first = 0;
        while (first < corners.size() && !repeats(first)) first += 3;
        if (first == corners.size()) {
            mesh_.indices = std::move(corners);
            mesh_.materials = std::move(file_.faceMaterials);
            return;
        }
        for (std::size_t t = 0; t < corners.size(); t += 3)
            if (!repeats(t)) addTriangle(t / 3, corners[t], corners[t + 1], corners[t + 2]);
    }

    void cutPolygons() {
        mesh_.indices.reserve(file_.corners.size());
        PolygonCutter cutter;
        std::vector<glm::dvec3> points;
        std::size_t first = 0;
        for (std::size_t face = 0; face < file_.faceCount; first += sizeOf(face), ++face) {
            const std::span<const std::uint32_t> corners{&file_.corners[first], sizeOf(face)};
            points.clear();
            for (const std::uint32_t corner : corners) points.push_back(position(corner));
            for (const PolygonCutter::Triangle& t : cutter.cut(points)) addPart(face, corners, t);
        }
    }

    // Adds a triangle of a face. An edge that does not lead to the next corner of the face only cuts the face.
    void addPart(std::size_t face, std::span<const std::uint32_t> corners, const PolygonCutter::Triangle& part) {
        const std::uint32_t a = corners[part[0]];
        const std::uint32_t b = corners[part[1]];
        const std::uint32_t c = corners[part[2]];
        if (leavesOutRepeats() && (a == b || b == c || c == a)) return;
        addTriangle(face, a, b, c);
        for (std::size_t i = 0; i < 3; ++i) {
            const bool cuts = part[(i + 1) % 3] != (part[i] + 1) % corners.size();
            mesh_.edges.push_back(cuts ? EdgeKinds{EdgeKind::Inner} : EdgeKinds{});
        }
    }

    // ---- vertices

    void convertPositions() {
        if (vertexCount() == 0) return;
        mesh_.origin = 0.5 * (low_ + high_);
        const std::size_t count = vertexCount();
        std::vector<glm::vec3> converted(isFine() ? count : 0);
        std::vector<glm::vec3>& to = isFine() ? converted : file_.positions;
        for (std::size_t i = 0; i < count; ++i) to[i] = glm::vec3{position(i) - mesh_.origin};
        mesh_.positions = std::move(to);
        file_.finePositions = {};
    }

    void takeLines() {
        mesh_.lines.reserve(file_.lines.size());
        for (const std::uint32_t end : file_.lines) mesh_.lines.push_back(mesh_.positions[end]);
        file_.lines = {};
    }

    void takeNormals() {
        if (format_ == PolygonFormat::Stl) return;
        mesh_.normals = std::move(file_.normals);
        for (glm::vec3& normal : mesh_.normals) normal = unitOrZero(normal);
        if (std::ranges::all_of(mesh_.normals, [](const glm::vec3& n) { return n == glm::vec3{0.0F}; }))
            mesh_.normals.clear();
    }

    // ---- after it

    [[nodiscard]] std::vector<std::string> whatIsThere() const {
        std::vector<std::string> found;
        if (file_.points > 0) found.push_back(formats::counted(file_.points, "point"));
        if (file_.faceCount > 0) found.push_back(formats::counted(file_.faceCount, "face") + " of repeated vertices");
        return found;
    }

    void warn() {
        data_.warnings = std::move(file_.warnings);
        if (file_.points > 0)
            data_.warnings.push_back(formats::counted(file_.points, "point") +
                                     (file_.points == 1 ? " is not drawn" : " are not drawn"));
        if (!warnsOfFloats_) return;
        data_.warnings.push_back(fmt::format(
            "coordinates are kept to {:.2g}, as {} files are read as floats: much for a model {:.3g} across "
            "that far from the origin",
            spacing(), name(format_), glm::distance(low_, high_)));
    }

    PolygonFile file_;
    PolygonFormat format_;
    glm::dvec3 low_{std::numeric_limits<double>::max()};
    glm::dvec3 high_{std::numeric_limits<double>::lowest()};
    bool warnsOfFloats_ = false;  // so far from the origin floats are too coarse for the model
    Mesh mesh_;
    Scene::Data data_;
};

}  // namespace

Scene::Data loadPolygons(const formats::ModelInput& input, PolygonFormat format, const LoadLimits& limits,
                         Coordinates coordinates) {
    return base::within(input.where(), [&] {
        try {
            return Builder{readFile(input, format, limits, coordinates), format}.build(input.name.stem().string(),
                                                                                       limits.vertices);
        } catch (const std::bad_alloc&) {
            base::refuse("expected a model that fits into memory, found one that does not");
        }
    });
}

}  // namespace inkedge::polygons
