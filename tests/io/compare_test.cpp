#include <inkedge/compare.h>

#include <gmock/gmock.h>
#include <inkedge/write.h>
#include <png.h>
#include <zlib.h>

#include <cmath>
#include <limits>

#include "base/expect_error.h"
#include "base/temporary_folder.h"
#include "images/encode_exr.h"
#include "images/image_formats.h"
#include "images/read_png.h"

using namespace inkedge;
using testing::AllOf;
using testing::DoubleNear;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
namespace fs = std::filesystem;

namespace {

constexpr double oneLevel = 1.0 / 255.0;

/// Pictures in a folder of their own, compared by name.
class Compare : public testing::Test {
protected:
    fs::path save(const std::string& name, const Image<std::uint8_t>& picture) {
        writeFile(folder_ / name, encodePng(picture));
        return folder_ / name;
    }

    fs::path save(const std::string& name, const Image<float>& picture) {
        const images::Layer layer{&picture, {"Y"}};
        writeFile(folder_ / name, images::encodeExr({&layer, 1}, {}));
        return folder_ / name;
    }

    /// Two grey pictures of 10 x 10: all 100, and the same but for (7, 3), 20 brighter, and (1, 2), 10 brighter.
    void saveTwo() {
        Image<std::uint8_t> picture{{10, 10}, 1, 100};
        a_ = save("a.png", picture);
        picture.at(7, 3) = 120;
        picture.at(1, 2) = 110;
        b_ = save("b.png", picture);
    }

    static std::vector<int> levels(const fs::path& file) {
        const auto read = images::imageFormats(Error::Kind::Input).read(file);
        std::vector<int> result;
        for (const float value : read.image.pixels()) result.push_back(static_cast<int>(std::lround(value * 255.0F)));
        return result;
    }

