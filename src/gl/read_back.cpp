#include "gl/read_back.h"

#include <array>
#include <bit>

#include "gl/draw.h"

namespace inkedge::gl {
namespace {

constexpr std::array<GLenum, 4> colorFormats{GL_RED, GL_RG, GL_RGB, GL_RGBA};

void prepareReading(const Api& api, const Framebuffer& source) {
    api.BindFramebuffer(GL_READ_FRAMEBUFFER, source.id());
    api.BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    for (const auto zero : {GL_PACK_ROW_LENGTH, GL_PACK_SKIP_PIXELS, GL_PACK_SKIP_ROWS, GL_PACK_SWAP_BYTES}) {
        api.PixelStorei(static_cast<GLenum>(zero), 0);
    }
    api.PixelStorei(GL_PACK_ALIGNMENT, 1);
}

template <class T>
Image<T> read(const Api& api, const Framebuffer& source, int channels, GLenum format, GLenum type) {
    Image<T> image{source.size(), channels};
    prepareReading(api, source);
    api.ReadPixels(0, 0, image.size().width, image.size().height, format, type, image.mutablePixels().data());
    return image;
}

template <class T>
raster::Samples<T> read(const Api& api, const Framebuffer& source, int channels, GLenum format, GLenum type,
                        std::span<const raster::Rectangle> regions) {
    raster::Samples<T> samples{source.size(), channels};
    prepareReading(api, source);
    api.PixelStorei(GL_PACK_ROW_LENGTH, samples.size.width);
    for (const auto& [x, y, size] : regions) {
        api.ReadPixels(x, y, size.width, size.height, format, type, &samples(x, y));
    }
    return samples;
}

}  // namespace

Image<float> readFloats(const Api& api, const Texture& texture, int channels) {
    return read<float>(api, Framebuffer{api, {&texture}}, channels,
                       colorFormats[static_cast<std::size_t>(channels - 1)], GL_FLOAT);
}

raster::Samples<float> readFloats(const Api& api, const Texture& texture, int channels,
                                  std::span<const raster::Rectangle> regions) {
    return read<float>(api, Framebuffer{api, {&texture}}, channels,
                       colorFormats[static_cast<std::size_t>(channels - 1)], GL_FLOAT, regions);
}

raster::Samples<std::uint32_t> readIntegers(const Api& api, const Texture& texture,
                                            std::span<const raster::Rectangle> regions) {
    return read<std::uint32_t>(api, Framebuffer{api, {&texture}}, 1, GL_RED_INTEGER, GL_UNSIGNED_INT, regions);
}

Image<std::uint32_t> readIntegers(const Api& api, const Texture& texture) {
    return read<std::uint32_t>(api, Framebuffer{api, {&texture}}, 1, GL_RED_INTEGER, GL_UNSIGNED_INT);
}

Image<std::uint8_t> readPacked(const Api& api, const Texture& texture) {
    static_assert(std::endian::native == std::endian::little);
    return read<std::uint8_t>(api, Framebuffer{api, {&texture}}, 16, GL_RGBA_INTEGER, GL_UNSIGNED_INT);
}

Image<std::uint8_t> readBytes(const Api& api, const Texture& texture, int channels) {
    return read<std::uint8_t>(api, Framebuffer{api, {&texture}}, channels,
                              colorFormats[static_cast<std::size_t>(channels - 1)], GL_UNSIGNED_BYTE);
}

Image<float> readDepth(const Api& api, const Texture& texture) {
    return read<float>(api, Framebuffer{api, {}, &texture}, 1, GL_DEPTH_COMPONENT, GL_FLOAT);
}

}  // namespace inkedge::gl
