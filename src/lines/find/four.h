#pragma once

#ifdef __SSE__
#include <xmmintrin.h>
#endif

namespace inkedge::lines {

/// Four floats that a processor computes with at once; a comparison of two gives FourBits.
using Four = float __attribute__((vector_size(16)));
using FourBits = decltype(Four{} < Four{});

[[nodiscard]] inline Four four(float value) noexcept { return Four{value, value, value, value}; }
[[nodiscard]] inline Four smaller(Four a, Four b) noexcept { return a < b ? a : b; }
[[nodiscard]] inline Four larger(Four a, Four b) noexcept { return a > b ? a : b; }

/// Bit k is set where comparison k holds.
[[nodiscard]] inline unsigned bitsOf(FourBits bits) noexcept {
#ifdef __SSE__
    return static_cast<unsigned>(_mm_movemask_ps(reinterpret_cast<Four>(bits)));
#else
    return (bits[0] != 0 ? 1U : 0U) | (bits[1] != 0 ? 2U : 0U) | (bits[2] != 0 ? 4U : 0U) | (bits[3] != 0 ? 8U : 0U);
#endif
}

}  // namespace inkedge::lines
