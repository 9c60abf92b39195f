#include <inkedge/write.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <cstring>

#include <OpenImageIO/imageio.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <png.h>
#include <nlohmann/json.hpp>

#include "base/expect_error.h"
#include "base/temporary_folder.h"
#include "images/image_formats.h"
#include "io/decoded_files.h"
#include "io/zip.h"

namespace {

namespace fs = std::filesystem;
using namespace inkedge::decoded_files;
using namespace inkedge;
using testing::AllOf;
using testing::ElementsAre;
using testing::ElementsAreArray;
using testing::FloatEq;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<int> levels(const DecodedFile& file) {
    std::vector<int> result;
    for (const float value : file.image.pixels()) result.push_back(static_cast<int>(std::lround(value * 65535.0F)));
    return result;
}

TEST(OutputFiles, putAMapsNameBeforeTheExtension) {
    EXPECT_THAT(outputFiles("out/gear.v2.png", std::array{Map::Depth, Map::NormalEdges}),
                ElementsAre("out/gear.v2.png", "out/gear.v2.depth.png", "out/gear.v2.normal-edges.png"));
    EXPECT_THAT(outputFiles("gear.TIF", std::array{Map::Edges}), ElementsAre("gear.TIF", "gear.edges.TIF"));
}

TEST(OutputFiles, fillThePlaceholder) {
    EXPECT_THAT(outputFiles("{map}/gear-{map}.png", std::array{Map::Normal}),
                ElementsAre("outline/gear-outline.png", "normal/gear-normal.png"));
}

TEST(OutputFiles, areOneForEveryMapInExr) {
    EXPECT_THAT(outputFiles("gear.exr", allMaps), ElementsAre("gear.exr"));
    EXPECT_THAT(outputFiles("gear-{map}.exr", allMaps), ElementsAre("gear-outline.exr"));
}

TEST(OutputFiles, nameAMapOnceThatIsAskedForTwice) {
    EXPECT_THAT(outputFiles("gear.png", std::array{Map::Depth, Map::Depth}), ElementsAre("gear.png", "gear.depth.png"));
}

TEST(OutputFiles, refuseAnUnknownExtensionAndListTheKnown) {
    expectError(
        Error::Kind::Usage,
        testing::StrEq("a.jpg: expected a name that ends in .png, .tif, .tiff, .exr or .npz, or for lines in .svg, "
                       ".pdf, .dxf or .json, found .jpg"),
        [] { static_cast<void>(outputFiles("a.jpg", {})); });
    expectError(Error::Kind::Usage, HasSubstr("found no extension"), [] { static_cast<void>(outputFiles("a", {})); });
    expectError(Error::Kind::Usage,
                testing::StrEq("a.svg: expected a name that ends in .png, .tif, .tiff, .exr or .npz, found .svg"),
                [] { static_cast<void>(outputFiles("a.svg", {})); });
}

TEST(WriteMaps, writesDepthFromNearBlackToFarWhite) {
    const TemporaryFolder folder;
    writeMaps(smallMaps(), std::array{Map::Depth}, folder / "a.png");
    const DecodedFile depth = decodeFile(folder / "a.depth.png");
    EXPECT_EQ(depth.spec.format, OIIO::TypeUInt16);
    EXPECT_EQ(depth.spec.nchannels, 1);
    EXPECT_THAT(levels(depth), ElementsAre(16384, 65535));  // 65535 / 4, rounded
}

TEST(WriteMaps, writesDepthsThatAreNoNumberAsBlack) {
    const TemporaryFolder folder;
    Maps maps = smallMaps();
    maps.depth = Image<float>{maps.depth.size(), 1, {NAN, 100.0F}};
    writeMaps(maps, std::array{Map::Depth}, folder / "a.png");
    EXPECT_THAT(levels(decodeFile(folder / "a.depth.png")), ElementsAre(0, 65535));
}

TEST(WriteMaps, writesNormalsAsHalfOfNPlusOne) {
    const TemporaryFolder folder;
    writeMaps(smallMaps(), std::array{Map::Normal}, folder / "a.png");
    const DecodedPng normal = decodePng(contents(folder / "a.normal.png"));
    EXPECT_EQ(normal.colorType, PNG_COLOR_TYPE_RGB);
    EXPECT_THAT(normal.image.pixels(), ElementsAre(204, 25, 128, 128, 128, 0));
}

TEST(WriteMaps, writesEdgesBlackOnWhite) {
    const TemporaryFolder folder;
    const std::vector<fs::path> files =
        writeMaps(smallMaps(), std::array{Map::DepthEdges, Map::NormalEdges, Map::Edges}, folder / "{map}.png");
    EXPECT_THAT(files, ElementsAre(folder / "outline.png", folder / "depth-edges.png", folder / "normal-edges.png",
                                   folder / "edges.png"));
    EXPECT_THAT(decodePng(contents(files[0])).image.pixels(), ElementsAre(0, 255));
    EXPECT_THAT(decodePng(contents(files[1])).image.pixels(), ElementsAre(0, 255));
    EXPECT_THAT(decodePng(contents(files[2])).image.pixels(), ElementsAre(255, 0));
    EXPECT_THAT(decodePng(contents(files[3])).image.pixels(), ElementsAre(0, 0));
}

TEST(WriteMaps, writesTheSameValuesToTiff) {
    const TemporaryFolder folder;
    Maps maps = smallMaps();
    maps.picture = noise({67, 131}, 4);
    writeMaps(maps, {}, folder / "a.tif");
    const DecodedFile file = decodeFile(folder / "a.tif");
    const auto written = OIIO::ImageInput::open((folder / "a.tif").string());
    EXPECT_STREQ(written->format_name(), "tiff");
    EXPECT_NE(written->spec().get_string_attribute("ResolutionUnit"), "in") << "no resolution is asked for";
    Maps fine = maps;
    fine.dpi = 300.5;
    writeMaps(fine, {}, folder / "fine.tif");
    const auto told = OIIO::ImageInput::open((folder / "fine.tif").string());
    EXPECT_EQ(told->spec().get_float_attribute("XResolution"), 300.5F);
    EXPECT_EQ(told->spec().get_float_attribute("YResolution"), 300.5F);
    EXPECT_EQ(told->spec().get_string_attribute("ResolutionUnit"), "in");
    EXPECT_EQ(file.spec.format, OIIO::TypeUInt8);
    EXPECT_EQ(file.spec.alpha_channel, 3);
    EXPECT_EQ(file.spec.get_int_attribute("oiio:UnassociatedAlpha"), 1) << "alpha is not multiplied in";
    ASSERT_EQ(file.image.pixels().size(), maps.picture.pixels().size());
    for (std::size_t i = 0; i < maps.picture.pixels().size(); ++i) {
        ASSERT_EQ(std::lround(file.image.pixels()[i] * 255.0F), maps.picture.pixels()[i]) << "value " << i;
    }
}

TEST(WriteMaps, namesTheLayersOfAnExr) {
    const TemporaryFolder folder;
    writeMaps(smallMaps(), allMaps, folder / "a.exr");
    const DecodedFile file = decodeFile(folder / "a.exr");
    EXPECT_THAT(file.spec.channelnames,
                testing::UnorderedElementsAre("R", "G", "B", "depth.Z", "normal.X", "normal.Y", "normal.Z",
                                              "depth-edges.Y", "normal-edges.Y", "edges.Y"));
    EXPECT_EQ(file.spec.channelnames.front(), "R");
    for (int c = 0; c < file.spec.nchannels; ++c)
        EXPECT_EQ(file.spec.channelformat(c), OIIO::TypeFloat) << file.spec.channel_name(c);
}

TEST(WriteMaps, keepsFloatMapsExactlyInAnExr) {
    const TemporaryFolder folder;
    writeMaps(smallMaps(), allMaps, folder / "a.exr");
    const DecodedFile file = decodeFile(folder / "a.exr");
    for (const char* const grey : {"R", "G", "B"}) EXPECT_THAT(file.channel(grey), ElementsAre(0.0F, 1.0F)) << grey;
    EXPECT_THAT(file.channel("depth.Z"), ElementsAre(2.5F, 4.0F));
    EXPECT_THAT(file.channel("normal.X"), ElementsAre(0.6F, 0.0F));
    EXPECT_THAT(file.channel("normal.Y"), ElementsAre(-0.8F, 0.0F));
    EXPECT_THAT(file.channel("normal.Z"), ElementsAre(0.0F, -1.0F));
    EXPECT_THAT(file.channel("depth-edges.Y"), ElementsAre(1.0F, 0.0F));
    EXPECT_THAT(file.channel("normal-edges.Y"), ElementsAre(0.0F, 1.0F));
    EXPECT_THAT(file.channel("edges.Y"), ElementsAre(1.0F, 1.0F));
}

TEST(WriteMaps, keepsEveryBitOfTypesInAnExr) {
    const TemporaryFolder folder;
    Maps maps = smallMaps();
    maps.types = Image<std::uint16_t>{maps.picture.size(), 1, {0x8001, 0xFFFF}};
    writeMaps(maps, std::array{Map::Types}, folder / "a.exr");
    EXPECT_THAT(decodeFile(folder / "a.exr").channel("types.V"), ElementsAre(32769.0F, 65535.0F));
}

TEST(WriteMaps, namesEveryChannelOfAnExrByOneLetterAtItsEnd) {
    const TemporaryFolder folder;
    Maps maps = smallMaps();
    maps.types = Image<std::uint16_t>{maps.picture.size(), 1};
    maps.ids = Image<std::uint32_t>{maps.picture.size(), 4};
    std::vector<Map> all{allMaps.begin(), allMaps.end()};
    all.insert(all.end(), {Map::Types, Map::Ids});
    writeMaps(maps, all, folder / "a.exr");
    for (const std::string& channel : decodeFile(folder / "a.exr").spec.channelnames) {
        EXPECT_THAT(channel, testing::MatchesRegex("[RGB]|[a-z-]+\\.[XYZV]"));
    }
}

TEST(WriteMaps, writesTheShadeAsColoursAndInAnExrAsLight) {
    const TemporaryFolder folder;
    Maps maps = smallMaps();
    maps.shade = Image<std::uint8_t>{maps.picture.size(), 4, {255, 0, 188, 255, 255, 255, 255, 51}};
    for (const char* const extension : {"png", "tif"}) {
        const fs::path file = folder / (std::string{"a."} + extension);
        writeMaps(maps, std::array{Map::Shade}, file);
        const DecodedFile shade = decodeFile(folder / (std::string{"a.shade."} + extension));
        EXPECT_EQ(shade.spec.format, OIIO::TypeUInt8) << extension;
        EXPECT_EQ(shade.spec.alpha_channel, 3) << extension;
    }
    writeMaps(maps, std::array{Map::Shade}, folder / "a.exr");
    const DecodedFile exr = decodeFile(folder / "a.exr");
    EXPECT_THAT(exr.channel("shade.R"), ElementsAre(FloatEq(1.0F), testing::FloatNear(0.2F, 1e-3F)));
    EXPECT_THAT(exr.channel("shade.B"), ElementsAre(testing::FloatNear(0.503F, 1e-3F), testing::FloatNear(0.2F, 1e-3F)))
        << "188 of sRGB is half of the light";
    EXPECT_THAT(exr.channel("shade.A"), ElementsAre(FloatEq(1.0F), testing::FloatNear(0.2F, 1e-3F)));
}

TEST(WriteMaps, keepsIdsExactlyInAnExrAndRefusesThoseThatFloatsDoNotHold) {
    const TemporaryFolder folder;
    Maps maps = smallMaps();
    maps.ids = Image<std::uint32_t>{maps.picture.size(), 4, {16777216, 16777215, 3, 1, 7, 0, 16777213, 2}};
    writeMaps(maps, std::array{Map::Ids}, folder / "a.exr");
    const DecodedFile file = decodeFile(folder / "a.exr");
    EXPECT_THAT(file.channel("patch.V"), ElementsAre(16777216.0F, 7.0F));
    EXPECT_THAT(file.channel("across.V"), ElementsAre(16777215.0F, 0.0F));
    EXPECT_THAT(file.channel("object.V"), ElementsAre(3.0F, 16777213.0F));
    EXPECT_THAT(file.channel("material.V"), ElementsAre(1.0F, 2.0F));

    maps.ids.at(1, 0, 2) = 16777217;  // the first that is none as a float
    expectError(Error::Kind::Output,
                HasSubstr("b.exr: map ids: expected numbers up to 16777216, which the floats of an EXR hold exactly, "
                          "found object 16777217; "),
                [&] { writeMaps(maps, std::array{Map::Ids}, folder / "b.exr"); });
    writeMaps(maps, {}, folder / "c.exr");  // has no ids
    EXPECT_THAT(folder.names(), ElementsAre("a.exr", "c.exr"));
}

TEST(WriteMaps, writesTypesAndIdsAsGreyNumbers) {
    const TemporaryFolder folder;
    Maps maps = smallMaps();
    maps.types = Image<std::uint16_t>{maps.picture.size(), 1, {0, 2 | 32}};  // an occlusion between two objects
    maps.ids = Image<std::uint32_t>{maps.picture.size(), 4, {65535, 2, 3, 0, 5, 6, 7, 8}};
    const auto files = writeMaps(maps, std::array{Map::Types, Map::Ids}, folder / "a.png");
    EXPECT_THAT(files,
                ElementsAre(folder / "a.png", folder / "a.types.png", folder / "a.ids-patch.png",
                            folder / "a.ids-across.png", folder / "a.ids-object.png", folder / "a.ids-material.png"));
    const std::array<std::vector<int>, 5> expected{{{0, 34}, {65535, 5}, {2, 6}, {3, 7}, {0, 8}}};
    for (std::size_t i = 0; i < expected.size(); ++i) {
        const DecodedFile file = decodeFile(files[i + 1]);
        EXPECT_EQ(file.spec.format, OIIO::TypeUInt16) << files[i + 1];
        EXPECT_EQ(file.spec.nchannels, 1) << files[i + 1];
        EXPECT_EQ(levels(file), expected[i]) << files[i + 1];
    }
    maps.ids.at(0, 0, 0) = 65536;
    expectError(Error::Kind::Output,
                HasSubstr("b.ids-patch.png: map ids: expected numbers up to 65535, which the 16 bits of a PNG hold, "
                          "found patch 65536; write an .npz"),
                [&] { writeMaps(maps, std::array{Map::Ids}, folder / "b.png"); });
    EXPECT_FALSE(fs::exists(folder / "b.png"));
}

TEST(WriteMaps, writesMapsToTiffAsFloats) {
    const TemporaryFolder folder;
    Maps maps = smallMaps();
    maps.ids = Image<std::uint32_t>{maps.picture.size(), 4, {16777216, 2, 3, 0, 5, 6, 7, 8}};
    const auto files = writeMaps(maps, std::array{Map::Depth, Map::Normal, Map::Edges, Map::Ids}, folder / "a.tif");
    ASSERT_EQ(files.size(), 8U);
    for (std::size_t i = 1; i < files.size(); ++i) EXPECT_EQ(decodeFile(files[i]).spec.format, OIIO::TypeFloat);
    EXPECT_EQ(decodeFile(files[1]).image.pixels(), maps.depth.pixels());
    EXPECT_EQ(decodeFile(files[2]).image.pixels(), maps.normal.pixels());
    EXPECT_THAT(decodeFile(files[3]).image.pixels(), ElementsAre(1.0F, 1.0F));
    EXPECT_THAT(decodeFile(files[4]).image.pixels(), ElementsAre(16777216.0F, 5.0F));
}

TEST(WriteMaps, putsNamesIntoTheHeaderOfAnExrWithIds) {
    const TemporaryFolder folder;
    Maps maps = smallMaps();
    maps.ids = Image<std::uint32_t>{maps.picture.size(), 4};
    maps.names = namesOf(triangle());
    writeMaps(maps, std::array{Map::Ids}, folder / "a.exr");
    const auto names =
        nlohmann::json::parse(std::string{decodeFile(folder / "a.exr").spec.get_string_attribute("inkedge:names")});
    EXPECT_EQ(names.at("instances").at(0).at("node"), "triangle");
    EXPECT_EQ(names.at("instances").at(0).at("id"), 1);
    writeMaps(maps, {}, folder / "b.exr");
    EXPECT_EQ(decodeFile(folder / "b.exr").spec.get_string_attribute("inkedge:names"), "");
}

TEST(ZipWriter, makesTheSameEntriesWithAndWithoutZip64) {
    const TemporaryFolder folder;
    const std::vector<std::uint8_t> repeated(100000, 7);
    const std::vector<std::uint8_t> random = noise({100, 10}, 1).pixels();
    for (const std::uint64_t maxPlain : {std::uint64_t{5000}, std::uint64_t{1} << 31U}) {
        io::ZipWriter zip;
        zip.add("repeated", repeated);
        zip.add("random", random);
        zip.add("none", {});
        const std::vector<std::uint8_t> file = std::move(zip).take(maxPlain);
        EXPECT_LT(file.size(), 2000U);
        writeFile(folder / "a.zip", file);
        const std::string script = fmt::format(
            "import sys, zipfile; z = zipfile.ZipFile('{}'); assert z.testzip() is None; "
            "assert z.read('repeated') == bytes([7]) * 100000; assert len(z.read('random')) == 1000; "
            "assert z.read('none') == b''; assert (z.infolist()[0].extract_version == 45) == {}",
            (folder / "a.zip").string(), maxPlain == 5000 ? "True" : "False");
        EXPECT_EQ(std::system(("/usr/bin/python3 -c \"" + script + "\"").c_str()), 0);
    }
}

TEST(WriteMaps, keepsRowsOfATallExrInOrder) {
    const TemporaryFolder folder;
    Maps maps = smallMaps();
    maps.picture = Image<std::uint8_t>{{3, 201}, 1, 255};
    maps.depth = Image<float>{{3, 201}, 1};
    for (std::size_t i = 0; i < maps.depth.pixels().size(); ++i) maps.depth.mutablePixels()[i] = static_cast<float>(i);
    writeMaps(maps, std::array{Map::Depth}, folder / "a.exr");
    EXPECT_THAT(decodeFile(folder / "a.exr").channel("depth.Z"), ElementsAreArray(maps.depth.pixels()));
}

TEST(WriteMaps, keepsWhatDoesNotCompressInAnExr) {
    const TemporaryFolder folder;
    Maps maps = smallMaps();
    maps.picture = Image<std::uint8_t>{{61, 35}, 1, 255};
    const Image<std::uint8_t> bits = noise({61, 35}, 4);
    maps.normal = Image<float>{{61, 35}, 3};
    for (std::size_t i = 0; i < maps.normal.pixels().size(); ++i) {
        std::uint32_t value = 0;  // of numbers from 1 to 2, so that none is NaN
        std::memcpy(&value, &bits.pixels()[4 * (i % (61 * 35))], sizeof value);
        maps.normal.mutablePixels()[i] = std::bit_cast<float>(0x3F800000U | (value & 0x7FFFFFU));
    }
    writeMaps(maps, std::array{Map::Normal}, folder / "a.exr");
    const DecodedFile file = decodeFile(folder / "a.exr");
    for (int c = 0; c < 3; ++c) {
        const std::vector<float> found =
            file.channel(std::array{"normal.X", "normal.Y", "normal.Z"}[static_cast<std::size_t>(c)]);
        ASSERT_EQ(found.size(), 61U * 35U);
        for (std::size_t i = 0; i < found.size(); ++i)
            ASSERT_EQ(found[i], maps.normal.pixels()[3 * i + static_cast<std::size_t>(c)]) << "pixel " << i;
    }
}

TEST(WriteMaps, roundsAPictureInAnExrToWhatSixteenBitsHold) {
    const TemporaryFolder folder;
    Maps maps = smallMaps();
    maps.picture = Image<std::uint8_t>{{256, 2}, 4, 255};
    for (int x = 0; x < 256; ++x) maps.picture(x, 0, 0) = maps.picture(x, 0, 3) = static_cast<std::uint8_t>(x);
    writeMaps(maps, {}, folder / "a.exr");
    const DecodedFile file = decodeFile(folder / "a.exr");
    for (const char* const name : {"R", "A"}) {
        for (const float value : file.channel(name)) {
            const auto bits = std::bit_cast<std::uint32_t>(value);
            // Normal numbers have 10 bits after the first, those below 2^-14 are multiples of 2^-24.
            EXPECT_TRUE(value < 0x1p-14F ? std::fmod(value, 0x1p-24F) == 0.0F : (bits & 0x1FFFU) == 0) << value;
        }
    }
    EXPECT_NEAR(file.channel("R")[1], 1.0 / 255.0 / 12.92 / 255.0, 0x1p-25);
}

TEST(TakeImage, leavesMapsWithoutTheMap) {
    Maps maps = smallMaps();
    const Image<float> depth = maps.depth;
    EXPECT_EQ(std::get<const Image<float>*>(imageOf(maps, Map::Depth)), &maps.depth);
    EXPECT_EQ(std::get<Image<float>>(takeImage(maps, Map::Depth)), depth);
    EXPECT_TRUE(maps.depth.empty());
    for (int i = 0; i < mapCount; ++i) {
        const auto size = [](const auto* image) { return image->size(); };
        const bool empty = std::visit(size, imageOf(maps, static_cast<Map>(i))) == Size{};
        EXPECT_EQ(std::visit([](const auto& image) { return image.empty(); }, takeImage(maps, static_cast<Map>(i))),
                  empty);
    }
}

TEST(WriteMaps, putsOnlyTheMapsAskedForIntoAnExr) {
    const TemporaryFolder folder;
    writeMaps(smallMaps(), std::array{Map::Edges, Map::Edges}, folder / "a.exr");
    EXPECT_THAT(decodeFile(folder / "a.exr").spec.channelnames, ElementsAre("R", "G", "B", "edges.Y"));
}

TEST(WriteMaps, putsTheCameraIntoAnExrsHeaderRowByRow) {
    const TemporaryFolder folder;
    const Maps maps = smallMaps();
    writeMaps(maps, {}, folder / "a.exr");
    const DecodedFile file = decodeFile(folder / "a.exr");
    EXPECT_EQ(file.spec.get_float_attribute("inkedge:near"), 2.0F);
    EXPECT_EQ(file.spec.get_float_attribute("inkedge:far"), 4.0F);
    EXPECT_THAT(file.matrix("inkedge:view"), ElementsAre(1, 0, 0, 1, 0, 1, 0, 2, 0, 0, 1, -3, 0, 0, 0, 1));
    const std::vector<float> projection = file.matrix("inkedge:projection");
    ASSERT_EQ(projection.size(), 16U);
    const glm::dmat4 expected = maps.camera.projection({2, 1});
    for (std::size_t i = 0; i < 16; ++i) {
        const auto at = static_cast<int>(i);
        EXPECT_THAT(projection[i], FloatEq(static_cast<float>(expected[at % 4][at / 4]))) << "value " << i;
    }
    EXPECT_EQ(projection[14], -1.0F) << "a perspective's last row is 0 0 -1 0";
}

TEST(WriteMaps, writesLinearLightAndPremultipliedAlphaIntoAnExr) {
    const TemporaryFolder folder;
    Maps maps = smallMaps();
    maps.picture = Image<std::uint8_t>{{2, 1}, 4, {255, 188, 0, 255, 255, 0, 0, 51}};
    writeMaps(maps, {}, folder / "a.exr");
    const DecodedFile file = decodeFile(folder / "a.exr");
    EXPECT_THAT(file.spec.channelnames, ElementsAre("R", "G", "B", "A"));
    EXPECT_THAT(file.channel("R"), ElementsAre(1.0F, testing::FloatNear(0.2F, 1e-3F)));
    EXPECT_THAT(file.channel("G"), ElementsAre(testing::FloatNear(0.5029F, 1e-3F), 0.0F));
    EXPECT_THAT(file.channel("A"), ElementsAre(1.0F, testing::FloatNear(0.2F, 1e-3F)));
}

TEST(WriteMaps, refusesAMapThatWasNotRendered) {
    const TemporaryFolder folder;
    Maps maps = smallMaps();
    maps.normal = {};
    for (const char* const output : {"a.png", "a.exr"}) {
        expectError(Error::Kind::Usage, HasSubstr("map normal: expected 2 x 1 pixels, found 0 x 0"), [&] {
            writeMaps(maps, std::array{Map::Depth, Map::Normal}, folder / output);
        });
    }
    EXPECT_THAT(folder.names(), IsEmpty());
}

TEST(WriteMaps, leavesNoFileWhenTheSecondCannotBeWritten) {
    const TemporaryFolder folder;
    fs::create_directory(folder / "a.depth.png");
    expectError(Error::Kind::Output, HasSubstr("a.depth.png: cannot be written"),
                [&] { writeMaps(smallMaps(), std::array{Map::Depth}, folder / "a.png"); });
    EXPECT_THAT(folder.names(), ElementsAre("a.depth.png"));
}

TEST(WriteMaps, leavesNoFileWhenTheDiskIsFull) {
    const TemporaryFolder folder;
    Maps maps = smallMaps();
    maps.picture = noise({64, 64}, 1);
    for (const char* const output : {"a.png", "a.tif", "a.exr"}) {
        const FileSizeLimit limit{1000};
        expectError(Error::Kind::Output, AllOf(HasSubstr(output), HasSubstr("cannot be written")),
                    [&] { writeMaps(maps, {}, folder / output); });
        EXPECT_THAT(folder.names(), IsEmpty()) << output;
    }
}

TEST(WriteMaps, leavesNoFileWhenTheFolderIsMissing) {
    const TemporaryFolder folder;
    for (const char* const output : {"none/a.png", "none/a.tif", "none/a.exr"}) {
        expectError(Error::Kind::Output, HasSubstr("found none; create it first"),
                    [&] { writeMaps(smallMaps(), {}, folder / output); });
    }
    EXPECT_THAT(folder.names(), IsEmpty());
}

TEST(ImageModule, saysWhereItWasLookedFor) {
    const TemporaryFolder folder;
    const std::array<fs::path, 2> folders{folder / "one", folder / "two"};
    expectError(Error::Kind::Output,
                HasSubstr(fmt::format("expected inkedge_image_formats.so in one of {}, {}, found none; reinstall",
                                      folders[0].string(), folders[1].string())),
                [&] { static_cast<void>(modules::openModule(images::imageModule, folders, Error::Kind::Output)); });
}

TEST(ImageModule, refusesAFileThatIsNone) {
    const TemporaryFolder folder;
    put(folder / images::imageModule.file, "no library");
    const std::array<fs::path, 1> folders{folder.path()};
    expectError(Error::Kind::Input, AllOf(HasSubstr("that can be opened, found: "), HasSubstr("reinstall")),
                [&] { static_cast<void>(modules::openModule(images::imageModule, folders, Error::Kind::Input)); });
}

}  // namespace
