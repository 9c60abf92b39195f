#include "base/deflate.h"

#include <libdeflate.h>

#include <memory>
#include <new>

namespace inkedge::base {

std::vector<std::uint8_t> deflated(std::span<const std::uint8_t> bytes, DeflateWrapper wrapper) {
    // The quickest: level 1 takes twice the time for maps of few values, whose rows repeat each other.
    constexpr int level = 2;
    const std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)> compressor{
        libdeflate_alloc_compressor(level), libdeflate_free_compressor};
    if (!compressor) throw std::bad_alloc{};
    const bool zlib = wrapper == DeflateWrapper::Zlib;
    const auto bound = zlib ? libdeflate_zlib_compress_bound : libdeflate_deflate_compress_bound;
    const auto compress = zlib ? libdeflate_zlib_compress : libdeflate_deflate_compress;
    const std::size_t room = bound(compressor.get(), bytes.size());
    const auto compressed = std::make_unique_for_overwrite<std::uint8_t[]>(room);
    const std::size_t size = compress(compressor.get(), bytes.data(), bytes.size(), compressed.get(), room);
    return {compressed.get(), compressed.get() + size};
}

std::uint32_t crc32(std::span<const std::uint8_t> bytes) noexcept {
    return libdeflate_crc32(0, bytes.data(), bytes.size());
}

}  // namespace inkedge::base
