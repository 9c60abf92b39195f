#include "formats/cad/zip_directory.h"

#include <algorithm>
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

// The unpacked size among an entry's extra fields.
std::uint64_t zip64Size(const Bytes& bytes, std::uint64_t begin, std::uint64_t size) {
    for (std::uint64_t at = begin; at + 4 <= begin + size;) {
        if (bytes.number(at, 2) == 1) return bytes.number(at + 4, 8);
        at += 4 + bytes.number(at + 2, 2);
    }
    return inZip64;
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
        std::uint64_t size = bytes.number(at + 24, 4);
        if (size == inZip64) size = zip64Size(bytes, at + headSize + nameSize, extraSize);
        entries.push_back({bytes.text(at + headSize, nameSize), size});
        at += headSize + nameSize + extraSize + bytes.number(at + 32, 2);
    }
    return entries;
}

}  // namespace inkedge::cad
