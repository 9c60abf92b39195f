#include "diff/skeleton.h"

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace inkedge::diff {
namespace {

// The neighbours of a pixel, in a circle.
constexpr std::array<std::pair<int, int>, 8> ring{
    {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};

// The ink, with a frame of one pixel without: no neighbour lies outside.
class Thinner {
public:
    explicit Thinner(const Image<float>& ink)
        : size_{ink.size()},
          width_{size_.width + 2},
          inked_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(size_.height + 2)) {
        for (int y = 0; y < size_.height; ++y) {
            for (int x = 0; x < size_.width; ++x) {
                if (ink(x, y) < inkedFrom) continue;
                inked_[at(x, y)] = 1;
                left_.push_back(at(x, y));
            }
        }
    }

    // From one side after the other, a pixel at a time: from two sides at once what is two pixels wide would vanish,
    // and from all sides in turn a line of two pixels would be eaten up from its end.
    Image<std::uint8_t> thin() {
        constexpr std::array<int, 4> sides{6, 2, 4, 0};
        for (std::size_t before = 0; before != left_.size();) {
            before = left_.size();
            for (const int side : sides) takeFrom(side);
        }
        Image<std::uint8_t> skeleton{size_, 1};
        for (int y = 0; y < size_.height; ++y)
            for (int x = 0; x < size_.width; ++x) skeleton(x, y) = inked_[at(x, y)];
        return skeleton;
    }

private:
    [[nodiscard]] std::size_t at(int x, int y) const {
        return static_cast<std::size_t>(y + 1) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x + 1);
    }
    [[nodiscard]] std::size_t neighbour(std::size_t i, int k) const {
        const auto [x, y] = ring[static_cast<std::size_t>(k & 7)];
        return static_cast<std::size_t>(static_cast<std::ptrdiff_t>(i) + std::ptrdiff_t{y} * width_ + x);
    }

    void takeFrom(int side) {
        std::vector<std::size_t> border;
        for (const std::size_t i : left_)
            if (!inked_[neighbour(i, side)]) border.push_back(i);
        for (const std::size_t i : border)
            if (removable(i)) inked_[i] = 0;
        std::erase_if(left_, [&](std::size_t i) { return !inked_[i]; });
    }

    // Whether nothing comes apart without it, no hole appears, and it is not the end of a line. A pixel is simple if
    // the empty ones among its four sides lie in one stretch of its surroundings: Hilditch's crossing number is 1.
    [[nodiscard]] bool removable(std::size_t i) const {
        int count = 0;
        int crossings = 0;
        for (int k = 0; k < 8; ++k) {
            if (inked_[neighbour(i, k)]) ++count;
            const bool begins = k % 2 == 0 && !inked_[neighbour(i, k)];
            if (begins && (inked_[neighbour(i, k + 1)] || inked_[neighbour(i, k + 2)])) ++crossings;
        }
        return crossings == 1 && count > 1;
    }

    Size size_;
    int width_;
    std::vector<std::uint8_t> inked_;
    std::vector<std::size_t> left_;  // pixels that are inked, by rows
};

}  // namespace

Image<std::uint8_t> skeletonOf(const Image<float>& ink) {
    if (ink.empty()) return {};
    return Thinner{ink}.thin();
}

}  // namespace inkedge::diff