    TemporaryFolder folder_;
    fs::path a_;
    fs::path b_;
};

struct PngKind {
    int colorType;
    int bits;
    int interlacing = PNG_INTERLACE_NONE;
    bool oneColorTransparent = false;
};

/// A PNG of 9 x 7 pixels of noise.
std::string noisyPng(const PngKind& kind) {
    std::string bytes;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_set_write_fn(
        png, &bytes,
        [](png_structp writer, png_bytep data, png_size_t size) {
            static_cast<std::string*>(png_get_io_ptr(writer))->append(reinterpret_cast<const char*>(data), size);
        },
        [](png_structp) {});
    png_set_IHDR(png, info, 9, 7, kind.bits, kind.colorType, kind.interlacing, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    const std::array<png_color, 4> palette{{{10, 20, 30}, {40, 50, 60}, {70, 80, 90}, {100, 110, 120}}};
    const std::array<png_byte, 2> alphas{0, 128};
    const png_color_16 color{1, 3, 3, 3, 3};
    const bool paletted = kind.colorType == PNG_COLOR_TYPE_PALETTE;
    if (paletted) png_set_PLTE(png, info, palette.data(), static_cast<int>(palette.size()));
    if (kind.oneColorTransparent) {
        png_set_tRNS(png, info, paletted ? alphas.data() : nullptr, paletted ? 2 : 1, paletted ? nullptr : &color);
    }
    png_write_info(png, info);
    std::vector<std::vector<png_byte>> rows(7, std::vector<png_byte>(png_get_rowbytes(png, info)));
    std::vector<png_bytep> pointers;
    unsigned value = 1;
    for (auto& row : rows) {
        for (png_byte& byte : row) byte = static_cast<png_byte>((value = value * 1664525U + 1013904223U) >> 24U);
        pointers.push_back(row.data());
    }
    png_write_image(png, pointers.data());
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    return bytes;
}

}  // namespace

TEST_F(Compare, findsAPictureTheSameAsItself) {
    saveTwo();
    const Comparison result = compare(a_, a_, {});
    EXPECT_TRUE(result.same);
    EXPECT_EQ(result.pixelsOverLevel, 0U);
    EXPECT_EQ(result.maximum, 0.0);
    EXPECT_EQ(result.mean, 0.0);
}

TEST_F(Compare, saysHowManyHowMuchAndWhere) {
    saveTwo();
    const Comparison result = compare(a_, b_, {});
    EXPECT_FALSE(result.same);
    EXPECT_EQ(result.size, (Size{10, 10}));
    EXPECT_EQ(result.channels, 1);
    EXPECT_EQ(result.pixelsOverLevel, 2U);
    EXPECT_EQ(result.shareOverLevel, 0.02);
    EXPECT_THAT(result.maximum, DoubleNear(20 * oneLevel, 1e-6));
    EXPECT_EQ(result.maximumX, 7);
    EXPECT_EQ(result.maximumY, 3);
    EXPECT_THAT(result.mean, DoubleNear(30 * oneLevel / 100, 1e-6));
}

TEST_F(Compare, countsAPixelOnceHoweverManyOfItsChannelsDiffer) {
    const Image<std::uint8_t> black{{4, 1}, 3};
    Image<std::uint8_t> other = black;
    other.at(2, 0, 0) = 30;
    other.at(2, 0, 1) = 60;
    const Comparison result = compare(save("a.png", black), save("b.png", other), {});
    EXPECT_EQ(result.channels, 3);
    EXPECT_EQ(result.pixelsOverLevel, 1U);
    EXPECT_THAT(result.maximum, DoubleNear(60 * oneLevel, 1e-6));
    EXPECT_THAT(result.mean, DoubleNear(90 * oneLevel / 12, 1e-6));
}

TEST_F(Compare, takesColoursAsTheyAreHoweverTransparent) {
    Image<std::uint8_t> clear{{1, 1}, 4};
    const fs::path a = save("a.png", clear);
    clear.at(0, 0, 0) = 255;
    EXPECT_EQ(compare(a, save("b.png", clear), {}).maximum, 1.0);
}

TEST_F(Compare, doesNotCountDifferencesUpToTheLevelWhateverTheirBrightness) {
    Image<std::uint8_t> ramp{{255, 1}, 1};
    Image<std::uint8_t> brighter{{255, 1}, 1};
    for (int x = 0; x < 255; ++x) {
        ramp.at(x, 0) = static_cast<std::uint8_t>(x);
        brighter.at(x, 0) = static_cast<std::uint8_t>(x + 1);
    }
    const fs::path a = save("a.png", ramp);
    const fs::path b = save("b.png", brighter);
    const Comparison within = compare(a, b, {.level = oneLevel});
    EXPECT_EQ(within.pixelsOverLevel, 0U);
    EXPECT_TRUE(within.same);
    EXPECT_EQ(compare(a, b, {.level = 0.99 * oneLevel}).pixelsOverLevel, 255U);
}

TEST_F(Compare, letsTheAllowedShareOfPixelsPass) {
    saveTwo();
    EXPECT_TRUE(compare(a_, b_, {.share = 0.02, .hardLimit = 1.0}).same);
    EXPECT_FALSE(compare(a_, b_, {.share = 0.019, .hardLimit = 1.0}).same);
    EXPECT_TRUE(compare(a_, b_, {.level = 10 * oneLevel, .share = 0.01, .hardLimit = 1.0}).same);
}

TEST_F(Compare, letsNoPixelPassTheHardLimit) {
    saveTwo();
    EXPECT_TRUE(compare(a_, b_, {.share = 0.5, .hardLimit = 20 * oneLevel}).same);
    EXPECT_FALSE(compare(a_, b_, {.share = 0.5, .hardLimit = 19 * oneLevel}).same);
    EXPECT_FALSE(compare(a_, b_, {.level = 10 * oneLevel, .share = 0.5}).same)
        << "a hard limit under the level is the level";
}

TEST_F(Compare, takesFloatValuesAsTheyAre) {
    Image<float> depth{{3, 1}, 1, 100.0F};
    const fs::path a = save("a.exr", depth);
    depth.at(1, 0) = 102.5F;
    const Comparison result = compare(a, save("b.exr", depth), {.level = 2.0});
    EXPECT_EQ(result.maximum, 2.5);
    EXPECT_EQ(result.maximumX, 1);
    EXPECT_EQ(result.pixelsOverLevel, 1U);
}

TEST_F(Compare, neverTakesANumberForNone) {
    Image<float> depth{{2, 1}, 1, 1.0F};
    const fs::path a = save("a.exr", depth);
    depth.at(1, 0) = std::numeric_limits<float>::quiet_NaN();
    const fs::path b = save("b.exr", depth);
    EXPECT_FALSE(compare(a, b, {.level = 100.0, .share = 1.0, .hardLimit = 1000.0}).same);
    EXPECT_FALSE(compare(b, a, {.level = 100.0, .share = 1.0, .hardLimit = 1000.0}).same);
    EXPECT_TRUE(compare(b, b, {}).same);
}

TEST_F(Compare, countsEveryPixelThatIsNoNumberInOneOfThePictures) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    constexpr float infinity = std::numeric_limits<float>::infinity();
    Image<float> depth{{8, 8}, 1, 1.0F};
    depth.at(0, 0) = nan;  // these are in both
    depth.at(1, 0) = infinity;
    const fs::path a = save("a.exr", depth);
    depth.at(3, 1) = nan;
    depth.at(5, 2) = infinity;
    depth.at(6, 2) = 1.5F;
    const fs::path b = save("b.exr", depth);
    for (const Comparison& result : {compare(a, b, {}), compare(b, a, {})}) {
        EXPECT_EQ(result.pixelsOverLevel, 3U);
        EXPECT_EQ(result.shareOverLevel, 3.0 / 64.0);
        EXPECT_EQ(result.maximum, infinity);
        EXPECT_EQ(result.maximumX, 3);
        EXPECT_EQ(result.maximumY, 1);
        EXPECT_EQ(result.mean, 0.5 / 64.0);
        EXPECT_FALSE(result.same);
    }
}

