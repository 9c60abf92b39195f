#pragma once

#include <cstddef>

#include <meshoptimizer.h>

/// Encodes floats with the filter EXPONENTIAL, one exponent a vector: meshoptimizer asks for that mode from 0.19 on.
inline void encodeExponential(void* to, std::size_t count, std::size_t stride, int bits, const float* from) {
#if MESHOPTIMIZER_VERSION >= 190
    meshopt_encodeFilterExp(to, count, stride, bits, from, meshopt_EncodeExpSharedVector);
#else
    meshopt_encodeFilterExp(to, count, stride, bits, from);
#endif
}
