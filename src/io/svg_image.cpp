#include "io/svg_image.h"

#include <algorithm>
#include <cstdint>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include <inkedge/encode_png.h>

namespace inkedge::io {
namespace {

std::string base64(const std::vector<std::uint8_t>& bytes) {
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t count = std::min<std::size_t>(bytes.size() - i, 3);
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k) group = group << 8U | (k < count ? bytes[i + k] : 0U);
        for (std::size_t k = 0; k < 4; ++k)
            text += k <= count ? digits[(group >> (18U - 6U * static_cast<unsigned>(k))) & 63U] : '=';
    }
    return text;
}

}  // namespace

std::string svgImage(const Image<std::uint8_t>& picture, const std::string& attributes) {
    return fmt::format(
        "<image class=\"inkedge shade\" width=\"{}\" height=\"{}\" preserveAspectRatio=\"none\"{} "
        "xlink:href=\"data:image/png;base64,{}\"/>\n",
        picture.size().width, picture.size().height, attributes, base64(encodePng(picture)));
}

}  // namespace inkedge::io
