#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include <inkedge/export.h>
#include <inkedge/image.h>

// What the library and the image format module say to each other. OpenImageIO takes half a second to load; it stays in
// the module, which is opened when the first picture needs it. Both sides are built together and share the C++ runtime;
// no exception crosses: failures come back as text of one line, empty where there is none.

namespace inkedge::io {

enum class FileFormat { Tiff, OpenExr };
enum class SampleType { Uint8, Half, Float };

/// Channels that come from one image.
struct Layer {
    /// 8-bit values count as 0..1; 32-bit integers stay what they are.
    std::variant<const Image<std::uint8_t>*, const Image<float>*, const Image<std::uint32_t>*> image;
    std::vector<std::string> channels;  ///< a name for each of its channels
    SampleType stored;                  ///< what the file keeps
};

/// An entry in a file's header: one float, or 16: a 4 x 4 matrix, row-major.
struct HeaderEntry {
    std::string name;
    std::vector<float> values;
};

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
    Image<std::uint8_t> image;  ///< 4 channels: RGB as in the file, and alpha, 255 where it has none; not multiplied in
    std::string failure;
};

struct Differences {
    std::uint64_t pixelsOverLevel = 0;
    double maximum = 0.0;  ///< infinite where one picture holds a number and the other one none
    int maximumX = 0;
    int maximumY = 0;
    double mean = 0.0;
    std::string failure;
};

/// The module's functions; safe to call from several threads.
struct ImageFormats {
    /// A file in memory. The layers' images are of one size and hold at least one pixel. A channel "A" is alpha: not
    /// premultiplied in Tiff, premultiplied in OpenExr.
    EncodedPicture (*encode)(FileFormat, std::span<const Layer>, std::span<const HeaderEntry>);

    /// The first picture of a file of any format; alpha is not multiplied in.
    ReadPicture (*read)(const std::filesystem::path&);

    /// A picture of 8 bits in memory: JPEG.
    DecodedPicture (*decodeJpeg)(std::span<const std::uint8_t> bytes, std::uint64_t mostPixels);

    /// Differences of two pictures of one size and channel count.
    Differences (*compare)(const Image<float>& a, const Image<float>& b, double level);
};

/// The module's one symbol. Its number rises with every change in this file, so that a module of another build is
/// refused instead of misread.
extern "C" INKEDGE_API const ImageFormats* inkedge_image_formats_3() noexcept;
inline constexpr char imageFormatsSymbol[] = "inkedge_image_formats_3";
inline constexpr char imageFormatsFile[] = "inkedge_image_formats.so";

}  // namespace inkedge::io
