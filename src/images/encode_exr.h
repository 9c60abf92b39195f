#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "images/layer.h"

namespace inkedge::images {

/// An entry in the header of an EXR: a float; 16 floats, a 4 x 4 matrix, row-major; or a text.
struct HeaderEntry {
    std::string name;
    std::variant<float, std::array<float, 16>, std::string> value;
};

/// Layers of one size, of at least one pixel, as the bytes of an EXR: scan lines, zip compression, all channels floats.
/// A channel "A" is alpha, which the others are multiplied by.
[[nodiscard]] std::vector<std::uint8_t> encodeExr(std::span<const Layer>, std::span<const HeaderEntry>);

}  // namespace inkedge::images
