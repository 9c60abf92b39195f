#include "base/content_hash.h"

#include <algorithm>
#include <bit>
#include <fstream>
#include <vector>

#include <fmt/format.h>

namespace inkedge::base {
namespace {

constexpr std::uint64_t c1 = 0x87c37b91114253d5U;
constexpr std::uint64_t c2 = 0x4cf5ad432745937fU;

// Little-endian on every machine.
std::uint64_t wordAt(const std::uint8_t* bytes) noexcept {
    std::uint64_t word = 0;
    for (std::size_t i = 0; i < sizeof word; ++i) word |= std::uint64_t{bytes[i]} << (8 * i);
    return word;
}

std::uint64_t scattered(std::uint64_t k) noexcept {
    k = (k ^ (k >> 33U)) * 0xff51afd7ed558ccdU;
    k = (k ^ (k >> 33U)) * 0xc4ceb9fe1a85ec53U;
    return k ^ (k >> 33U);
}

}  // namespace

void ContentHash::mix(std::uint64_t k1, std::uint64_t k2) noexcept {
    auto& [h1, h2] = state_;
    h1 ^= std::rotl(k1 * c1, 31) * c2;
    h1 = (std::rotl(h1, 27) + h2) * 5 + 0x52dce729;
    h2 ^= std::rotl(k2 * c2, 33) * c1;
    h2 = (std::rotl(h2, 31) + h1) * 5 + 0x38495ab5;
}

void ContentHash::add(std::span<const std::uint8_t> bytes) noexcept {
    constexpr std::size_t block = 16;
    const std::size_t kept = size_ % block;
    size_ += bytes.size();
    if (kept > 0) {
        const std::size_t count = std::min(block - kept, bytes.size());
        std::copy_n(bytes.begin(), count, rest_.begin() + static_cast<std::ptrdiff_t>(kept));
        bytes = bytes.subspan(count);
        if (kept + count < block) return;
        mix(wordAt(rest_.data()), wordAt(rest_.data() + 8));
    }
    for (; bytes.size() >= block; bytes = bytes.subspan(block)) mix(wordAt(bytes.data()), wordAt(bytes.data() + 8));
    std::ranges::copy(bytes, rest_.begin());
}

void ContentHash::add(std::string_view text) noexcept {
    std::array<std::uint8_t, 8> size{};
    for (std::size_t i = 0; i < size.size(); ++i)
        size[i] = static_cast<std::uint8_t>(std::uint64_t{text.size()} >> (8 * i));
    add(std::span<const std::uint8_t>{size});
    add({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

ContentHash::Value ContentHash::value() const noexcept {
    std::array<std::uint8_t, 16> last{};
    std::copy_n(rest_.begin(), size_ % 16, last.begin());
    auto [h1, h2] = state_;
    h1 ^= std::rotl(wordAt(last.data()) * c1, 31) * c2;
    h2 ^= std::rotl(wordAt(last.data() + 8) * c2, 33) * c1;
    h1 ^= size_;
    h2 ^= size_;
    h1 += h2;
    h2 += h1;
    h1 = scattered(h1);
    h2 = scattered(h2);
    h1 += h2;
    h2 += h1;
    return {h1, h2};
}

std::string ContentHash::hex() const {
    const auto [high, low] = value();
    return fmt::format("{:016x}{:016x}", high, low);
}

std::uint64_t hashOf(std::string_view text) noexcept {
    ContentHash hash;
    hash.add({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
    return hash.value()[0];
}

std::optional<std::string> hashOfFile(const std::filesystem::path& file) {
    std::error_code failure;
    if (!std::filesystem::is_regular_file(file, failure)) return {};
    std::ifstream stream{file, std::ios::binary};
    ContentHash hash;
    std::vector<std::uint8_t> bytes(std::size_t{1} << 18U);
    while (stream) {
        stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
        hash.add(std::span{bytes}.first(static_cast<std::size_t>(stream.gcount())));
    }
    if (!stream.eof()) return {};
    return hash.hex();
}

}  // namespace inkedge::base
