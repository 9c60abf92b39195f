#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
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
/// It holds height x width x channels values, row-major, channels interleaved; row 0 is the top row and the centre of
/// pixel (x, y) lies at (x + 0.5, y + 0.5). An image that was not asked for, or was moved from, is empty: 0 x 0.
template <class T>
class Image {
public:
    Image() = default;

    /// Every value the same. @throws std::invalid_argument if a side is negative or there is no channel
    Image(Size size, int channels, T value = {})
        : size_{size}, channels_{channels}, pixels_(checkedCount(size, channels), value) {}

    /// @throws std::invalid_argument unless there are height x width x channels values
    Image(Size size, int channels, std::vector<T> pixels)
        : size_{size}, channels_{channels}, pixels_{std::move(pixels)} {
        if (pixels_.size() != checkedCount(size, channels))
            throw std::invalid_argument{"expected the values of " + shapeText(size, channels) + ", found " +
                                        std::to_string(pixels_.size())};
    }

    Image(const Image&) = default;
    Image& operator=(const Image&) = default;
    Image(Image&& from) noexcept
        : size_{std::exchange(from.size_, {})},
          channels_{std::exchange(from.channels_, 1)},
          pixels_{std::exchange(from.pixels_, {})} {}
    Image& operator=(Image&& from) noexcept {
        size_ = std::exchange(from.size_, {});
        channels_ = std::exchange(from.channels_, 1);
        pixels_ = std::exchange(from.pixels_, {});
        return *this;
    }
    ~Image() = default;

    [[nodiscard]] Size size() const noexcept { return size_; }
    [[nodiscard]] int channels() const noexcept { return channels_; }
    [[nodiscard]] bool empty() const noexcept { return pixels_.empty(); }

    /// All values, in the order above.
    [[nodiscard]] const std::vector<T>& pixels() const& noexcept { return pixels_; }
    /// The same of an image that is not needed any more: it is empty then.
    [[nodiscard]] std::vector<T> pixels() && noexcept { return std::move(Image{std::move(*this)}.pixels_); }
    /// The same, to be changed; their number stays.
    [[nodiscard]] std::span<T> mutablePixels() & noexcept { return pixels_; }

    /// The value of one channel at column x, row y. Not checked: at() is.
    [[nodiscard]] T& operator()(int x, int y, int channel = 0) noexcept { return pixels_[index(x, y, channel)]; }
    [[nodiscard]] const T& operator()(int x, int y, int channel = 0) const noexcept {
        return pixels_[index(x, y, channel)];
    }

    /// The same, checked. @throws std::out_of_range outside the image
    [[nodiscard]] T& at(int x, int y, int channel = 0) { return pixels_[checkedIndex(x, y, channel)]; }
    [[nodiscard]] const T& at(int x, int y, int channel = 0) const { return pixels_[checkedIndex(x, y, channel)]; }

    friend bool operator==(const Image&, const Image&) = default;

private:
    static std::string shapeText(Size size, int channels) {
        return std::to_string(size.width) + " x " + std::to_string(size.height) + " pixels of " +
               std::to_string(channels) + " values";
    }

    static std::size_t checkedCount(Size size, int channels) {
        if (size.width < 0 || size.height < 0 || channels < 1)
            throw std::invalid_argument{"expected an image of 0 or more pixels of at least 1 value, found " +
                                        shapeText(size, channels)};
        return static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height) *
               static_cast<std::size_t>(channels);
    }

    [[nodiscard]] std::size_t index(int x, int y, int channel) const noexcept {
        return (static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.width) + static_cast<std::size_t>(x)) *
                   static_cast<std::size_t>(channels_) +
               static_cast<std::size_t>(channel);
    }

    [[nodiscard]] std::size_t checkedIndex(int x, int y, int channel) const {
        if (x < 0 || x >= size_.width || y < 0 || y >= size_.height || channel < 0 || channel >= channels_)
            throw std::out_of_range{"expected a value of an image of " + shapeText(size_, channels_) +
                                    ", found column " + std::to_string(x) + ", row " + std::to_string(y) +
                                    ", channel " + std::to_string(channel)};
        return index(x, y, channel);
    }

    Size size_;
    int channels_ = 1;
    std::vector<T> pixels_;
};

}  // namespace inkedge
