#pragma once

#include <span>

#include "images/image_formats.h"

namespace inkedge::io {

/// Whether bytes begin as every PNG does.
[[nodiscard]] bool isPng(std::span<const std::uint8_t> bytes) noexcept;

/// A PNG's pixels, palettes resolved, alpha not multiplied in, values as they are in the file. Not read by
/// OpenImageIO, which tells stderr what is wrong with a PNG and leaks.
/// @return with a failure, "expected ..., found ...; ...", if it is broken or cut short
[[nodiscard]] ReadPicture readPng(std::span<const std::uint8_t> bytes);

}  // namespace inkedge::io
