#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include <inkedge/error.h>
#include <inkedge/image.h>

#include "images/layer.h"
#include "modules/open_module.h"

// The interface between the library and the module of image formats. OpenImageIO takes half a second to load.

namespace inkedge::images {

/// The type of a file's values.
enum class SampleType { Uint8, Float };

struct EncodedPicture {
    std::vector<std::uint8_t> bytes;
    std::string failure;
};

struct ReadPicture {
    Image<float> image;
    bool integers = false;  ///< the file holds integers, scaled here to 0..1
    std::string failure;
};

struct DecodedPicture {
    /// 4 channels: RGB as in the file, and alpha, 255 where the file has none; not premultiplied.
    Image<std::uint8_t> image;
    std::string failure;
};

struct Differences {
    std::uint64_t pixelsOverLevel = 0;
    double maximum = 0.0;
    int maximumX = 0;
    int maximumY = 0;
    double mean = 0.0;
    std::string failure;
};

/// The module's functions; safe to call from several threads.
struct ImageFormats {
    /// Makes a TIFF in memory, of at least one pixel. A channel "A" is alpha, which the others are not multiplied by.
    /// @param dpi  pixels per inch, if the file is to tell them
    EncodedPicture (*encodeTiff)(const Layer&, SampleType, std::optional<double> dpi);

    /// The first picture of a file of any format; alpha is not premultiplied.
    ReadPicture (*read)(const std::filesystem::path&);

    /// A JPEG picture in memory.
    DecodedPicture (*decodeJpeg)(std::span<const std::uint8_t> bytes, std::uint64_t maxPixels);

    /// The differences of two pictures of one size and channel count. Where a value is no number or infinite, the other
    /// picture has the same.
    Differences (*compare)(const Image<float>& a, const Image<float>& b, double level);
};

/// What OpenImageIO and the libraries that it loads start: some of their own, and two pools as large as the machine.
inline std::size_t imageThreads() { return 8 + 2 * static_cast<std::size_t>(std::thread::hardware_concurrency()); }

inline constexpr modules::ModuleOf<ImageFormats> imageModule{{.purpose = "image formats",
                                                              .file = "inkedge_image_formats.so",
                                                              .symbol = "inkedge_image_formats_6",
                                                              .library = "OpenImageIO",
                                                              .option = "",
                                                              .remedy = "use .png, which needs no module",
                                                              .threads = imageThreads}};

/// The image formats' functions. The first call opens the module, which takes about half a second.
/// @throws Error  (failure) as openModule()
inline const ImageFormats& imageFormats(Error::Kind failure) { return modules::functionsOf<imageModule>(failure); }

}  // namespace inkedge::images
