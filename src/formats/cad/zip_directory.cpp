#include "formats/cad/zip_directory.h"

#include <algorithm>
#include <initializer_list>
#include <string>

#include <fmt/format.h>

#include "base/message.h"

namespace inkedge::cad {
namespace {

constexpr std::uint32_t inZip64 = 0xFFFFFFFF;  // the value is among the ZIP64 fields

// Little-endian numbers in bytes; 0 beyond their end.
class Bytes {
public:
    explicit Bytes(std::span<const std::uint8_t> bytes) : bytes_{bytes} {}

    [[nodiscard]] std::uint64_t number(std::uint64_t at, int size) const {
        if (at > bytes_.size() || bytes_.size() - at < static_cast<std::uint64_t>(size)) return 0;
        std::uint64_t value = 0;
        for (int i = size; i-- > 0;) value = value << 8U | bytes_[at + static_cast<std::uint64_t>(i)];
        return value;
    }
    [[nodiscard]] bool holds(std::uint64_t at, std::uint64_t size) const {
        return at <= bytes_.size() && bytes_.size() - at >= size;
    }
    [[nodiscard]] std::string_view text(std::uint64_t at, std::uint64_t size) const {
        return {reinterpret_cast<const char*>(bytes_.data()) + at, size};
    }
    [[nodiscard]] std::uint64_t size() const { return bytes_.size(); }

private:
    std::span<const std::uint8_t> bytes_;
};

struct Directory {
    std::uint64_t begin = 0;
    std::uint64_t entries = 0;
};

Directory directoryOf(const Bytes& bytes) {
    constexpr std::uint32_t signature = 0x06054B50;
    constexpr std::uint64_t recordSize = 22;
    constexpr std::uint64_t longestComment = 0xFFFF;
    for (std::uint64_t back = recordSize; back <= std::min(bytes.size(), recordSize + longestComment); ++back) {
        const std::uint64_t at = bytes.size() - back;
        if (bytes.number(at, 4) != signature) continue;
        const Directory found{bytes.number(at + 16, 4), bytes.number(at + 10, 2)};
        if (found.begin != inZip64 && found.entries != 0xFFFF) return found;
        constexpr std::uint64_t locatorSize = 20;
        if (at < locatorSize || bytes.number(at - locatorSize, 4) != 0x07064B50) return found;
        const std::uint64_t record = bytes.number(at - locatorSize + 8, 8);
        if (bytes.number(record, 4) != 0x06064B50) return found;
        return {bytes.number(record + 48, 8), bytes.number(record + 32, 8)};
    }
    base::refuse("expected the directory of a ZIP archive at its end, found none: it is cut short");
}

// Takes those of an entry's numbers from its extra fields that stand there, in the order of these.
void takeZip64(const Bytes& bytes, std::uint64_t begin, std::uint64_t size,
               std::initializer_list<std::uint64_t*> numbers) {
    for (std::uint64_t at = begin; at + 4 <= begin + size; at += 4 + bytes.number(at + 2, 2)) {
        if (bytes.number(at, 2) != 1) continue;
        std::uint64_t from = at + 4;
        for (std::uint64_t* const number : numbers) {
            if (*number != inZip64) continue;
            *number = bytes.number(from, 8);
            from += 8;
        }
        return;
    }
}

// @param head  where the entry's own head begins
std::string_view packedAt(const Bytes& bytes, std::uint64_t head, std::uint64_t size, std::string_view name) {
    constexpr std::uint64_t headSize = 30;
    const std::uint64_t begin = head + headSize + bytes.number(head + 26, 2) + bytes.number(head + 28, 2);
    if (bytes.number(head, 4) != 0x04034B50 || !bytes.holds(begin, size))
        base::refuse(
            fmt::format("expected {} bytes of {} in a part of a ZIP archive, found none", size, base::quote(name)));
    return bytes.text(begin, size);
}

}  // namespace

std::vector<ZipEntry> zipDirectory(std::span<const std::uint8_t> archive) {
    const Bytes bytes{archive};
    const Directory directory = directoryOf(bytes);
    std::vector<ZipEntry> entries;
    std::uint64_t at = directory.begin;
    for (std::uint64_t i = 0; i < directory.entries; ++i) {
        constexpr std::uint64_t headSize = 46;
        const std::uint64_t nameSize = bytes.number(at + 28, 2);
        const std::uint64_t extraSize = bytes.number(at + 30, 2);
        if (bytes.number(at, 4) != 0x02014B50 || !bytes.holds(at, headSize + nameSize + extraSize))
            base::refuse(
                fmt::format("expected {} entries in the directory of a ZIP archive, found {}", directory.entries, i));
        const std::string_view name = bytes.text(at + headSize, nameSize);
        std::uint64_t size = bytes.number(at + 24, 4);
        std::uint64_t packedSize = bytes.number(at + 20, 4);
        std::uint64_t head = bytes.number(at + 42, 4);
        takeZip64(bytes, at + headSize + nameSize, extraSize, {&size, &packedSize, &head});
        entries.push_back({name, size, bytes.number(at + 10, 2), packedAt(bytes, head, packedSize, name)});
        at += headSize + nameSize + extraSize + bytes.number(at + 32, 2);
    }
    return entries;
}

}  // namespace inkedge::cad
