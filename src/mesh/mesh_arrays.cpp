#include <inkedge/mesh_arrays.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <inkedge/error.h>

namespace inkedge {
namespace {

[[noreturn]] void refuse(const std::string& message) { throw Error{Error::Kind::Usage, message}; }

bool isReal(NumberType type) { return type == NumberType::Float32 || type == NumberType::Float64; }

std::ptrdiff_t sizeOf(NumberType type) {
    switch (type) {
        case NumberType::UInt8:
            return 1;
        case NumberType::UInt16:
            return 2;
        case NumberType::Float32:
        case NumberType::UInt32:
        case NumberType::Int32:
            return 4;
        case NumberType::Float64:
        case NumberType::UInt64:
        case NumberType::Int64:
            return 8;
    }
    refuse("expected a type of numbers that NumberType has, found another");
}

// An array whose shape is as expected.
class Array {
public:
    Array(const ArrayView& view, std::string_view name)
        : view_{view},
          name_{name},
          columnStride_{view.columnStride != 0 ? view.columnStride : sizeOf(view.type)},
          rowStride_{view.rowStride != 0 ? view.rowStride : columnStride_ * static_cast<std::ptrdiff_t>(view.columns)} {
        if (view.rows > 0 && view.data == nullptr) refuse(fmt::format("{}: expected data, found none", name));
    }

    [[nodiscard]] bool empty() const { return view_.rows == 0; }
    [[nodiscard]] std::size_t rows() const { return view_.rows; }
    [[nodiscard]] std::size_t columns() const { return view_.columns; }

    void expectReal() const {
        if (!empty() && !isReal(view_.type)) refuse(fmt::format("{}: expected real numbers, found whole ones", name_));
    }
    void expectWhole() const {
        if (!empty() && isReal(view_.type)) refuse(fmt::format("{}: expected whole numbers, found real ones", name_));
    }
    void expectColumns(std::size_t columns) const {
        if (!empty() && view_.columns != columns)
            refuse(fmt::format("{}: expected {} numbers a row, found {}", name_, columns, view_.columns));
    }
    void expectRows(std::size_t rows, std::string_view each) const {
        if (!empty() && view_.rows != rows)
            refuse(fmt::format("{}: expected {} rows, one {}, found {}", name_, rows, each, view_.rows));
    }

    [[nodiscard]] double real(std::size_t row, std::size_t column) const {
        return view_.type == NumberType::Float32 ? double{read<float>(row, column)} : read<double>(row, column);
    }

    [[nodiscard]] glm::dvec3 vector(std::size_t row) const { return {real(row, 0), real(row, 1), real(row, 2)}; }

    /// @throws Error  if it is not below end
    [[nodiscard]] std::uint32_t whole(std::size_t row, std::size_t column, std::uint64_t end) const {
        const bool isSigned = view_.type == NumberType::Int32 || view_.type == NumberType::Int64;
        const std::uint64_t value = bits(row, column);
        if (isSigned && static_cast<std::int64_t>(value) < 0)
            refuse(fmt::format("{}: expected numbers from 0, found {} in row {}", name_,
                               static_cast<std::int64_t>(value), row));
        if (value >= end)
            refuse(fmt::format("{}: expected numbers below {}, found {} in row {}", name_, end, value, row));
        return static_cast<std::uint32_t>(value);
    }

private:
    template <class Number>
    [[nodiscard]] Number read(std::size_t row, std::size_t column) const {
        Number number{};
        const auto* const bytes = static_cast<const unsigned char*>(view_.data);
        std::memcpy(
            &number,
            bytes + static_cast<std::ptrdiff_t>(row) * rowStride_ + static_cast<std::ptrdiff_t>(column) * columnStride_,
            sizeof number);
        return number;
    }

    // Numbers under 0 have the bits of their 64.
    [[nodiscard]] std::uint64_t bits(std::size_t row, std::size_t column) const {
        switch (view_.type) {
            case NumberType::UInt8:
                return read<std::uint8_t>(row, column);
            case NumberType::UInt16:
                return read<std::uint16_t>(row, column);
            case NumberType::UInt32:
                return read<std::uint32_t>(row, column);
            case NumberType::Int32:
                return static_cast<std::uint64_t>(std::int64_t{read<std::int32_t>(row, column)});
            default:
                return read<std::uint64_t>(row, column);
        }
    }

