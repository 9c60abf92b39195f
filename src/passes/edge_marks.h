#pragma once

#include <array>

#include <inkedge/image.h>

namespace inkedge::passes {

/// The marks of detect_edges.frag or detect_function.frag in host memory: two bits per pixel.
struct EdgeMarks {
    static constexpr int blockSide = 4;  ///< pixels decided by one invocation along each axis
    static constexpr unsigned depthEdge = 1;
    static constexpr unsigned normalEdge = 2;
    static constexpr unsigned functionEdge = 1;  ///< of functions on surfaces, the only one

    Size size;  ///< of the picture
    Image<std::uint32_t>
        blocks;  ///< one value per block of 4 x 4 pixels, row by row, the first pixel in the lowest bits
};

/// The size of EdgeMarks::blocks for a picture.
[[nodiscard]] Size blocksOf(Size) noexcept;

/// An image that has the first channels of values[m] where the marks are m.
/// @param channels  1 to 4
[[nodiscard]] Image<std::uint8_t> paintMarks(const EdgeMarks&, const std::array<std::array<std::uint8_t, 4>, 4>& values,
                                             int channels);

/// 255 where any of the bits is set, else 0.
[[nodiscard]] Image<std::uint8_t> mask(const EdgeMarks&, unsigned bits);

}  // namespace inkedge::passes
