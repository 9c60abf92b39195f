#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/byte_writer.h"

namespace inkedge::io {

/// Makes a ZIP. The same entries always give the same bytes.
class ZipWriter {
public:
    /// @param name  ASCII
    void add(std::string name, std::vector<std::uint8_t> bytes);

    /// The file, each entry compressed if that makes it smaller.
    /// @param maxPlain  bytes: a file that is larger, or has a larger entry, is written as ZIP64
    [[nodiscard]] std::vector<std::uint8_t> take(std::uint64_t maxPlain = 0xFFFFFFFEU) &&;

private:
    struct Entry {
        std::string name;
        std::vector<std::uint8_t> bytes;
        std::uint64_t size;  // before it was compressed
        std::uint32_t checksum = 0;
        bool compressed = false;
        std::uint64_t offset = 0;  // in the file
    };
    static void compress(Entry&);
    [[nodiscard]] std::uint64_t maxSize() const;  // bytes that the file may have

    void number32(std::uint64_t);
    void describe(const Entry&, std::uint16_t extra);
    void addSizes(const Entry&, std::uint16_t extra);
    void addEntry(Entry&);
    void addToDirectory(const Entry&);
    void addEnd(std::uint64_t directory);

    std::vector<Entry> entries_;
    base::ByteWriter file_;
    bool isZip64_ = false;
};

}  // namespace inkedge::io
