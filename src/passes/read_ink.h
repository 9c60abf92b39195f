#pragma once

#include <inkedge/image.h>

#include "gl/gpu.h"

namespace inkedge::passes {

/// Reads shares from 0 to 1 as bytes from 0 to 255.
/// @param ink  one channel of floats
[[nodiscard]] Image<std::uint8_t> readInk(const gl::Api&, const gl::Texture& ink);

}  // namespace inkedge::passes