TEST_F(Compare, takesInfinitiesOfOtherSignsForDifferent) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    const fs::path a = save("a.exr", Image<float>{{2, 1}, 1, infinity});
    EXPECT_TRUE(compare(a, a, {}).same);
    EXPECT_EQ(compare(a, save("b.exr", Image<float>{{2, 1}, 1, -infinity}), {}).pixelsOverLevel, 2U);
}

TEST_F(Compare, seesAFileThatWasWrittenAnew) {
    const fs::path a = save("a.png", Image<std::uint8_t>{{2, 1}, 1});
    const fs::path b = save("b.png", Image<std::uint8_t>{{2, 1}, 1});
    EXPECT_TRUE(compare(a, b, {}).same);
    save("b.png", Image<std::uint8_t>{{2, 1}, 1, 9});
    EXPECT_FALSE(compare(a, b, {}).same);
}

TEST_F(Compare, readsOtherFormatsThanItWrites) {
    const fs::path a = save("a.png", Image<std::uint8_t>{{2, 1}, 3, 7});
    put(folder_ / "b.ppm", "P6 2 1 255\n\7\7\7\7\7\7");
    EXPECT_TRUE(compare(a, folder_ / "b.ppm", {}).same);
}

TEST_F(Compare, drawsDifferencesUpToWhite) {
    saveTwo();
    static_cast<void>(compare(a_, b_, {}, folder_ / "difference.png"));
    const std::vector<int> found = levels(folder_ / "difference.png");
    ASSERT_EQ(found.size(), 100U);
    EXPECT_EQ(found[3 * 10 + 7], 255);
    EXPECT_EQ(found[2 * 10 + 1], 128);
    EXPECT_EQ(std::count(found.begin(), found.end(), 0), 98);
}

