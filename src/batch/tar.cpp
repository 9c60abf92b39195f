#include "batch/tar.h"

#include <sys/types.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <optional>

#include <fmt/format.h>

namespace inkedge::batch {
namespace {

using Block = std::array<std::uint8_t, tarBlock>;

// Where the fields of a header begin, and how long they are.
struct Field {
    std::size_t at;
    std::size_t size;
};
constexpr Field nameField{0, 100};
constexpr Field modeField{100, 8};
constexpr Field sizeField{124, 12};
constexpr Field checksumField{148, 8};
constexpr std::size_t typeAt = 156;
constexpr Field magicField{257, 8};
constexpr char plainFile = '0';
constexpr char extendedHeader = 'x';
constexpr std::uint64_t maxPlainSize = (std::uint64_t{1} << 33U) - 1;  // 11 octal digits

constexpr std::uint64_t padded(std::uint64_t size) { return (size + tarBlock - 1) / tarBlock * tarBlock; }

void put(Block& block, Field field, std::string_view text) {
    std::memcpy(block.data() + field.at, text.data(), std::min(text.size(), field.size));
}

std::string octal(std::uint64_t value, std::size_t digits) { return fmt::format("{:0{}o}", value, digits); }

unsigned checksumOf(const Block& block) {
    unsigned sum = 0;
    for (std::size_t i = 0; i < block.size(); ++i) {
        const bool own = i >= checksumField.at && i < checksumField.at + checksumField.size;
        sum += own ? ' ' : block[i];
    }
    return sum;
}

Block headerOf(std::string_view name, std::uint64_t size, char type) {
    Block block{};
    put(block, nameField, name);
    put(block, modeField, octal(0644, 7));
    put(block, {108, 8}, octal(0, 7));
    put(block, {116, 8}, octal(0, 7));
    put(block, sizeField, octal(std::min(size, maxPlainSize), 11));
    put(block, {136, 12}, octal(0, 11));
    block[typeAt] = static_cast<std::uint8_t>(type);
    put(block, magicField, {"ustar\00000", 8});
    put(block, checksumField, octal(checksumOf(block), 6));
    return block;
}

// "LENGTH key=value\n", where the length counts its own digits.
std::string record(std::string_view key, std::string_view value) {
    const std::size_t rest = key.size() + value.size() + 3;
    std::size_t length = rest + 1;
    while (length != rest + std::to_string(length).size()) length = rest + std::to_string(length).size();
    return fmt::format("{} {}={}\n", length, key, value);
}

void append(std::vector<std::uint8_t>& bytes, const Block& block) {
    bytes.insert(bytes.end(), block.begin(), block.end());
}

bool isAscii(std::string_view text) {
    return std::ranges::all_of(text, [](char c) { return static_cast<unsigned char>(c) < 0x80; });
}

// ---- reading

bool readAt(int descriptor, void* to, std::size_t size, std::uint64_t at) {
    return ::pread(descriptor, to, size, static_cast<off_t>(at)) == static_cast<ssize_t>(size);
}

std::uint64_t octalIn(const Block& block, Field field) {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < field.size; ++i) {
        const std::uint8_t c = block[field.at + i];
        if (c >= '0' && c <= '7') value = 8 * value + (c - '0');
    }
    return value;
}

// The value of a key in the records of an extended header; empty: it has none.
std::string valueOf(std::string_view records, std::string_view key) {
    const std::string start = fmt::format(" {}=", key);
    const std::size_t at = records.find(start);
    if (at == std::string_view::npos) return {};
    const std::size_t begin = at + start.size();
    return std::string{records.substr(begin, records.find('\n', begin) - begin)};
}

}  // namespace

std::vector<std::uint8_t> tarHeader(std::string_view name, std::uint64_t size) {
    std::string records;
    if (name.size() > nameField.size || !isAscii(name)) records += record("path", name);
    if (size > maxPlainSize) records += record("size", std::to_string(size));
    std::vector<std::uint8_t> bytes;
    if (!records.empty()) {
        append(bytes, headerOf("././@PaxHeader", records.size(), extendedHeader));
        bytes.insert(bytes.end(), records.begin(), records.end());
        bytes.resize(padded(bytes.size()));
    }
    append(bytes, headerOf(name, size, plainFile));
    return bytes;
}

std::span<const std::uint8_t> tarPadding(std::uint64_t size) noexcept {
    return tarEnd().first(static_cast<std::size_t>(padded(size) - size));
}

std::span<const std::uint8_t> tarEnd() noexcept {
    static constexpr std::array<std::uint8_t, 2 * tarBlock> zeros{};
    return zeros;
}

std::vector<TarMember> tarMembers(int descriptor) {
    std::vector<TarMember> members;
    std::uint64_t at = 0;
    Block block;
    while (readAt(descriptor, block.data(), block.size(), at)) {
        if (block == Block{}) return members;
        TarMember member{{}, at, 0};
        std::uint64_t size = octalIn(block, sizeField);
        if (block[typeAt] == extendedHeader) {
            std::string records(std::min<std::uint64_t>(size, 1U << 16U), '\0');
            if (!readAt(descriptor, records.data(), records.size(), at + tarBlock)) return {};
            at += tarBlock + padded(size);
            if (!readAt(descriptor, block.data(), block.size(), at)) return {};
            member.name = valueOf(records, "path");
            const std::string large = valueOf(records, "size");
            size = large.empty() ? octalIn(block, sizeField) : std::strtoull(large.c_str(), nullptr, 10);
        }
        if (octalIn(block, checksumField) != checksumOf(block) || block[typeAt] != plainFile) return {};
        if (member.name.empty()) {
            const auto* const name = reinterpret_cast<const char*>(block.data());
            member.name.assign(name, ::strnlen(name, nameField.size));
        }
        at += tarBlock + padded(size);
        member.end = at;
        members.push_back(std::move(member));
    }
    return {};
}

}  // namespace inkedge::batch
