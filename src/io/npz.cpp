#include "io/npz.h"

#include <algorithm>
#include <bit>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <inkedge/error.h>

#include "base/byte_writer.h"
#include "io/metadata.h"

// After NumPy's "NEP 1: A simple file format for NumPy arrays".

namespace inkedge::io {
namespace {

std::string shapeText(const std::vector<std::size_t>& shape) {
    return fmt::format("({}{})", fmt::join(shape, ", "), shape.size() == 1 ? "," : "");
}

// What stands before an array's values, after the lengths and with them a multiple of 64 bytes.
std::string npyHeader(const std::string& type, const std::vector<std::size_t>& shape, std::size_t before) {
    constexpr std::size_t multiple = 64;
    std::string text = fmt::format("{{'descr': '{}{}', 'fortran_order': False, 'shape': {}, }}",
                                   type == "u1" ? '|' : '<', type, shapeText(shape));
    text.append(multiple - 1 - (before + text.size()) % multiple, ' ');
    return text + '\n';
}

std::u32string codePoints(std::string_view text) {
    const std::string valid = Json::parse(textOf(std::string{text}, -1)).get<std::string>();
    std::u32string points;
    for (const char c : valid) {
        const auto byte = static_cast<unsigned char>(c);
        if ((byte & 0xC0U) == 0x80U)
            points.back() = points.back() << 6U | (byte & 0x3FU);
        else
            points += byte < 0x80U ? byte : byte < 0xE0U ? byte & 0x1FU : byte < 0xF0U ? byte & 0x0FU : byte & 0x07U;
    }
    return points;
}

}  // namespace

void NpzWriter::addBytes(std::string_view name, const std::string& type, const std::vector<std::size_t>& shape,
                         std::span<const std::uint8_t> values) {
    static_assert(std::endian::native == std::endian::little, "the file's bytes are those in memory");
    constexpr std::string_view version1{"\x93NUMPY\x01\x00", 8};
    const std::string header = npyHeader(type, shape, version1.size() + sizeof(std::uint16_t));
    base::ByteWriter npy;
    npy.reserve(version1.size() + sizeof(std::uint16_t) + header.size() + values.size());
    npy.text(version1);
    npy.number(static_cast<std::uint16_t>(header.size()));
    npy.text(header);
    npy.bytes(values);
    zip_.add(fmt::format("{}.npy", name), std::move(npy).take());
}

void NpzWriter::addTexts(std::string_view name, std::span<const std::string> texts) {
    constexpr std::size_t maxBytes = std::size_t{1} << 30U;
    std::vector<std::u32string> all;
    std::size_t longest = 1;
    for (const std::string& text : texts) longest = std::max(longest, all.emplace_back(codePoints(text)).size());
    if (all.size() * longest * sizeof(char32_t) > maxBytes)
        throw Error{Error::Kind::Output,
                    fmt::format("{}: expected names that take at most {} bytes as an array, found {} of up to {} "
                                "characters; leave ids out of the maps, or write an .exr",
                                name, maxBytes, all.size(), longest)};
    std::u32string values;
    for (std::u32string& text : all) values += text.append(longest - text.size(), U'\0');
    addBytes(name, fmt::format("U{}", longest), {all.size()},
             {reinterpret_cast<const std::uint8_t*>(values.data()), values.size() * sizeof(char32_t)});
}

}  // namespace inkedge::io
