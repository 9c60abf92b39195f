#include "io/read_picture.h"

#include <cerrno>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include <inkedge/error.h>

#include "images/read_png.h"

namespace fs = std::filesystem;

namespace inkedge::io {
namespace {

[[noreturn]] void failToRead(const fs::path& file, std::string_view reason) {
    throw Error{Error::Kind::Input, fmt::format("{}: cannot be read as a picture: {}", file.string(), reason)};
}

std::vector<std::uint8_t> readBytes(const fs::path& file) {
    std::error_code error;
    const fs::file_status status = fs::status(file, error);
    if (fs::is_directory(status)) failToRead(file, "expected a file, found a folder; add a file's name");
    if (status.type() == fs::file_type::not_found) failToRead(file, "expected a file, found none; check its name");
    if (fs::exists(status) && !fs::is_regular_file(status))
        failToRead(file, "expected a regular file, found a device, pipe or socket; write a file and name that");
    std::ifstream stream{file, std::ios::binary};
    std::vector<std::uint8_t> bytes{std::istreambuf_iterator<char>{stream}, {}};
    if (!stream) {
        const std::string reason = std::generic_category().message(errno);
        failToRead(file, fmt::format("expected a file that may be read, found: {}; change its mode", reason));
    }
    return bytes;
}

}  // namespace

images::ReadPicture readPicture(const fs::path& file) {
    const std::vector<std::uint8_t> bytes = readBytes(file);
    if (bytes.empty()) failToRead(file, "expected a picture, found an empty file; write it again");
    images::ReadPicture picture =
        images::isPng(bytes) ? images::readPng(bytes) : images::imageFormats(Error::Kind::Input).read(file);
    if (!picture.failure.empty()) failToRead(file, picture.failure);
    return picture;
}

}  // namespace inkedge::io
