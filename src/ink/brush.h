#pragma once

#include <cstdint>
#include <filesystem>

#include <inkedge/image.h>
#include <inkedge/settings.h>

namespace inkedge::ink {

/// A texture that strokes are drawn with. Its height lies across a stroke, its width along the line, repeated. It keeps
/// its aspect where the stroke has its pen's width. Around a closed line it is repeated a whole number of times,
/// stretched a little.
struct Brush {
    Image<std::uint8_t> ink;  ///< one channel, 0 none to 255 full; at least one pixel
};

/// @throws Error  (Kind::Input) if the file cannot be read, is no PNG or a damaged one, or is over the limits
[[nodiscard]] Brush readBrush(const std::filesystem::path&, const LoadLimits&);

/// A brush for a pen of one width: its texture is no finer than pixels.
class FittedBrush {
public:
    /// @param penWidth  pixels, over 0
    FittedBrush(const Brush&, double penWidth);

    /// The ink, 0 to 1, linear between the centres of the texture's pixels.
    /// @param along   length along the line, pixels
    /// @param across  -0.5 to 0.5 from one side of the stroke to the other; beyond a side its ink is repeated
    [[nodiscard]] float inkAt(float along, float across) const noexcept;

    /// The factor for lengths along a closed line with which a whole number of textures goes around the line, at least
    /// one, so that the last texture meets the first.
    /// @param around  length around the line, pixels; 0 for an open line, whose factor is 1
    [[nodiscard]] float stretchAround(float around) const noexcept;

private:
    Image<float> ink_;
    float perPixel_;  // of the picture: pixels of ink_ along the line
};

}  // namespace inkedge::ink
