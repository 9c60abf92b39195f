#include "passes/read_ink.h"

#include <algorithm>
#include <cmath>

#include "gl/read_back.h"

namespace inkedge::passes {

Image<std::uint8_t> readInk(const gl::Api& api, const gl::Texture& ink) {
    const Image<float> shares = gl::readFloats(api, ink, 1);
    Image<std::uint8_t> bytes{shares.size(), 1};
    std::ranges::transform(shares.pixels(), bytes.mutablePixels().begin(), [](float share) {
        return static_cast<std::uint8_t>(std::lround(255.0F * std::clamp(share, 0.0F, 1.0F)));
    });
    return bytes;
}

}  // namespace inkedge::passes
