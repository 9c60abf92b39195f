#include "io/zip.h"

#include <algorithm>
#include <utility>

#include "base/deflate.h"
#include "base/parallel.h"

// After PKWARE's APPNOTE.TXT. A file of ZIP64 has every size and offset in its extra fields, so that there are two
// forms of a file and no more.

namespace inkedge::io {
namespace {

constexpr std::uint16_t plainVersion = 20;
constexpr std::uint16_t zip64Version = 45;
constexpr std::uint16_t elsewhere16 = 0xFFFF;  // the number stands in ZIP64's fields
constexpr std::uint32_t elsewhere32 = 0xFFFFFFFF;
constexpr std::uint16_t stored = 0;
constexpr std::uint16_t deflated = 8;
constexpr std::uint16_t zip64Extra = 1;
constexpr std::uint16_t twoNumbers = 16;  // bytes
constexpr std::uint16_t threeNumbers = 24;
constexpr std::uint16_t extraHeader = 4;
constexpr std::uint16_t midnight = 0;
constexpr std::uint16_t firstDay = 0x21;  // 1 January 1980

}  // namespace

void ZipWriter::add(std::string name, std::vector<std::uint8_t> bytes) {
    const std::uint64_t size = bytes.size();
    entries_.push_back({std::move(name), std::move(bytes), size});
}

std::vector<std::uint8_t> ZipWriter::take(std::uint64_t maxPlain) && {
    base::onEach(entries_.size(), [&](std::size_t i) { compress(entries_[i]); });
    isZip64_ = maxSize() > maxPlain || entries_.size() >= elsewhere16 ||
               std::ranges::any_of(entries_, [&](const Entry& entry) { return entry.size > maxPlain; });
    file_.reserve(maxSize());
    for (Entry& entry : entries_) addEntry(entry);
    const std::uint64_t directory = file_.size();
    for (const Entry& entry : entries_) addToDirectory(entry);
    addEnd(directory);
    return std::move(file_).take();
}

void ZipWriter::compress(Entry& entry) {
    entry.checksum = base::crc32(entry.bytes);
    std::vector<std::uint8_t> compressed = base::deflated(entry.bytes, base::DeflateWrapper::None);
    entry.compressed = compressed.size() < entry.bytes.size();
    if (entry.compressed) entry.bytes = std::move(compressed);
}

std::uint64_t ZipWriter::maxSize() const {
    constexpr std::uint64_t headers = 160;  // both of an entry, with their extra fields; and those at the end
    std::uint64_t bytes = headers;
    for (const Entry& entry : entries_) bytes += entry.bytes.size() + headers + 2 * entry.name.size();
    return bytes;
}

void ZipWriter::number32(std::uint64_t value) {
    file_.number(isZip64_ ? elsewhere32 : static_cast<std::uint32_t>(value));
}

// What the header before an entry's bytes and the one in the directory have in common.
void ZipWriter::describe(const Entry& entry, std::uint16_t extra) {
    file_.number(isZip64_ ? zip64Version : plainVersion);
    file_.number(std::uint16_t{0});
    file_.number(entry.compressed ? deflated : stored);
    file_.number(midnight);
    file_.number(firstDay);
    file_.number(entry.checksum);
    number32(entry.bytes.size());
    number32(entry.size);
    file_.number(static_cast<std::uint16_t>(entry.name.size()));
    file_.number(isZip64_ ? static_cast<std::uint16_t>(extraHeader + extra) : std::uint16_t{0});
}

void ZipWriter::addSizes(const Entry& entry, std::uint16_t extra) {
    file_.number(zip64Extra);
    file_.number(extra);
    file_.number(entry.size);
    file_.number(std::uint64_t{entry.bytes.size()});
}

void ZipWriter::addEntry(Entry& entry) {
    entry.offset = file_.size();
    file_.number(std::uint32_t{0x04034B50});
    describe(entry, twoNumbers);
    file_.text(entry.name);
    if (isZip64_) addSizes(entry, twoNumbers);
    file_.bytes(entry.bytes);
}

void ZipWriter::addToDirectory(const Entry& entry) {
    file_.number(std::uint32_t{0x02014B50});
    file_.number(isZip64_ ? zip64Version : plainVersion);  // that made it
    describe(entry, threeNumbers);
    file_.number(std::uint16_t{0});  // bytes of a comment
    file_.number(std::uint32_t{0});  // disk, kind
    file_.number(std::uint32_t{0});  // attributes
    number32(entry.offset);
    file_.text(entry.name);
    if (!isZip64_) return;
    addSizes(entry, threeNumbers);
    file_.number(entry.offset);
}

void ZipWriter::addEnd(std::uint64_t directory) {
    const std::uint64_t end = file_.size();
    const std::uint64_t count = entries_.size();
    if (isZip64_) {
        file_.number(std::uint32_t{0x06064B50});
        file_.number(std::uint64_t{44});                         // bytes of this record to come
        for (int i = 0; i < 2; ++i) file_.number(zip64Version);  // that made it, that reads it
        file_.number(std::uint64_t{0});                          // disks
        for (int i = 0; i < 2; ++i) file_.number(count);         // on this disk, on all
        file_.number(end - directory);
        file_.number(directory);
        file_.number(std::uint32_t{0x07064B50});
        file_.number(std::uint32_t{0});  // disk
        file_.number(end);
        file_.number(std::uint32_t{1});  // disks
    }
    file_.number(std::uint32_t{0x06054B50});
    file_.number(std::uint32_t{0});  // disks
    for (int i = 0; i < 2; ++i) file_.number(isZip64_ ? elsewhere16 : static_cast<std::uint16_t>(count));
    number32(end - directory);
    number32(directory);
    file_.number(std::uint16_t{0});  // bytes of a comment
}

}  // namespace inkedge::io