TEST_F(Compare, drawsNoDifferenceAsBlack) {
    saveTwo();
    static_cast<void>(compare(a_, a_, {}, folder_ / "difference.tif"));
    EXPECT_THAT(levels(folder_ / "difference.tif"), AllOf(testing::SizeIs(100), Each(0)));
}

TEST_F(Compare, drawsWhatIsNoNumberAsWhite) {
    Image<float> depth{{3, 1}, 1, 1.0F};
    const fs::path a = save("a.exr", depth);
    depth = Image<float>{depth.size(), 1, {1.0F, std::numeric_limits<float>::quiet_NaN(), 3.0F}};
    static_cast<void>(compare(a, save("b.exr", depth), {}, folder_ / "difference.png"));
    EXPECT_THAT(levels(folder_ / "difference.png"), ElementsAre(0, 255, 255));
}

TEST_F(Compare, saysBothSizesWhereTheyDiffer) {
    const fs::path a = save("a.png", Image<std::uint8_t>{{2, 1}, 1});
    const fs::path b = save("b.png", Image<std::uint8_t>{{2, 3}, 1});
    expectError(Error::Kind::Input,
                AllOf(HasSubstr("expected 2 x 1 pixels of 1 channel, as"), HasSubstr("found 2 x 3 pixels")),
                [&] { static_cast<void>(compare(a, b, {}, folder_ / "difference.png")); });
    EXPECT_FALSE(fs::exists(folder_ / "difference.png"));
}

TEST_F(Compare, saysBothChannelCountsWhereTheyDiffer) {
    const fs::path a = save("a.png", Image<std::uint8_t>{{2, 1}, 1});
    const fs::path b = save("b.png", Image<std::uint8_t>{{2, 1}, 3});
    expectError(Error::Kind::Input, AllOf(HasSubstr("of 1 channel,"), HasSubstr("of 3 channels")),
                [&] { static_cast<void>(compare(a, b, {})); });
}

TEST_F(Compare, refusesAFileThatIsMissing) {
    const fs::path a = save("a.png", Image<std::uint8_t>{{2, 1}, 1});
    const fs::path none = folder_ / "none.png";
    expectError(Error::Kind::Input,
                testing::StrEq(none.string() + ": cannot be read as a picture: expected a file, found none; check its "
                                               "name"),
                [&] { static_cast<void>(compare(a, none, {})); });
}

TEST_F(Compare, refusesAFileThatIsNoPicture) {
    const fs::path a = save("a.png", Image<std::uint8_t>{{2, 1}, 1});
    put(folder_ / "text.png", "no picture");
    for (const fs::path& other : {folder_ / "text.png", folder_.path()}) {
        expectError(Error::Kind::Input, HasSubstr(other.string() + ": cannot be read as a picture: "),
                    [&] { static_cast<void>(compare(a, other, {})); });
    }
}

TEST_F(Compare, refusesAPictureThatIsCutShort) {
    const fs::path whole = save("a.png", Image<std::uint8_t>{{64, 64}, 1});
    const fs::path a = save("a.exr", Image<float>{{64, 64}, 1, 0.5F});
    for (const fs::path& file : {whole, a}) {
        const fs::path cut = folder_ / ("cut" + file.extension().string());
        const std::string bytes = contents(file);
        for (const std::size_t length : {std::size_t{0}, std::size_t{8}, bytes.size() / 2, bytes.size() - 9}) {
            put(cut, bytes.substr(0, length));
            testing::internal::CaptureStderr();
            expectError(Error::Kind::Input,
                        AllOf(HasSubstr(cut.string() + ": cannot be read as a picture: expected "),
                              HasSubstr(", found"), HasSubstr("; ")),
                        [&] { static_cast<void>(compare(file, cut, {})); });
            EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << cut << " of " << length << " bytes";
        }
    }
}

