#pragma once

#include <cstdint>
#include <optional>

#include <inkedge/image.h>

namespace inkedge {

/// Bytes that this process can still have without another one's loss, swap included; none where the system does not
/// say.
[[nodiscard]] std::optional<std::uint64_t> availableMemory();

/// Systems promise more memory than they have and end the process that takes it: asks before a large picture is drawn.
/// @throws Error  (Kind::Runtime) if less is available
void expectMemory(Size picture, std::uint64_t bytesPerPixel);

}  // namespace inkedge
