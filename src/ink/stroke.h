#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <glm/vec2.hpp>

namespace inkedge::ink {

/// Stroke::widthFrom and ::widthTo of a stroke as wide as its pen.
inline constexpr std::uint8_t fullWidth = 128;

/// The same for a share of the pen's width.
[[nodiscard]] inline std::uint8_t levelOf(double width) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(width * fullWidth, 0.0, 255.0)));
}

/// A straight stroke with round caps. Coordinates are output pixels, (0, 0) the picture's top left corner.
struct Stroke {
    glm::vec2 from;
    glm::vec2 to;
    std::uint8_t pen;                    ///< index into pens()
    std::uint8_t widthFrom = fullWidth;  ///< 128ths of the pen's width
    std::uint8_t widthTo = fullWidth;    ///< between the two it changes evenly
    /// Length of the line before this stroke, pixels, for a brush. 0: the first stroke of a line, whose others follow.
    float arc = 0.0F;
};

}  // namespace inkedge::ink
