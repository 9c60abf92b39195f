#include <inkedge/encode_png.h>

#include <cmath>

#include <gmock/gmock.h>
#include <png.h>

#include <inkedge/write.h>

#include "base/expect_error.h"
#include "images/read_png.h"
#include "io/decoded_files.h"

namespace {

using namespace inkedge::decoded_files;
using namespace inkedge;
using testing::ElementsAreArray;
using testing::HasSubstr;

TEST(EncodePng, keepsGreyInOneChannelOfEightBits) {
    const Image<std::uint8_t> picture = noise({37, 5}, 1);
    const DecodedPng decoded = decodePng(encodePng(picture));
    EXPECT_EQ(decoded.bitDepth, 8);
    EXPECT_EQ(decoded.colorType, PNG_COLOR_TYPE_GRAY);
    EXPECT_EQ(decoded.image.size(), picture.size());
    EXPECT_EQ(decoded.image, picture);
}

TEST(EncodePng, keepsEveryValueOfColourAndAlpha) {
    for (const int channels : {3, 4}) {
        const Image<std::uint8_t> picture = noise({5, 37}, channels);
        const DecodedPng decoded = decodePng(encodePng(picture));
        EXPECT_EQ(decoded.colorType, channels == 3 ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_RGB_ALPHA);
        EXPECT_EQ(decoded.image.size(), picture.size());
        EXPECT_EQ(decoded.image, picture);
    }
}

TEST(EncodePng, keepsEveryValueOfUpTo256ColoursInAPalette) {
    for (const int channels : {3, 4}) {
        for (const std::size_t colors : {1U, 255U, 256U, 257U}) {
            const Image<std::uint8_t> some = noise({static_cast<int>(colors), 1}, channels);
            Image<std::uint8_t> picture{{93, 71}, channels};
            for (std::size_t i = 0; i < picture.pixels().size(); ++i)
                picture.mutablePixels()[i] = some.pixels()[i % some.pixels().size()];
            const DecodedPng decoded = decodePng(encodePng(picture));
            EXPECT_EQ(decoded.colorType == PNG_COLOR_TYPE_PALETTE, colors <= 256) << colors;
            EXPECT_EQ(decoded.image.channels(), channels);
            EXPECT_EQ(decoded.image, picture) << channels << " channels, " << colors << " colours";
        }
    }
}

TEST(EncodePng, holdsTheResolution) {
    const auto density = [](const std::vector<std::uint8_t>& png) {
        const std::string bytes(png.begin(), png.end());
        const std::size_t at = bytes.find("pHYs");
        return at == std::string::npos ? std::string{} : bytes.substr(at + 4, 9);
    };
    const std::string perMetre{"\x00\x00\x2e\x23\x00\x00\x2e\x23\x01", 9};  // 300 / 0.0254 = 11811
    EXPECT_EQ(density(encodePng(noise({5, 3}, 3), 300.0)), perMetre);
    EXPECT_EQ(density(encodePng(Image<std::uint16_t>{{5, 3}, 1}, 300.0)), perMetre);
    Image<std::uint8_t> palette{{93, 71}, 3};
    EXPECT_EQ(density(encodePng(palette, 300.0)), perMetre);
    EXPECT_EQ(density(encodePng(palette)), "");
    EXPECT_EQ(density(encodePng(palette, 1e-9)), "") << "less than a file can tell";
    EXPECT_EQ(density(encodePng(palette, 1e12)), "");
}

TEST(EncodePng, isSmallOnALinePicture) {
    Image<std::uint8_t> picture{{1024, 1024}, 1, 255};
    for (int y = 0; y < 1024; ++y) picture.at(y, y) = picture.at(1023 - y, y) = 0;
    EXPECT_LT(encodePng(picture).size(), 16U * 1024U);
}

TEST(EncodePng, refusesAPictureOfTwoChannels) {
    expectError(Error::Kind::Usage, HasSubstr("expected a picture of 1, 3 or 4 channels, found 2"), [] {
        static_cast<void>(encodePng(Image<std::uint8_t>{{1, 1}, 2}));
    });
}

TEST(EncodePng, refusesAPictureWithoutPixels) {
    expectError(Error::Kind::Usage, HasSubstr("expected a picture of at least one pixel"),
                [] { static_cast<void>(encodePng(Image<std::uint8_t>{})); });
}

// Pixels of a PNG of one channel of 16 bits: the file's own, most significant byte first.
std::vector<std::uint16_t> decodeGrey16(const std::vector<std::uint8_t>& bytes) {
    const images::ReadPicture picture = images::readPng(bytes);
    std::vector<std::uint16_t> values;
    for (const float v : picture.image.pixels())
        values.push_back(static_cast<std::uint16_t>(std::lround(v * 65535.0F)));
    return values;
}

// Rows of runs are written as they are, others as differences, and both in blocks.
TEST(EncodePng, keepsRunsAndSlopes) {
    Image<std::uint16_t> map{{400, 300}, 1};
    for (int y = 0; y < 300; ++y)
        for (int x = 0; x < 400; ++x)
            map.at(x, y) = static_cast<std::uint16_t>(y % 3 == 0 ? 1000 * (x / 100) : 65535 - 150 * x - 7 * y);
    EXPECT_EQ(decodeGrey16(encodePng(map)), map.pixels());
}

TEST(EncodePng, keepsEveryBitOfATypesMap) {
    Image<std::uint16_t> types{{6, 1}, 1, {0, 1, 255, 256, 0x8001, 0xFFFF}};
    const std::vector<std::uint8_t> bytes = encodePng(types);
    EXPECT_EQ(bytes[24], 16) << "bits a sample";
    EXPECT_EQ(bytes[25], PNG_COLOR_TYPE_GRAY);
    EXPECT_THAT(decodeGrey16(bytes), ElementsAreArray(types.pixels()));
    expectError(Error::Kind::Usage, testing::StrEq("PNG: expected a picture of at least one pixel, found none"),
                [] { static_cast<void>(encodePng(Image<std::uint16_t>{})); });
}

}  // namespace
