#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include <inkedge/export.h>
#include <inkedge/mesh.h>

namespace inkedge {

/// The type of an array's numbers, in the machine's byte order.
enum class NumberType { Float32, Float64, UInt8, UInt16, UInt32, UInt64, Int32, Int64 };

/// A table of numbers in memory that is not ours, as numpy and vertex buffers hold them. Nothing need be aligned.
struct ArrayView {
    const void* data = nullptr;  ///< the number in row 0 and column 0
    NumberType type = NumberType::Float32;
    std::size_t rows = 0;          ///< 0: there is no such array
    std::size_t columns = 1;       ///< numbers a row
    std::ptrdiff_t rowStride = 0;  ///< bytes from a number to that of the next row; may be under 0. 0: rows are packed
    std::ptrdiff_t columnStride = 0;  ///< bytes from a number to that of the next column; 0: packed
};

/// The arrays that a mesh is made of. An array of no rows is left out; the others have as many rows as is said.
struct MeshArrays {
    std::string name;
    ArrayView positions;  ///< vertices x 3, real numbers, finite, in mesh space
    /// Triangles x 3, whole numbers, into positions; a flat list, 3 triangles x 1, will do. None: each three positions
    /// are a triangle.
    ArrayView indices;
    ArrayView normals;             ///< vertices x 3, real numbers; brought to unit length; (0, 0, 0): none
    ArrayView textureCoordinates;  ///< vertices x 2, real numbers, finite; v = 0 at the top of the picture
    ArrayView colors;              ///< vertices x 3 or 4, real numbers, linear, 0 to 1: Mesh::paint
    ArrayView materials;           ///< triangles, whole numbers: 1 + into Scene::Data::materials; 0: none
    ArrayView faces;               ///< triangles, whole numbers: the face that each is a part of, in any numbering
    ArrayView edges;               ///< indices (3 triangles), whole numbers: bits of EdgeKind; Mesh::edges
};

/// Copies the arrays into a mesh. Its origin is the middle of its box, so that doubles far from the origin keep their
/// precision.
/// @throws Error  (Kind::Usage) if an array has another shape or other numbers than is said, or no data, or a number is
///                out of range; the message names the array, and the row where there is one
[[nodiscard]] INKEDGE_API Mesh makeMesh(const MeshArrays&);

}  // namespace inkedge
