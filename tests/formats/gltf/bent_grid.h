#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace inkedge::compressed_models {

/// A bent grid of side * side vertices.
struct Grid {
    explicit Grid(std::uint32_t side) {
        for (std::uint32_t y = 0; y < side; ++y)
            for (std::uint32_t x = 0; x < side; ++x)
                positions.insert(positions.end(),
                                 {static_cast<float>(x), static_cast<float>(y), static_cast<float>(x * y)});
        for (std::uint32_t y = 0; y + 1 < side; ++y)
            for (std::uint32_t x = 0; x + 1 < side; ++x) {
                const std::uint32_t a = y * side + x;
                indices.insert(indices.end(), {a, a + 1, a + side, a + side, a + 1, a + side + 1});
            }
    }
    [[nodiscard]] std::size_t vertexCount() const { return positions.size() / 3; }
    std::vector<float> positions;
    std::vector<std::uint32_t> indices;
};

}  // namespace inkedge::compressed_models
