#include "scene/weld.h"

#include <bit>

namespace inkedge {
namespace {

std::uint64_t hash(glm::vec3 p) {
    std::uint64_t h = 0;
    for (int i = 0; i < 3; ++i) {
        h = (h ^ std::bit_cast<std::uint32_t>(p[i] + 0.0F)) * 0x9E3779B97F4A7C15U;  // + 0: -0 and 0 hash alike
        h ^= h >> 29U;
    }
    return h;
}

}  // namespace

Weld weldByPosition(std::span<const glm::vec3> positions) {
    constexpr std::uint32_t free = ~0U;
    Weld weld{std::vector<std::uint32_t>(positions.size()), 0};
    // Open addressing at a load of at most one half; a slot names the first vertex seen at its place.
    std::vector<std::uint32_t> slots(std::bit_ceil(2 * positions.size() + 1), free);
    const std::uint64_t mask = slots.size() - 1;
    for (std::uint32_t i = 0; i < positions.size(); ++i) {
        std::uint64_t slot = hash(positions[i]) & mask;
        while (slots[slot] != free && positions[slots[slot]] != positions[i]) slot = (slot + 1) & mask;
        if (slots[slot] == free) {
            slots[slot] = i;
            weld.point[i] = weld.pointCount++;
        } else {
            weld.point[i] = weld.point[slots[slot]];
        }
    }
    return weld;
}

}  // namespace inkedge
