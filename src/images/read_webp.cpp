#include "images/read_webp.h"

#include <fmt/format.h>
#include <webp/decode.h>

#include "base/message.h"
#include "base/read_file.h"

namespace inkedge::images {

namespace {

// What the header says, checked.
WebPBitstreamFeatures featuresOf(std::span<const std::uint8_t> bytes, std::uint64_t maxPixels) {
    WebPBitstreamFeatures features;
    if (WebPGetFeatures(bytes.data(), bytes.size(), &features) != VP8_STATUS_OK)
        base::refuse("expected a WebP picture, found one whose header is damaged or cut short");
    if (features.has_animation != 0) base::refuse("expected a WebP picture, found an animation");
    const auto width = static_cast<std::uint64_t>(features.width);
    const auto height = static_cast<std::uint64_t>(features.height);
    if (width * height > maxPixels)
        base::refuse(
            fmt::format("expected at most {} pixels, found {}x{}; raise max-image-pixels", maxPixels, width, height));
    return features;
}

}  // namespace

bool isWebp(std::span<const std::uint8_t> bytes) noexcept {
    const std::string_view text = base::textOf(bytes);
    return text.starts_with("RIFF") && text.size() >= 12 && text.substr(8, 4) == "WEBP";
}

Image<std::uint8_t> readWebp(std::span<const std::uint8_t> bytes, std::uint64_t maxPixels) {
    const WebPBitstreamFeatures features = featuresOf(bytes, maxPixels);
    Image<std::uint8_t> picture{{features.width, features.height}, 4};
    const std::uint8_t* const read = WebPDecodeRGBAInto(bytes.data(), bytes.size(), picture.mutablePixels().data(),
                                                        picture.pixels().size(), 4 * features.width);
    if (read == nullptr) base::refuse("expected a WebP picture, found one that is damaged or cut short");
    return picture;
}

bool webpHasAlpha(std::span<const std::uint8_t> bytes, std::uint64_t maxPixels) {
    return featuresOf(bytes, maxPixels).has_alpha != 0;
}

}  // namespace inkedge::images