    const ArrayView& view_;
    std::string_view name_;
    std::ptrdiff_t columnStride_;
    std::ptrdiff_t rowStride_;
};

constexpr std::uint64_t allNumbers = std::uint64_t{1} << 32U;

void readPositions(const Array& positions, Mesh& mesh) {
    positions.expectReal();
    positions.expectColumns(3);
    if (positions.rows() >= allNumbers)
        refuse(fmt::format("positions: expected fewer than {}, found {}", allNumbers, positions.rows()));
    glm::dvec3 low{std::numeric_limits<double>::max()};
    glm::dvec3 high{std::numeric_limits<double>::lowest()};
    for (std::size_t i = 0; i < positions.rows(); ++i) {
        const glm::dvec3 p = positions.vector(i);
        const double size = glm::max(glm::abs(p.x), glm::max(glm::abs(p.y), glm::abs(p.z)));
        if (!(size <= double{std::numeric_limits<float>::max()}) || std::isnan(p.x + p.y + p.z))
            refuse(fmt::format("positions: expected finite numbers, found ({}, {}, {}) in row {}", p.x, p.y, p.z, i));
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    if (!positions.empty()) mesh.origin = 0.5 * (low + high);
    mesh.positions.reserve(positions.rows());
    for (std::size_t i = 0; i < positions.rows(); ++i) mesh.positions.emplace_back(positions.vector(i) - mesh.origin);
}

void readIndices(const Array& indices, Mesh& mesh) {
    const std::size_t vertices = mesh.positions.size();
    if (indices.empty()) {
        for (std::uint32_t i = 0; i < vertices; ++i) mesh.indices.push_back(i);
        if (vertices % 3 != 0)
            refuse(fmt::format("positions: expected three a triangle, as there are no indices, found {}", vertices));
        return;
    }
    indices.expectWhole();
    if (indices.columns() != 1) indices.expectColumns(3);
    mesh.indices.reserve(indices.rows() * indices.columns());
    for (std::size_t row = 0; row < indices.rows(); ++row)
        for (std::size_t column = 0; column < indices.columns(); ++column)
            mesh.indices.push_back(indices.whole(row, column, vertices));
    if (mesh.indices.size() % 3 != 0)
        refuse(fmt::format("indices: expected three a triangle, found {}", mesh.indices.size()));
}

void readNormals(const Array& normals, Mesh& mesh) {
    normals.expectReal();
    normals.expectColumns(3);
    normals.expectRows(mesh.positions.size(), "a position");
    mesh.normals.reserve(normals.rows());
    for (std::size_t i = 0; i < normals.rows(); ++i) {
        const glm::dvec3 n = normals.vector(i);
        const double length = glm::length(n);
        if (!std::isfinite(length))
            refuse(fmt::format("normals: expected finite numbers, found ({}, {}, {}) in row {}", n.x, n.y, n.z, i));
        mesh.normals.emplace_back(length > 0.0 ? n / length : glm::dvec3{0.0});
    }
}

void readCoordinates(const Array& coordinates, Mesh& mesh) {
    coordinates.expectReal();
    coordinates.expectColumns(2);
    coordinates.expectRows(mesh.positions.size(), "a position");
    mesh.textureCoordinates.reserve(coordinates.rows());
    for (std::size_t i = 0; i < coordinates.rows(); ++i) {
        const glm::dvec2 c{coordinates.real(i, 0), coordinates.real(i, 1)};
        if (const glm::vec2 f{c}; !std::isfinite(f.x) || !std::isfinite(f.y))
            refuse(fmt::format("texture coordinates: expected finite numbers, found ({}, {}) in row {}", c.x, c.y, i));
        mesh.textureCoordinates.emplace_back(c);
    }
}

void readColors(const Array& colors, Mesh& mesh) {
    colors.expectReal();
    if (colors.columns() != 3) colors.expectColumns(4);
    colors.expectRows(mesh.positions.size(), "a position");
    mesh.paint.resize(colors.rows());
    for (std::size_t i = 0; i < colors.rows(); ++i)
        for (std::size_t c = 0; c < colors.columns(); ++c) {
            const double value = colors.real(i, c);
            if (!(value >= 0.0 && value <= 1.0))
                refuse(fmt::format("colors: expected numbers from 0 to 1, found {} in row {}", value, i));
            mesh.paint[i].color[static_cast<int>(c)] = static_cast<float>(value);
        }
}

// One number a triangle, or an index.
std::vector<std::uint32_t> readNumbers(const Array& numbers, std::size_t count, std::string_view each,
                                       std::uint64_t end) {
    numbers.expectWhole();
    numbers.expectColumns(1);
    numbers.expectRows(count, each);
    std::vector<std::uint32_t> all;
    all.reserve(numbers.rows());
    for (std::size_t i = 0; i < numbers.rows(); ++i) all.push_back(numbers.whole(i, 0, end));
    return all;
}

EdgeKinds kindsOf(std::uint32_t bits) {
    EdgeKinds kinds;
    for (const EdgeKind kind :
         {EdgeKind::Inner, EdgeKind::Sharp, EdgeKind::Tangent, EdgeKind::Seam, EdgeKind::Free, EdgeKind::Marked})
        if ((bits & static_cast<std::uint32_t>(kind)) != 0) kinds |= kind;
    return kinds;
}

}  // namespace

Mesh makeMesh(const MeshArrays& arrays) {
    constexpr std::uint64_t allKinds = 2 * static_cast<std::uint64_t>(EdgeKind::Marked);
    Mesh mesh;
    mesh.name = arrays.name;
    readPositions({arrays.positions, "positions"}, mesh);
    readIndices({arrays.indices, "indices"}, mesh);
    readNormals({arrays.normals, "normals"}, mesh);
    readCoordinates({arrays.textureCoordinates, "texture coordinates"}, mesh);
    readColors({arrays.colors, "colors"}, mesh);
    const std::size_t triangles = mesh.indices.size() / 3;
    mesh.materials = readNumbers({arrays.materials, "materials"}, triangles, "a triangle", allNumbers);
    mesh.faces = readNumbers({arrays.faces, "faces"}, triangles, "a triangle", allNumbers);
    for (const std::uint32_t bits : readNumbers({arrays.edges, "edges"}, 3 * triangles, "an index", allKinds))
        mesh.edges.push_back(kindsOf(bits));
    return mesh;
}

}  // namespace inkedge
