#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

namespace inkedge::mesh {

/// A number by which things are sorted.
struct ZOrderKey {
    std::uint64_t key;
    std::uint32_t index;
};

/// The Z-order curve through a box (Morton 1966): what is near on it is near in space.
class ZOrder {
public:
    /// The box from low to high, which is parted into a cube of 2^21 cells a side.
    ZOrder(glm::dvec3 low, glm::dvec3 high)
        : low_{low}, cells_{maxCell / std::max({high.x - low.x, high.y - low.y, high.z - low.z, 1e-300})} {}

    /// The number, along the curve, of the cell that a position is in; of the nearest one where it is outside the box.
    [[nodiscard]] std::uint64_t key(glm::dvec3 position) const {
        const auto cell = [&](int axis) {
            const double middle = position[axis] - low_[axis];
            return spread(static_cast<std::uint64_t>(std::clamp(middle * cells_, 0.0, maxCell)));
        };
        return cell(0) << 2U | cell(1) << 1U | cell(2);
    }

private:
    static constexpr double maxCell = 2097151.0;

    // The low 21 bits of a number, with two zeros after each.
    static std::uint64_t spread(std::uint64_t x) {
        x = (x | x << 32U) & 0x1F00000000FFFFU;
        x = (x | x << 16U) & 0x1F0000FF0000FFU;
        x = (x | x << 8U) & 0x100F00F00F00F00FU;
        x = (x | x << 4U) & 0x10C30C30C30C30C3U;
        return (x | x << 2U) & 0x1249249249249249U;
    }

    glm::dvec3 low_;
    double cells_;
};

/// Sorts by the keys; what has the same stays in its order. O(n), quicker where all keys have the same upper bits.
void sortByKey(std::vector<ZOrderKey>&);

}  // namespace inkedge::mesh
