#pragma once

#include <cstdint>
#include <filesystem>

#include <inkedge/image.h>
#include <inkedge/settings.h>

namespace inkedge {

/// A texture that strokes are drawn with: its height lies across a stroke, its width along its line, again and again,
/// in its own aspect where the stroke has its pen's width; around a closed line a whole number of times, stretched a
/// little.
struct Brush {
    Image<std::uint8_t> ink;  ///< one channel, 0 none to 255 full; at least one pixel
};

/// @throws Error  (Kind::Input) if the file cannot be read, is no PNG or a damaged one, or is over the limits
[[nodiscard]] Brush readBrush(const std::filesystem::path&, const LoadLimits&);

/// A brush as a pen of one width draws with it: no finer than pixels.
class FittedBrush {
public:
    /// @param penWidth  pixels, over 0
    FittedBrush(const Brush&, double penWidth);

    /// The ink, 0 to 1, linear between the centres of the texture's pixels.
    /// @param along   pixels of way along the line
    /// @param across  -0.5 to 0.5 from one side of the stroke to the other; beyond, the side's ink
    [[nodiscard]] float inkAt(float along, float across) const noexcept;

    /// By what to multiply the way along a closed line so that a whole number of textures, the nearest but one at
    /// least, goes around it: its end then meets its start.
    /// @param around  pixels of way around it; 0, an open line: 1
    [[nodiscard]] float stretchAround(float around) const noexcept;

private:
    Image<float> ink_;
    float perPixel_;  // of the picture: pixels of ink_ along the line
};

}  // namespace inkedge
