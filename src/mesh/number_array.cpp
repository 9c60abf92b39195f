#include "mesh/number_array.h"

#include <cstring>
#include <string>

#include <fmt/format.h>

#include "base/message.h"

namespace inkedge::mesh {
namespace {

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
    base::refuseUse("expected a type of numbers that NumberType has, found another");
}

}  // namespace

NumberArray::NumberArray(const ArrayView& view, std::string_view name)
    : view_{view},
      name_{name},
      columnStride_{view.columnStride != 0 ? view.columnStride : sizeOf(view.type)},
      rowStride_{view.rowStride != 0 ? view.rowStride : columnStride_ * static_cast<std::ptrdiff_t>(view.columns)} {
    if (view.rows > 0 && view.data == nullptr) base::refuseUse(fmt::format("{}: expected data, found none", name));
}

void NumberArray::expectReal() const {
    if (!empty() && !isReal(view_.type))
        base::refuseUse(fmt::format("{}: expected real numbers, found whole ones", name_));
}

void NumberArray::expectWhole() const {
    if (!empty() && isReal(view_.type))
        base::refuseUse(fmt::format("{}: expected whole numbers, found real ones", name_));
}

void NumberArray::expectColumns(std::size_t columns) const {
    if (!empty() && view_.columns != columns)
        base::refuseUse(fmt::format("{}: expected {} numbers a row, found {}", name_, columns, view_.columns));
}

void NumberArray::expectRows(std::size_t rows, std::string_view each) const {
    if (!empty() && view_.rows != rows)
        base::refuseUse(fmt::format("{}: expected {} rows, one {}, found {}", name_, rows, each, view_.rows));
}

double NumberArray::real(std::size_t row, std::size_t column) const {
    return view_.type == NumberType::Float32 ? double{read<float>(row, column)} : read<double>(row, column);
}

std::uint32_t NumberArray::whole(std::size_t row, std::size_t column, std::uint64_t end) const {
    const bool isSigned = view_.type == NumberType::Int32 || view_.type == NumberType::Int64;
    const std::uint64_t value = bits(row, column);
    if (isSigned && static_cast<std::int64_t>(value) < 0)
        base::refuseUse(fmt::format("{}: expected numbers from 0, found {} in row {}", name_,
                                    static_cast<std::int64_t>(value), row));
    if (value >= end)
        base::refuseUse(fmt::format("{}: expected numbers below {}, found {} in row {}", name_, end, value, row));
    return static_cast<std::uint32_t>(value);
}

template <class Number>
Number NumberArray::read(std::size_t row, std::size_t column) const {
    Number number{};
    const auto* const bytes = static_cast<const unsigned char*>(view_.data);
    std::memcpy(
        &number,
        bytes + static_cast<std::ptrdiff_t>(row) * rowStride_ + static_cast<std::ptrdiff_t>(column) * columnStride_,
        sizeof number);
    return number;
}

// Numbers under 0 have the bits of their 64.
std::uint64_t NumberArray::bits(std::size_t row, std::size_t column) const {
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

}  // namespace inkedge::mesh
