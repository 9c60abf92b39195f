#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include <glm/vec3.hpp>

#include <inkedge/mesh_arrays.h>

namespace inkedge::mesh {

/// An array that is not ours, and its name for messages. What it is expected to be is Error (Kind::Usage) if it is not;
/// an array of no rows is always as expected. The view must outlive it.
class NumberArray {
public:
    NumberArray(const ArrayView&, std::string_view name);

    [[nodiscard]] bool empty() const { return view_.rows == 0; }
    [[nodiscard]] std::size_t rows() const { return view_.rows; }
    [[nodiscard]] std::size_t columns() const { return view_.columns; }

    void expectReal() const;
    void expectWhole() const;
    void expectColumns(std::size_t columns) const;
    /// @param each  what there is a row for: "a position"
    void expectRows(std::size_t rows, std::string_view each) const;

    [[nodiscard]] double real(std::size_t row, std::size_t column) const;
    [[nodiscard]] glm::dvec3 vector(std::size_t row) const { return {real(row, 0), real(row, 1), real(row, 2)}; }
    /// @throws Error  (Kind::Usage) if it is not below end
    [[nodiscard]] std::uint32_t whole(std::size_t row, std::size_t column, std::uint64_t end) const;

private:
    template <class Number>
    [[nodiscard]] Number read(std::size_t row, std::size_t column) const;
    [[nodiscard]] std::uint64_t bits(std::size_t row, std::size_t column) const;

    const ArrayView& view_;
    std::string_view name_;
    std::ptrdiff_t columnStride_;
    std::ptrdiff_t rowStride_;
};

}  // namespace inkedge::mesh
