#include "images/decode_picture.h"

#include <malloc.h>

#include <array>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <webp/encode.h>

#include <inkedge/error.h>

namespace inkedge::images {
namespace {

// 16 x 8 pixels: (200, 40, 40) on the left, (30, 60, 220) on the right.
constexpr auto jpeg = std::to_array<std::uint8_t>({
    0xff, 0xd8, 0xff, 0xe0, 0x00, 0x10, 0x4a, 0x46, 0x49, 0x46, 0x00, 0x01, 0x01, 0x00, 0x00, 0x01, 0x00, 0x01, 0x00,
    0x00, 0xff, 0xdb, 0x00, 0x43, 0x00, 0x0d, 0x09, 0x0a, 0x0b, 0x0a, 0x08, 0x0d, 0x0b, 0x0a, 0x0b, 0x0e, 0x0e, 0x0d,
    0x0f, 0x13, 0x20, 0x15, 0x13, 0x12, 0x12, 0x13, 0x27, 0x1c, 0x1e, 0x17, 0x20, 0x2e, 0x29, 0x31, 0x30, 0x2e, 0x29,
    0x2d, 0x2c, 0x33, 0x3a, 0x4a, 0x3e, 0x33, 0x36, 0x46, 0x37, 0x2c, 0x2d, 0x40, 0x57, 0x41, 0x46, 0x4c, 0x4e, 0x52,
    0x53, 0x52, 0x32, 0x3e, 0x5a, 0x61, 0x5a, 0x50, 0x60, 0x4a, 0x51, 0x52, 0x4f, 0xff, 0xdb, 0x00, 0x43, 0x01, 0x0e,
    0x0e, 0x0e, 0x13, 0x11, 0x13, 0x26, 0x15, 0x15, 0x26, 0x4f, 0x35, 0x2d, 0x35, 0x4f, 0x4f, 0x4f, 0x4f, 0x4f, 0x4f,
    0x4f, 0x4f, 0x4f, 0x4f, 0x4f, 0x4f, 0x4f, 0x4f, 0x4f, 0x4f, 0x4f, 0x4f, 0x4f, 0x4f, 0x4f, 0x4f, 0x4f, 0x4f, 0x4f,
    0x4f, 0x4f, 0x4f, 0x4f, 0x4f, 0x4f, 0x4f, 0x4f, 0x4f, 0x4f, 0x4f, 0x4f, 0x4f, 0x4f, 0x4f, 0x4f, 0x4f, 0x4f, 0x4f,
    0x4f, 0x4f, 0x4f, 0x4f, 0x4f, 0x4f, 0xff, 0xc0, 0x00, 0x11, 0x08, 0x00, 0x08, 0x00, 0x10, 0x03, 0x01, 0x11, 0x00,
    0x02, 0x11, 0x01, 0x03, 0x11, 0x01, 0xff, 0xc4, 0x00, 0x15, 0x00, 0x01, 0x01, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00,
    0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x04, 0x05, 0xff, 0xc4, 0x00, 0x14, 0x10, 0x01, 0x00, 0x00, 0x00,
    0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0xff, 0xc4, 0x00, 0x16, 0x01, 0x01,
    0x01, 0x01, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x06, 0x04, 0x07, 0xff,
    0xc4, 0x00, 0x14, 0x11, 0x01, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00,
    0x00, 0x00, 0xff, 0xda, 0x00, 0x0c, 0x03, 0x01, 0x00, 0x02, 0x11, 0x03, 0x11, 0x00, 0x3f, 0x00, 0x8c, 0x80, 0xb8,
    0x46, 0x80, 0x02, 0xff, 0xd9,
});

void expectColor(const Image<std::uint8_t>& image, int x, int y, std::array<int, 3> color) {
    for (int c = 0; c < 3; ++c) {
        // What this quality loses: some steps of 255.
        EXPECT_NEAR(int{image.at(x, y, c)}, color.at(static_cast<std::size_t>(c)), 6) << x << ", " << y << ", " << c;
    }
    EXPECT_EQ(image.at(x, y, 3), 255);
}

std::string refusalOf(std::span<const std::uint8_t> bytes, std::uint64_t maxPixels = 1000) {
    try {
        (void)decodePicture(bytes, maxPixels);
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), Error::Kind::Input);
        return error.what();
    }
    return {};
}

TEST(DecodePicture, readsJpeg) {
    const Image<std::uint8_t> image = decodePicture(jpeg, 1000);
    ASSERT_EQ(image.size(), (Size{16, 8}));
    ASSERT_EQ(image.channels(), 4);
    expectColor(image, 2, 3, {200, 40, 40});
    expectColor(image, 13, 3, {30, 60, 220});
}

TEST(DecodePicture, refusesWhatIsDamagedTooLargeOrNoPicture) {
    EXPECT_THAT(refusalOf(std::span{jpeg}.first(60)), testing::HasSubstr("expected a JPEG picture, found: "));
    EXPECT_THAT(refusalOf(jpeg, 100), testing::HasSubstr("16x8; raise max-image-pixels"));
    const std::array<std::uint8_t, 4> text{'R', 'I', 'F', 'F'};
    EXPECT_THAT(refusalOf(text), testing::HasSubstr("expected a PNG, JPEG or WebP picture, found other text"));
}

