#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace inkedge {

/// Width and height in pixels.
struct Size {
    int width = 0;
    int height = 0;
    friend bool operator==(const Size&, const Size&) = default;
};

/// A picture or a map in host memory.
///
/// pixels holds height x width x channels values, row-major, channels interleaved; row 0 is the top row and the centre
/// of pixel (x, y) lies at (x + 0.5, y + 0.5). An image that was not asked for is empty: 0 x 0.
template <class T>
struct Image {
    Size size;
    int channels = 1;
    std::vector<T> pixels;

    Image() = default;
    Image(Size imageSize, int channelCount, T value = {})
        : size{imageSize},
          channels{channelCount},
          pixels(static_cast<std::size_t>(imageSize.width) * static_cast<std::size_t>(imageSize.height) *
                     static_cast<std::size_t>(channelCount),
                 value) {}

    [[nodiscard]] bool empty() const noexcept { return pixels.empty(); }

    /// The value of one channel at column x, row y. No bounds check.
    [[nodiscard]] T& at(int x, int y, int channel = 0) noexcept { return pixels[index(x, y, channel)]; }
    [[nodiscard]] const T& at(int x, int y, int channel = 0) const noexcept { return pixels[index(x, y, channel)]; }

private:
    [[nodiscard]] std::size_t index(int x, int y, int channel) const noexcept {
        return (static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) + static_cast<std::size_t>(x)) *
                   static_cast<std::size_t>(channels) +
               static_cast<std::size_t>(channel);
    }
};

}  // namespace inkedge
