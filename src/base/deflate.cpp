#include "base/deflate.h"

#include <isa-l/crc.h>
#include <isa-l/igzip_lib.h>

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#ifdef __x86_64__
#include <immintrin.h>
#endif

namespace inkedge::base {
namespace {

// Larger pieces than this have sizes that ISA-L's fields cannot hold.
constexpr std::size_t maxPiece = std::numeric_limits<std::uint32_t>::max();

// ISA-L 2.30 and 2.31 leave the upper halves of vector registers in use, with which code that knows the lower ones
// alone runs four times as long: to be called after each of its functions.
#ifdef __x86_64__
[[gnu::target("avx")]] void zeroUpperHalves() { _mm256_zeroupper(); }
void giveBackVectors() {
    static const bool has = __builtin_cpu_supports("avx");
    if (has) zeroUpperHalves();
}
#else
void giveBackVectors() {}
#endif

}  // namespace

struct Deflater::State {
    isal_zstream stream;
    std::array<std::uint8_t, ISAL_DEF_LVL1_MEDIUM> work;
};

Deflater::Deflater(DeflateWrapper wrapper) : state_{std::make_unique_for_overwrite<State>()} {
    isal_zstream& stream = state_->stream;
    isal_deflate_init(&stream);
    // Level 2 takes as long, for files smaller by 1 % at best; level 3 takes 3 to 16 times as long.
    stream.level = 1;
    stream.level_buf = state_->work.data();
    stream.level_buf_size = static_cast<std::uint32_t>(state_->work.size());
    stream.gzip_flag = wrapper == DeflateWrapper::Zlib ? IGZIP_ZLIB : IGZIP_DEFLATE;
}

Deflater::~Deflater() = default;

void Deflater::add(std::span<const std::uint8_t> bytes) {
    while (!bytes.empty()) {
        const auto piece = bytes.first(std::min(bytes.size(), maxPiece));
        compress(piece, false);
        bytes = bytes.subspan(piece.size());
    }
}

std::vector<std::uint8_t> Deflater::finish() {
    compress({}, true);
    compressed_.resize(size_);
    return std::move(compressed_);
}

void Deflater::compress(std::span<const std::uint8_t> bytes, bool last) {
    constexpr std::size_t firstRoom = 16384;
    isal_zstream& stream = state_->stream;
    stream.next_in = const_cast<std::uint8_t*>(bytes.data());  // it is read alone
    stream.avail_in = static_cast<std::uint32_t>(bytes.size());
    stream.end_of_stream = last ? 1 : 0;
    do {
        if (size_ == compressed_.size()) compressed_.resize(std::max(firstRoom, 2 * size_));
        const auto room = static_cast<std::uint32_t>(std::min(compressed_.size() - size_, maxPiece));
        stream.next_out = &compressed_[size_];
        stream.avail_out = room;
        isal_deflate(&stream);
        giveBackVectors();
        size_ += room - stream.avail_out;
    } while (stream.avail_out == 0);
}

std::vector<std::uint8_t> deflated(std::span<const std::uint8_t> bytes, DeflateWrapper wrapper) {
    Deflater deflater{wrapper};
    deflater.add(bytes);
    return deflater.finish();
}

std::uint32_t crc32(std::span<const std::uint8_t> bytes) noexcept {
    const std::uint32_t checksum = crc32_gzip_refl(0, bytes.data(), bytes.size());
    giveBackVectors();
    return checksum;
}

}  // namespace inkedge::base