// 3 x 2 pixels; the encoders keep them exactly.
constexpr auto pixels = std::to_array<std::uint8_t>({
    200, 40, 40, 255, 30, 60, 220, 255, 0,   0,   0,   255,  //
    10,  20, 30, 128, 1,  2,  3,   7,   255, 255, 255, 255,
});

enum class Alpha { None, Some };

std::vector<std::uint8_t> webp(Alpha alpha) {
    std::vector<std::uint8_t> rgb;
    for (std::size_t i = 0; i < pixels.size(); ++i)
        if (i % 4 != 3) rgb.push_back(pixels[i]);
    std::uint8_t* bytes = nullptr;
    const std::size_t size = alpha == Alpha::Some ? WebPEncodeLosslessRGBA(pixels.data(), 3, 2, 12, &bytes)
                                                  : WebPEncodeLosslessRGB(rgb.data(), 3, 2, 9, &bytes);
    std::vector<std::uint8_t> file{bytes, bytes + size};
    WebPFree(bytes);
    return file;
}

TEST(DecodePicture, readsWebp) {
    const Image<std::uint8_t> image = decodePicture(webp(Alpha::Some), 1000);
    ASSERT_EQ(image.size(), (Size{3, 2}));
    EXPECT_THAT(image.pixels(), testing::ElementsAreArray(pixels));
    const Image<std::uint8_t> opaque = decodePicture(webp(Alpha::None), 1000);
    for (std::size_t i = 0; i < pixels.size(); ++i) EXPECT_EQ(opaque.pixels()[i], i % 4 == 3 ? 255 : pixels[i]) << i;
}

TEST(DecodePicture, readsTheOpacityOfWebp) {
    const auto opacity = decodeOpacity(webp(Alpha::Some), 1000);
    ASSERT_TRUE(opacity);
    EXPECT_THAT(opacity->pixels(), testing::ElementsAre(255, 255, 255, 128, 7, 255));
    EXPECT_FALSE(decodeOpacity(webp(Alpha::None), 1000));
}

TEST(DecodePicture, refusesWebpThatIsDamagedTooLargeOrAnAnimation) {
    const std::vector<std::uint8_t> whole = webp(Alpha::Some);
    for (std::size_t size = 12; size + 2 < whole.size(); ++size)
        EXPECT_THAT(refusalOf(std::span{whole}.first(size)), testing::StartsWith("expected a WebP picture, found "));
    EXPECT_EQ(refusalOf(whole, 5), "expected at most 5 pixels, found 3x2; raise max-image-pixels");
    std::vector<std::uint8_t> animation{'R', 'I', 'F', 'F', 22, 0, 0, 0, 'W', 'E', 'B', 'P', 'V', 'P', '8',
                                        'X', 10,  0,   0,   0,  2, 0, 0, 0,   2,   0,   0,   1,   0,   0};
    EXPECT_EQ(refusalOf(animation), "expected a WebP picture, found an animation");
}

TEST(DecodePicture, namesThePicturesThatItDoesNotRead) {
    const auto nameOf = [](std::string_view start) {
        const std::vector<std::uint8_t> bytes{start.begin(), start.end()};
        return refusalOf(bytes);
    };
    constexpr const char* expected = "expected a PNG, JPEG or WebP picture, found ";
    using namespace std::string_literals;
    EXPECT_EQ(nameOf("\xabKTX 20\xbb\r\n"s), expected + "a KTX2 picture; convert it"s);
    EXPECT_EQ(nameOf("DDS |"s), expected + "a DDS picture; convert it"s);
    EXPECT_EQ(nameOf("\x13\xab\xa1\x5c"s), expected + "an ASTC picture; convert it"s);
    EXPECT_EQ(nameOf("\0\0\0\x20"
                     "ftypavif"s),
              expected + "an AVIF picture; convert it"s);
}

// 16 x 16 black pixels.
constexpr auto png = std::to_array<std::uint8_t>({
    0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x48, 0x44, 0x52, 0x00, 0x00,
    0x00, 0x10, 0x00, 0x00, 0x00, 0x10, 0x08, 0x00, 0x00, 0x00, 0x00, 0x3a, 0x98, 0xa0, 0xbd, 0x00, 0x00, 0x00,
    0x0d, 0x49, 0x44, 0x41, 0x54, 0x78, 0xda, 0x63, 0x60, 0x18, 0x05, 0xc8, 0x00, 0x00, 0x01, 0x10, 0x00, 0x01,
    0x7f, 0xcd, 0x03, 0xb5, 0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82,
});

TEST(DecodePicture, keepsNothingOfAPngThatItRefuses) {
    ASSERT_EQ(decodePicture(png, 1000).size(), (Size{16, 16}));
    const auto refuseOften = [] {
        for (int i = 0; i < 1000; ++i)
            ASSERT_THAT(refusalOf(png, 100), testing::HasSubstr("16x16; raise max-image-pixels"));
    };
    refuseOften();
    const std::size_t before = ::mallinfo2().uordblks;
    refuseOften();
    EXPECT_LT(::mallinfo2().uordblks, before + 100'000);  // libpng keeps 1600 bytes for each
}

}  // namespace
}  // namespace inkedge::images
