#include "base/read_file.h"

#include <algorithm>
#include <array>
#include <fstream>

#include <fmt/format.h>

#include "base/message.h"

namespace inkedge::base {
namespace {

namespace fs = std::filesystem;
using namespace std::string_view_literals;

std::uint64_t checkedSize(const fs::path& path) {
    std::error_code failure;
    const fs::file_status status = fs::status(path, failure);
    if (status.type() == fs::file_type::not_found) refuse("expected a file, found none");
    if (failure) refuse("expected a readable file, found: " + failure.message());
    if (fs::is_directory(status)) refuse("expected a file, found a folder");
    if (!fs::is_regular_file(status)) refuse("expected a regular file, found a device, pipe or socket");
    const std::uint64_t size = fs::file_size(path, failure);
    if (failure) refuse("expected a readable file, found: " + failure.message());
    if (size == 0) refuse("expected a file with content, found an empty one");
    return size;
}

Bytes readFirst(const fs::path& path, std::uint64_t size) {
    std::ifstream stream{path, std::ios::binary};
    if (!stream) refuse("expected a readable file, found one that does not open");
    Bytes bytes(size);
    stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
    if (static_cast<std::uint64_t>(stream.gcount()) != size)
        refuse(fmt::format("expected {} bytes, found {} that can be read", size, stream.gcount()));
    return bytes;
}

}  // namespace

void spend(std::uint64_t size, std::uint64_t& bytesLeft) {
    if (size > bytesLeft)
        refuse(fmt::format("expected at most {} more bytes in the files of a model, found {}; raise max-file-size",
                           bytesLeft, size));
    bytesLeft -= size;
}

Bytes readBytes(const fs::path& path, std::uint64_t& bytesLeft) {
    const std::uint64_t size = checkedSize(path);
    spend(size, bytesLeft);
    return readFirst(path, size);
}

Bytes readStart(const fs::path& path, std::size_t size) {
    return readFirst(path, std::min<std::uint64_t>(size, checkedSize(path)));
}

std::string_view textOf(std::span<const std::uint8_t> bytes) noexcept {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::string_view kindOf(std::string_view content) noexcept {
    struct Signature {
        std::string_view bytes;
        std::string_view kind;
        std::size_t at = 0;
    };
    constexpr std::array signatures{
        Signature{"glTF"sv, "binary glTF"},
        Signature{"\x89PNG"sv, "a PNG picture"},
        Signature{"\xff\xd8\xff"sv, "a JPEG picture"},
        Signature{"WEBP"sv, "a WebP picture", 8},
        Signature{"ftypavif"sv, "an AVIF picture", 4},
        Signature{"\xabKTX 20\xbb"sv, "a KTX2 picture"},
        Signature{"DDS "sv, "a DDS picture"},
        Signature{"\x13\xab\xa1\x5c"sv, "an ASTC picture"},
        Signature{"<"sv, "HTML or XML"},
        Signature{"version https://git-lfs"sv, "a Git LFS pointer instead of the file"},
        Signature{"PK\x03\x04"sv, "a ZIP archive"},
        Signature{"\x1f\x8b"sv, "gzip data"},
        Signature{"ply"sv, "a PLY file"},
        Signature{"solid "sv, "an STL file"},
        Signature{"Kaydara FBX"sv, "an FBX file"},
        Signature{"\xff\xfe"sv, "UTF-16 text"},
        Signature{"\xfe\xff"sv, "UTF-16 text"},
    };
    for (const Signature& signature : signatures)
        if (content.size() >= signature.at && content.substr(signature.at).starts_with(signature.bytes))
            return signature.kind;
    const bool binary = std::ranges::any_of(content.substr(0, 512),
                                            [](char c) { return static_cast<unsigned char>(c) < 0x09 || c == 0x7f; });
    return binary ? "other data" : "other text";
}

}  // namespace inkedge::base
