#include "passes/edge_marks.h"

#include <algorithm>

namespace inkedge::passes {
namespace {

constexpr int side = EdgeMarks::blockSide;

using Values = std::array<std::array<std::uint8_t, 4>, 4>;

// A row of four pixels is one byte of a block's marks. A table holds what each of the 256 bytes becomes.
template <int channels>
void paintRows(const EdgeMarks& marks, const Values& values, Image<std::uint8_t>& image) {
    std::array<std::array<std::uint8_t, side * channels>, 256> rows{};
    for (std::size_t byte = 0; byte < rows.size(); ++byte) {
        for (std::size_t x = 0; x < side; ++x) {
            std::copy_n(values[byte >> (2 * x) & 3U].begin(), channels, &rows[byte][x * channels]);
        }
    }
    const auto [width, height] = image.size();
    for (int y = 0; y < height; ++y) {
        const auto rowOf = [&](int block) -> const std::uint8_t* {
            return rows[marks.blocks(block, y / side) >> (8 * (y % side)) & 0xFFU].data();
        };
        const int whole = width / side;
        for (int block = 0; block < whole; ++block) {
            std::copy_n(rowOf(block), side * channels, &image(block * side, y));
        }
        const int rest = width % side;
        if (rest != 0) std::copy_n(rowOf(whole), rest * channels, &image(whole * side, y));
    }
}

}  // namespace

Size blocksOf(Size size) noexcept { return {(size.width + side - 1) / side, (size.height + side - 1) / side}; }

Image<std::uint8_t> paintMarks(const EdgeMarks& marks, const Values& values, int channels) {
    Image<std::uint8_t> image{marks.size, channels};
    switch (channels) {
        case 1:
            paintRows<1>(marks, values, image);
            break;
        case 2:
            paintRows<2>(marks, values, image);
            break;
        case 3:
            paintRows<3>(marks, values, image);
            break;
        default:
            paintRows<4>(marks, values, image);
    }
    return image;
}

Image<std::uint8_t> mask(const EdgeMarks& marks, unsigned bits) {
    Values values{};
    for (unsigned m = 0; m < values.size(); ++m) values[m][0] = (m & bits) != 0 ? 255 : 0;
    return paintMarks(marks, values, 1);
}

}  // namespace inkedge::passes
