#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <inkedge/image.h>

#include "images/image_formats.h"

namespace inkedge::io {

/// An 8-bit picture of 1, 3 or 4 channels as the bytes of a file. OpenEXR holds linear light and premultiplied alpha,
/// so its values are converted from sRGB; the other formats keep the picture's values.
/// @param dpi     pixels per inch, which PNG and TIFF tell; none: they do not
/// @param target  gives the format by its extension, and the message its name
/// @throws Error  (Kind::Usage) if the extension is none of ours; (Kind::Output) if the picture cannot be encoded
std::vector<std::uint8_t> encodePicture(const Image<std::uint8_t>&, const std::filesystem::path& target,
                                        std::optional<double> dpi = {});

/// @param dpi     pixels per inch, if the file is to tell them
/// @throws Error  (Kind::Output) if the layer cannot be encoded
std::vector<std::uint8_t> encodeTiff(const images::Layer&, images::SampleType, std::optional<double> dpi,
                                     const std::filesystem::path& target);

/// An sRGB picture of 1, 3 or 4 channels as linear light, 0..1: R, G, B, and A of four, by which they are multiplied.
/// Grey is three channels, too: readers of OpenEXR show a lone Y wrongly or in another shape, or not at all.
Image<float> linearPicture(const Image<std::uint8_t>&);

/// The names of channels: "Y", or "R", "G", "B" and, of four channels, "A".
std::vector<std::string> channelNames(int channels);

}  // namespace inkedge::io
