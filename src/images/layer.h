#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include <inkedge/image.h>
#include <inkedge/maps.h>

namespace inkedge::images {

/// Channels of a file that come from one image.
struct Layer {
    AnyImagePointer image;
    std::vector<std::string> channels;  ///< a name for each that is written
    int first = 0;                      ///< of the image's channels: the first that is written

    [[nodiscard]] Size size() const {
        return std::visit([](const auto* each) { return each->size(); }, image);
    }
};

/// A value as files of floats hold it: 8 bits stand for 0..1, numbers stay as they are.
[[nodiscard]] inline float stored(float value) noexcept { return value; }
[[nodiscard]] inline float stored(std::uint8_t value) noexcept { return static_cast<float>(value) / 255.0F; }
[[nodiscard]] inline float stored(std::uint16_t value) noexcept { return static_cast<float>(value); }
[[nodiscard]] inline float stored(std::uint32_t value) noexcept { return static_cast<float>(value); }

}  // namespace inkedge::images
