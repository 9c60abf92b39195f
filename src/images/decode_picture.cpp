#include "images/decode_picture.h"

#include <fmt/format.h>

#include "base/message.h"
#include "base/read_file.h"
#include "images/image_formats.h"
#include "images/png_reader.h"

namespace inkedge {
namespace {

using load::refuse;

}  // namespace

Image<std::uint8_t> decodePicture(std::span<const std::uint8_t> picture, std::uint64_t mostPixels) {
    const std::string_view content = load::textOf(picture);
    if (content.starts_with("\xff\xd8\xff")) {
        io::DecodedPicture decoded = io::imageFormats(Error::Kind::Input).decodeJpeg(picture, mostPixels);
        if (!decoded.failure.empty()) refuse("expected a JPEG picture, found: " + load::quote(decoded.failure));
        return std::move(decoded.image);
    }
    if (!content.starts_with("\x89PNG"))
        refuse(fmt::format("expected a PNG or JPEG picture, found {}; convert it", load::kindOf(content)));
    return load::PngReader{picture, mostPixels}.read(PNG_FORMAT_RGBA);
}

}  // namespace inkedge