TEST_F(Compare, readsEveryKindOfPngAsOpenImageIoDoes) {
    for (const PngKind& kind :
         {PngKind{PNG_COLOR_TYPE_GRAY, 1}, PngKind{PNG_COLOR_TYPE_GRAY, 4}, PngKind{PNG_COLOR_TYPE_GRAY, 16},
          PngKind{PNG_COLOR_TYPE_GRAY, 2, PNG_INTERLACE_NONE, true}, PngKind{PNG_COLOR_TYPE_GRAY_ALPHA, 8},
          PngKind{PNG_COLOR_TYPE_RGB, 8, PNG_INTERLACE_ADAM7}, PngKind{PNG_COLOR_TYPE_RGB, 16},
          PngKind{PNG_COLOR_TYPE_RGB_ALPHA, 8}, PngKind{PNG_COLOR_TYPE_RGB_ALPHA, 16, PNG_INTERLACE_ADAM7},
          PngKind{PNG_COLOR_TYPE_PALETTE, 2}, PngKind{PNG_COLOR_TYPE_PALETTE, 2, PNG_INTERLACE_ADAM7, true}}) {
        const std::string png = noisyPng(kind);
        put(folder_ / "noise.png", png);
        const images::ReadPicture ours = images::readPng(bytesOf(png));
        const images::ReadPicture theirs = images::imageFormats(Error::Kind::Input).read(folder_ / "noise.png");
        ASSERT_EQ(ours.failure + theirs.failure, "") << kind.colorType << ", " << kind.bits << " bits";
        EXPECT_TRUE(ours.integers && theirs.integers);
        EXPECT_EQ(ours.image.size(), theirs.image.size());
        ASSERT_EQ(ours.image.channels(), theirs.image.channels()) << kind.colorType << ", " << kind.bits << " bits";
        EXPECT_THAT(ours.image.pixels(), testing::Pointwise(testing::FloatNear(1e-6F), theirs.image.pixels()))
            << kind.colorType << ", " << kind.bits << " bits";
    }
}

TEST_F(Compare, refusesAPngWithAWrongByte) {
    const fs::path a = save("a.png", Image<std::uint8_t>{{64, 64}, 1});
    const std::string bytes = contents(a);
    for (std::size_t at = 8; at < bytes.size(); ++at) {  // every chunk has a checksum
        std::string changed = bytes;
        changed[at] = static_cast<char>(changed[at] ^ 0x10);
        put(folder_ / "changed.png", changed);
        expectError(Error::Kind::Input, HasSubstr("expected a whole PNG, found "),
                    [&] { static_cast<void>(compare(a, folder_ / "changed.png", {})); });
    }
}

TEST_F(Compare, refusesAPngThatCannotHoldItsPixels) {
    const fs::path a = save("a.png", Image<std::uint8_t>{{2, 1}, 1});
    std::string bytes = contents(a);
    const std::string huge{"\x00\x0f\x00\x00\x00\x0f\x00\x00", 8};  // width and height, behind "IHDR"
    bytes.replace(16, huge.size(), huge);
    const auto checksum = crc32(0, reinterpret_cast<const Bytef*>(bytes.data()) + 12, 17);
    for (int i = 0; i < 4; ++i) bytes[static_cast<std::size_t>(29 + i)] = static_cast<char>(checksum >> (24 - 8 * i));
    put(folder_ / "huge.png", bytes);
    expectError(Error::Kind::Input, HasSubstr("found fewer bytes than its pixels need"),
                [&] { static_cast<void>(compare(a, folder_ / "huge.png", {})); });
}

TEST_F(Compare, refusesADifferencePictureThatCannotBeWritten) {
    saveTwo();
    expectError(Error::Kind::Output, HasSubstr("none/difference.png: cannot be written: "),
                [&] { static_cast<void>(compare(a_, b_, {}, folder_ / "none/difference.png")); });
    expectError(Error::Kind::Usage, HasSubstr("found .bmp"),
                [&] { static_cast<void>(compare(a_, b_, {}, folder_ / "difference.bmp")); });
}
