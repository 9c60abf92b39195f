#pragma once

#include <cstddef>
#include <memory>

#include <inkedge/image.h>

namespace inkedge::raster {

/// Values of a picture's samples, in the order of Image. Values that were not written are undefined, and their memory
/// is never touched. Copies share the values.
template <class T>
struct Samples {
    Size size;
    int channels = 1;
    std::shared_ptr<T[]> values;

    Samples() = default;
    Samples(Size imageSize, int channelCount)
        : size{imageSize}, channels{channelCount}, values{new T[index(0, imageSize.height, 0)]} {}

    [[nodiscard]] T& operator()(int x, int y, int channel = 0) noexcept { return values.get()[index(x, y, channel)]; }
    [[nodiscard]] const T& operator()(int x, int y, int channel = 0) const noexcept {
        return values.get()[index(x, y, channel)];
    }

private:
    [[nodiscard]] std::size_t index(int x, int y, int channel) const noexcept {
        return (static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) + static_cast<std::size_t>(x)) *
                   static_cast<std::size_t>(channels) +
               static_cast<std::size_t>(channel);
    }
};

}  // namespace inkedge::raster
