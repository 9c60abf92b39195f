#include "io/map_pictures.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <inkedge/encode_png.h>

#include "base/staged_files.h"
#include "images/image_formats.h"
#include "io/picture.h"

namespace inkedge::io {
namespace {

constexpr std::uint16_t max16 = std::numeric_limits<std::uint16_t>::max();

/// Rounds a level from 0 to a largest one; NaN counts as 0.
int rounded(double level, double largest) {
    const double above = level > 0.0 ? level : 0.0;
    return static_cast<int>((above < largest ? above : largest) + 0.5);
}

/// NaN counts as near.
Image<std::uint16_t> depthPicture(const Image<float>& depth, const Camera& camera) {
    const double perUnit = 1.0 / depthScale(camera);
    Image<std::uint16_t> picture{depth.size(), 1};
    std::ranges::transform(
        depth.pixels(), picture.mutablePixels().begin(), [perUnit, near = camera.near](float value) {
            return static_cast<std::uint16_t>(rounded((value - near) * perUnit, max16));
        });
    return picture;
}

Image<std::uint8_t> normalPicture(const Image<float>& normal) {
    Image<std::uint8_t> picture{normal.size(), normal.channels()};
    std::ranges::transform(normal.pixels(), picture.mutablePixels().begin(), [](float value) {
        return static_cast<std::uint8_t>(rounded(255.0 * ((value + 1.0) / 2.0), 255.0));
    });
    return picture;
}

Image<std::uint8_t> edgePicture(const Image<std::uint8_t>& mask) {
    Image<std::uint8_t> picture{mask.size(), 1};
    std::ranges::transform(mask.pixels(), picture.mutablePixels().begin(),
                           [](std::uint8_t value) { return static_cast<std::uint8_t>(255 - value); });
    return picture;
}

/// One channel of the ids.
/// @throws Error  as expectIdsUpTo()
Image<std::uint16_t> idPicture(const Image<std::uint32_t>& ids, const MapLayer& layer,
                               const std::filesystem::path& target) {
    constexpr std::size_t channels = idNames.size();
    Image<std::uint16_t> picture{ids.size(), 1};
    const std::span<std::uint16_t> values = picture.mutablePixels();
    const std::uint32_t* const id = ids.pixels().data() + layer.values.first;
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        bits |= id[channels * i];
        values[i] = static_cast<std::uint16_t>(id[channels * i]);
    }
    if (bits > max16) expectIdsUpTo(max16, "which the 16 bits of a PNG hold", layer, target);
    return picture;
}

}  // namespace

std::vector<std::uint8_t> pngOf(const Maps& maps, const MapLayer& layer, const std::filesystem::path& target) {
    switch (layer.map) {
        case Map::Depth:
            return encodePng(depthPicture(maps.depth, maps.camera), maps.dpi);
        case Map::Normal:
            return encodePng(normalPicture(maps.normal), maps.dpi);
        case Map::Types:
            return encodePng(maps.types, maps.dpi);
        case Map::Ids:
            return encodePng(idPicture(maps.ids, layer, target), maps.dpi);
        case Map::Shade:
            return encodePng(maps.shade, maps.dpi);
        case Map::DepthEdges:
            return encodePng(edgePicture(maps.depthEdges), maps.dpi);
        case Map::NormalEdges:
            return encodePng(edgePicture(maps.normalEdges), maps.dpi);
        case Map::Edges:
            break;
    }
    return encodePng(edgePicture(maps.edges), maps.dpi);
}

std::vector<std::uint8_t> tiffOf(const MapLayer& layer, std::optional<double> dpi,
                                 const std::filesystem::path& target) {
    expectIdsUpTo(maxExactFloat, "which the floats of a TIFF hold exactly", layer, target);
    if (layer.map == Map::Shade)
        return encodeTiff({layer.values.image, channelNames(4)}, images::SampleType::Uint8, dpi, target);
    return encodeTiff(layer.values, images::SampleType::Float, dpi, target);
}

}  // namespace inkedge::io
