// What is compressed is what zlib gives back.
#include "base/deflate.h"

#include <zlib.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>
#include <span>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#ifdef __x86_64__
#include <cpuid.h>
#include <immintrin.h>
#endif

namespace inkedge::base {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::size_t large = 3'000'000;

// Of so few values that it repeats itself, or of 256: noise.
Bytes ofValues(std::size_t size, int values) {
    std::mt19937 random{7};
    std::uniform_int_distribution<int> value{0, values - 1};
    Bytes bytes(size);
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(value(random));
    return bytes;
}

// Fails unless it is one whole stream.
Bytes inflated(const Bytes& compressed, DeflateWrapper wrapper, std::size_t size) {
    Bytes bytes(size + 1);
    z_stream stream{};
    EXPECT_EQ(inflateInit2(&stream, wrapper == DeflateWrapper::Zlib ? MAX_WBITS : -MAX_WBITS), Z_OK);
    stream.next_in = const_cast<Bytef*>(compressed.data());
    stream.avail_in = static_cast<uInt>(compressed.size());
    stream.next_out = bytes.data();
    stream.avail_out = static_cast<uInt>(bytes.size());
    EXPECT_EQ(inflate(&stream, Z_FINISH), Z_STREAM_END);
    EXPECT_EQ(stream.avail_in, 0U);
    bytes.resize(stream.total_out);
    EXPECT_EQ(inflateEnd(&stream), Z_OK);
    return bytes;
}

TEST(Deflate, isUndoneByZlib) {
    for (const DeflateWrapper wrapper : {DeflateWrapper::None, DeflateWrapper::Zlib}) {
        for (const std::size_t size : {std::size_t{0}, std::size_t{1}, std::size_t{2}, std::size_t{16384}, large}) {
            for (const int values : {1, 2, 17, 256}) {
                const Bytes bytes = ofValues(size, values);
                const Bytes compressed = deflated(bytes, wrapper);
                EXPECT_EQ(inflated(compressed, wrapper, size), bytes) << size << " bytes of " << values;
                EXPECT_LE(compressed.size(), size + size / 1000 + 32) << size << " bytes of " << values;
            }
        }
    }
}

TEST(Deflate, takesWhatRepeatsItselfInLittle) {
    EXPECT_LT(deflated(ofValues(large, 1), DeflateWrapper::Zlib).size(), large / 150);
    EXPECT_LT(deflated(ofValues(large, 2), DeflateWrapper::Zlib).size(), large / 4) << "an eighth are bits of noise";
}

TEST(Deflate, takesPiecesOfAnySize) {
    const Bytes bytes = ofValues(large, 17);
    for (const std::size_t piece : {std::size_t{1009}, std::size_t{65536}, std::size_t{1'000'000}}) {
        Deflater deflater{DeflateWrapper::Zlib};
        for (std::size_t at = 0; at < bytes.size(); at += piece)
            deflater.add(std::span{bytes}.subspan(at, std::min(piece, bytes.size() - at)));
        EXPECT_EQ(inflated(deflater.finish(), DeflateWrapper::Zlib, large), bytes) << piece;
    }
}

TEST(Crc32, isThatOfZip) {
    constexpr std::string_view digits = "123456789";  // the check value of CRC-32/ISO-HDLC
    EXPECT_EQ(crc32(Bytes{digits.begin(), digits.end()}), 0xCBF43926U);
    EXPECT_EQ(crc32({}), 0U);
    const Bytes bytes = ofValues(large, 256);
    EXPECT_EQ(base::crc32(bytes), ::crc32(0, bytes.data(), static_cast<uInt>(bytes.size())));
}

#ifdef __x86_64__
[[gnu::target("avx"), gnu::noinline]] void zeroUpperHalves() { _mm256_zeroupper(); }

// Bit 2 of the state that is in use (Intel SDM 1, 13.6): the upper halves of the vector registers. With them code that
// knows the lower ones alone takes four times as long on some processors.
TEST(Deflate, leavesVectorsAsTheyWere) {
    constexpr unsigned readsInUse = 1U << 2U;  // of leaf 0xD, 1: xgetbv has a register for it
    unsigned a = 0, b = 0, c = 0, d = 0;
    if (!__builtin_cpu_supports("avx") || __get_cpuid_count(0xD, 1, &a, &b, &c, &d) == 0 || (a & readsInUse) == 0)
        GTEST_SKIP() << "the processor has no AVX, or does not say what is in use";
    const auto inUse = [] {
        std::uint32_t low = 0;
        std::uint32_t high = 0;
        asm volatile("xgetbv" : "=a"(low), "=d"(high) : "c"(1));
        return low & 4U;
    };
    zeroUpperHalves();
    if (inUse() != 0) GTEST_SKIP() << "the processor says that they are in use after vzeroupper, too";
    const Bytes bytes = ofValues(65536, 17);
    static_cast<void>(deflated(bytes, DeflateWrapper::Zlib));
    EXPECT_EQ(inUse(), 0U);
    static_cast<void>(crc32(bytes));
    EXPECT_EQ(inUse(), 0U);
}
#endif

}  // namespace
}  // namespace inkedge::base
