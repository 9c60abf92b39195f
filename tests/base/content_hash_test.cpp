#include "base/content_hash.h"

#include <gmock/gmock.h>

#include "base/temporary_folder.h"

namespace inkedge::base {
namespace {

std::string hexOf(std::string_view text) {
    ContentHash hash;
    hash.add(std::span{reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
    return hash.hex();
}

// By the reference implementation, seed 0, as others print it.
TEST(ContentHash, isMurmurHash3) {
    EXPECT_EQ(hexOf(""), "00000000000000000000000000000000");
    EXPECT_EQ(hexOf("hello"), "cbd8a7b341bd9b025b1e906a48ae1d19");
    EXPECT_EQ(hexOf("The quick brown fox jumps over the lazy dog"), "e34bbc7bbc071b6c7a433ca9c49a9347");
}

TEST(ContentHash, isTheSameHoweverTheBytesCome) {
    std::string text;
    for (int i = 0; i < 200; ++i) text += static_cast<char>(7 * i);
    for (std::size_t cut = 0; cut <= 40; ++cut) {
        ContentHash hash;
        const auto* const bytes = reinterpret_cast<const std::uint8_t*>(text.data());
        hash.add(std::span{bytes, cut});
        hash.add(std::span{bytes + cut, 3});
        hash.add(std::span{bytes + cut + 3, text.size() - cut - 3});
        EXPECT_EQ(hash.hex(), hexOf(text)) << cut;
    }
}

TEST(ContentHash, keepsTextsApart) {
    ContentHash one;
    one.add(std::string_view{"ab"});
    one.add(std::string_view{"c"});
    ContentHash other;
    other.add(std::string_view{"a"});
    other.add(std::string_view{"bc"});
    EXPECT_NE(one.hex(), other.hex());
}

TEST(ContentHash, ofAFileIsThatOfItsBytes) {
    const TemporaryFolder folder;
    const std::string large(600'001, 'x');  // more than is read at once
    put(folder / "large", large);
    put(folder / "empty", "");
    EXPECT_EQ(hashOfFile(folder / "large"), hexOf(large));
    EXPECT_EQ(hashOfFile(folder / "empty"), hexOf(""));
    EXPECT_EQ(hashOfFile(folder / "missing"), std::nullopt);
    EXPECT_EQ(hashOfFile(folder.path()), std::nullopt);
}

}  // namespace
}  // namespace inkedge::base
