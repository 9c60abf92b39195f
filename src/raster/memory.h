#pragma once

#include <cstdint>
#include <optional>

#include <inkedge/image.h>

namespace inkedge::raster {

/// Bytes that this process can still allocate without taking them from another process, swap included; none where the
/// system does not say.
[[nodiscard]] std::optional<std::uint64_t> availableMemory();

/// Checks that there is memory for a large picture before it is drawn. Systems promise more memory than they have, and
/// kill the process that uses it.
/// @throws Error  (Kind::Runtime) if less is available
void expectMemory(Size picture, std::uint64_t bytesPerPixel);

}  // namespace inkedge::raster
