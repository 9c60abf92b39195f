#include "base/deflate.h"

#include <libdeflate.h>

#include <memory>
#include <new>

namespace inkedge::base {

std::vector<std::uint8_t> deflated(std::span<const std::uint8_t> bytes, DeflateWrapper wrapper) {
    constexpr int quickest = 1;
    const std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)> compressor{
        libdeflate_alloc_compressor(quickest), libdeflate_free_compressor};
    if (!compressor) throw std::bad_alloc{};
    std::vector<std::uint8_t> compressed(bytes.size());
    const auto compress = wrapper == DeflateWrapper::Zlib ? libdeflate_zlib_compress : libdeflate_deflate_compress;
    compressed.resize(compress(compressor.get(), bytes.data(), bytes.size(), compressed.data(), compressed.size()));
    if (compressed.size() >= bytes.size()) compressed.clear();
    return compressed;
}

std::uint32_t crc32(std::span<const std::uint8_t> bytes) noexcept {
    return libdeflate_crc32(0, bytes.data(), bytes.size());
}

}  // namespace inkedge::base
