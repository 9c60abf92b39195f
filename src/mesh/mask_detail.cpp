#include "mesh/mask_detail.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace inkedge::mesh {
namespace {

// What a new texel takes of one along an axis.
struct Share {
    int from;
    float weight;
};

// The shares of each new texel along an axis that has `size` texels, which become `count`.
std::vector<std::vector<Share>> sharesOf(int size, int count) {
    std::vector<std::vector<Share>> all(static_cast<std::size_t>(count));
    const double width = static_cast<double>(size) / count;
    for (int i = 0; i < count; ++i) {
        const double begin = i * width;
        const double end = begin + width;
        for (int from = static_cast<int>(begin); from < size && from < end; ++from) {
            const double covered = std::min(end, from + 1.0) - std::max(begin, static_cast<double>(from));
            if (covered > 1e-9) all[static_cast<std::size_t>(i)].push_back({from, static_cast<float>(covered / width)});
        }
    }
    return all;
}

// How many squares of four texels are opaque in part.
double mixedSquares(const Image<std::uint8_t>& mask, double threshold) {
    const auto limit = static_cast<int>(std::ceil(threshold));
    const auto [width, height] = mask.size();
    std::uint64_t count = 0;
    for (int y = 0; y + 1 < height; ++y) {
        const std::uint8_t* const row = &mask.pixels()[static_cast<std::size_t>(y) * static_cast<std::size_t>(width)];
        const std::uint8_t* const next = row + width;
        for (int x = 0; x + 1 < width; ++x) {
            const int opaque = (row[x] >= limit) + (row[x + 1] >= limit) + (next[x] >= limit) + (next[x + 1] >= limit);
            count += opaque != 0 && opaque != 4 ? 1 : 0;
        }
    }
    return static_cast<double>(count);
}

}  // namespace

Image<std::uint8_t> halved(const Image<std::uint8_t>& mask) {
    const Size size{std::max(1, mask.size().width / 2), std::max(1, mask.size().height / 2)};
    const auto columns = sharesOf(mask.size().width, size.width);
    const auto rows = sharesOf(mask.size().height, size.height);
    Image<std::uint8_t> half{size, 1};
    std::vector<float> sums(columns.size());
    for (int y = 0; y < size.height; ++y) {
        std::ranges::fill(sums, 0.0F);
        for (const Share& row : rows[static_cast<std::size_t>(y)])
            for (std::size_t x = 0; x < columns.size(); ++x)
                for (const Share& column : columns[x])
                    sums[x] += row.weight * column.weight * static_cast<float>(mask(column.from, row.from));
        for (int x = 0; x < size.width; ++x)
            half(x, y) = static_cast<std::uint8_t>(std::lround(sums[static_cast<std::size_t>(x)]));
    }
    return half;
}

double outlineCorners(const Image<std::uint8_t>& mask, const Image<std::uint8_t>& half, double threshold) {
    constexpr double smooth = 0.125;  // corners a square that a smooth outline passes through
    const double squares = mixedSquares(mask, threshold);
    // A smooth outline passes through half as many squares of twice the size.
    return smooth * squares + std::max(0.0, squares - 2.0 * mixedSquares(half, threshold));
}

}  // namespace inkedge::mesh
