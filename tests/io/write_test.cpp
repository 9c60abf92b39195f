#include <inkedge/write.h>

#include <OpenImageIO/imageio.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <png.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <array>
#include <cmath>
#include <csignal>
#include <cstring>
#include <glm/ext/matrix_transform.hpp>
#include <nlohmann/json.hpp>

#include <inkedge/setting_table.h>

#include "base/expect_error.h"
#include "base/temporary_folder.h"
#include "images/image_formats.h"
#include "images/read_png.h"

using namespace inkedge;
using testing::AllOf;
using testing::ElementsAre;
using testing::ElementsAreArray;
using testing::FloatEq;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;
namespace fs = std::filesystem;

namespace {

constexpr std::array allMaps{Map::Depth, Map::Normal, Map::DepthEdges, Map::NormalEdges, Map::Edges};

struct DecodedPng {
    int bitDepth = 0;
    int colorType = 0;
    Image<std::uint8_t> image;
};

DecodedPng decodePng(const std::string& bytes) {
    DecodedPng result;
    if (bytes.size() < 26) throw std::runtime_error{"no PNG"};
    result.bitDepth = bytes[24];  // IHDR begins at byte 16: width, height, bit depth, colour type
    result.colorType = bytes[25];
    png_image header{};
    header.version = PNG_IMAGE_VERSION;
    if (png_image_begin_read_from_memory(&header, bytes.data(), bytes.size()) == 0) {
        throw std::runtime_error{header.message};
    }
    header.format &= ~static_cast<png_uint_32>(PNG_FORMAT_FLAG_COLORMAP);
    result.image = Image<std::uint8_t>{{static_cast<int>(header.width), static_cast<int>(header.height)},
                                       static_cast<int>(PNG_IMAGE_SAMPLE_CHANNELS(header.format))};
    if (png_image_finish_read(&header, nullptr, result.image.pixels.data(), 0, nullptr) == 0) {
        throw std::runtime_error{header.message};
    }
    return result;
}

DecodedPng decodePng(const std::vector<std::uint8_t>& bytes) {
    return decodePng(std::string{bytes.begin(), bytes.end()});
}

Image<std::uint8_t> noise(Size size, int channels) {
    Image<std::uint8_t> image{size, channels};
    std::uint32_t state = 1;
    for (std::uint8_t& value : image.pixels)
        value = static_cast<std::uint8_t>((state = state * 1664525U + 1013904223U) >> 24);
    return image;
}

/// Every map of a 2 x 1 picture, each with values of its own.
Maps smallMaps() {
    const Size size{2, 1};
    Maps maps;
    maps.picture = Image<std::uint8_t>{size, 1};
    maps.picture.pixels = {0, 255};
    maps.depth = Image<float>{size, 1};
    maps.depth.pixels = {2.5F, 4.0F};
    maps.normal = Image<float>{size, 3};
    maps.normal.pixels = {0.6F, -0.8F, 0.0F, 0.0F, 0.0F, -1.0F};
    maps.depthEdges = Image<std::uint8_t>{size, 1};
    maps.depthEdges.pixels = {255, 0};
    maps.normalEdges = Image<std::uint8_t>{size, 1};
    maps.normalEdges.pixels = {0, 255};
    maps.edges = Image<std::uint8_t>{size, 1, 255};
    maps.camera.near = 2.0;
    maps.camera.far = 4.0;
    maps.camera.view = glm::translate(glm::dmat4{1.0}, glm::dvec3{1.0, 2.0, -3.0});
    return maps;
}

Scene triangle() {
    Scene::Data data;
    Mesh& mesh = data.meshes.emplace_back();
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.indices = {0, 1, 2};
    data.instances.push_back({"triangle", 0, glm::dmat4{1.0}});
    data.warnings = {"a warning", "a name that is no UTF-8: \xff"};
    return Scene{std::move(data)};
}

/// While it lives no file may grow over `bytes`: what a full disk does, for root too.
class FileSizeLimit {
public:
    explicit FileSizeLimit(rlim_t bytes) : oldHandler_{std::signal(SIGXFSZ, SIG_IGN)} {
        ::getrlimit(RLIMIT_FSIZE, &old_);
        const rlimit limit{bytes, old_.rlim_max};
        if (::setrlimit(RLIMIT_FSIZE, &limit) != 0) throw std::runtime_error{"setrlimit"};
    }
    FileSizeLimit(const FileSizeLimit&) = delete;
    FileSizeLimit& operator=(const FileSizeLimit&) = delete;
    ~FileSizeLimit() {
        ::setrlimit(RLIMIT_FSIZE, &old_);
        std::signal(SIGXFSZ, oldHandler_);
    }

private:
    rlimit old_{};
    void (*oldHandler_)(int);
};

struct DecodedFile {
    OIIO::ImageSpec spec;
    Image<float> image;

    /// One channel's values by name.
    [[nodiscard]] std::vector<float> channel(const std::string& name) const {
        std::vector<float> values;
        const int index = spec.channelindex(name);
        if (index < 0) return values;
        for (int y = 0; y < spec.height; ++y) {
            for (int x = 0; x < spec.width; ++x) values.push_back(image.at(x, y, index));
        }
        return values;
    }
    [[nodiscard]] std::vector<float> matrix(const std::string& name) const {
        const OIIO::ParamValue* const entry = spec.find_attribute(name, OIIO::TypeMatrix44);
        if (entry == nullptr) return {};
        const auto* const values = static_cast<const float*>(entry->data());
        return {values, values + 16};
    }
};

DecodedFile decodeFile(const fs::path& file) {
    OIIO::ImageSpec cameraSettings;
    cameraSettings.attribute("oiio:UnassociatedAlpha", 1);
    const auto input = OIIO::ImageInput::open(file.string(), &cameraSettings);
    if (!input) throw std::runtime_error{OIIO::geterror()};
    DecodedFile result;
    result.spec = input->spec();
    result.image = Image<float>{{result.spec.width, result.spec.height}, result.spec.nchannels};
    if (!input->read_image(0, 0, 0, result.spec.nchannels, OIIO::TypeFloat, result.image.pixels.data())) {
        throw std::runtime_error{input->geterror()};
    }
    return result;
}

}  // namespace

TEST(EncodePng, keepsGreyInOneChannelOfEightBits) {
    const Image<std::uint8_t> picture = noise({37, 5}, 1);
    const DecodedPng decoded = decodePng(encodePng(picture));
    EXPECT_EQ(decoded.bitDepth, 8);
    EXPECT_EQ(decoded.colorType, PNG_COLOR_TYPE_GRAY);
    EXPECT_EQ(decoded.image.size, picture.size);
    EXPECT_EQ(decoded.image.pixels, picture.pixels);
}

TEST(EncodePng, keepsEveryValueOfColourAndAlpha) {
    for (const int channels : {3, 4}) {
        const Image<std::uint8_t> picture = noise({5, 37}, channels);
        const DecodedPng decoded = decodePng(encodePng(picture));
        EXPECT_EQ(decoded.colorType, channels == 3 ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_RGB_ALPHA);
        EXPECT_EQ(decoded.image.size, picture.size);
        EXPECT_EQ(decoded.image.pixels, picture.pixels);
    }
}

TEST(EncodePng, keepsEveryValueOfUpTo256ColoursInAPalette) {
    for (const int channels : {3, 4}) {
        for (const std::size_t colors : {1U, 255U, 256U, 257U}) {
            const Image<std::uint8_t> some = noise({static_cast<int>(colors), 1}, channels);
            Image<std::uint8_t> picture{{93, 71}, channels};
            for (std::size_t i = 0; i < picture.pixels.size(); ++i)
                picture.pixels[i] = some.pixels[i % some.pixels.size()];
            const DecodedPng decoded = decodePng(encodePng(picture));
            EXPECT_EQ(decoded.colorType == PNG_COLOR_TYPE_PALETTE, colors <= 256) << colors;
            EXPECT_EQ(decoded.image.channels, channels);
            EXPECT_EQ(decoded.image.pixels, picture.pixels) << channels << " channels, " << colors << " colours";
        }
    }
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
    const io::ReadPicture picture = io::readPng(bytes);
    std::vector<std::uint16_t> values;
    for (const float v : picture.image.pixels) values.push_back(static_cast<std::uint16_t>(std::lround(v * 65535.0F)));
    return values;
}

TEST(EncodePng, keepsEveryBitOfATypesMap) {
    Image<std::uint16_t> types{{6, 1}, 1};
    types.pixels = {0, 1, 255, 256, 0x8001, 0xFFFF};
    const std::vector<std::uint8_t> bytes = encodePng(types);
    EXPECT_EQ(bytes[24], 16) << "bits a sample";
    EXPECT_EQ(bytes[25], PNG_COLOR_TYPE_GRAY);
    EXPECT_THAT(decodeGrey16(bytes), ElementsAreArray(types.pixels));
    expectError(Error::Kind::Usage, testing::StrEq("PNG: expected a picture of at least one pixel, found none"),
                [] { static_cast<void>(encodePng(Image<std::uint16_t>{})); });
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
    expectError(Error::Kind::Usage,
                testing::StrEq("a.jpg: expected a name that ends in .png, .tif, .tiff or .exr, or for lines in .svg or "
                               ".json, found .jpg"),
                [] { static_cast<void>(outputFiles("a.jpg", {})); });
    expectError(Error::Kind::Usage, HasSubstr("found no extension"), [] { static_cast<void>(outputFiles("a", {})); });
    expectError(Error::Kind::Usage,
                testing::StrEq("a.svg: expected a name that ends in .png, .tif, .tiff or .exr, found .svg"),
                [] { static_cast<void>(outputFiles("a.svg", {})); });
}

TEST(WriteFile, replacesAFileAndLeavesNothingElse) {
    const TemporaryFolder folder;
    put(folder / "a", "a longer text");
    writeFile(folder / "a", bytesOf("new"));
    EXPECT_EQ(contents(folder / "a"), "new");
    EXPECT_THAT(folder.names(), ElementsAre("a"));
}

TEST(WriteFile, givesTheModeThatTheUserAskedFor) {
    const TemporaryFolder folder;
    const mode_t old = ::umask(027);
    writeFile(folder / "a", bytesOf("new"));
    ::umask(old);
    EXPECT_EQ(fs::status(folder / "a").permissions(), fs::perms{0640});
}

TEST(WriteFile, writesWhereALinkPoints) {
    const TemporaryFolder folder;
    fs::create_directory(folder / "real");
    put(folder / "real/file", "old");
    fs::create_symlink("real/file", folder / "link");
    writeFile(folder / "link", bytesOf("new"));
    EXPECT_TRUE(fs::is_symlink(folder / "link"));
    EXPECT_EQ(contents(folder / "real/file"), "new");
}

TEST(WriteFile, writesIntoAPipeInsteadOfReplacingIt) {
    const TemporaryFolder folder;
    ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
    const int reader = ::open((folder / "pipe").c_str(), O_RDONLY | O_NONBLOCK);
    ASSERT_GE(reader, 0);
    writeFile(folder / "pipe", bytesOf("new"));
    std::array<char, 8> buffer{};
    EXPECT_EQ(::read(reader, buffer.data(), buffer.size()), 3);
    EXPECT_STREQ(buffer.data(), "new");
    ::close(reader);
    EXPECT_TRUE(fs::is_fifo(folder / "pipe"));
}

TEST(WriteFile, saysWhichFolderIsMissing) {
    const TemporaryFolder folder;
    const std::string target = (folder / "none/a").string();
    const std::string expected = target + ": cannot be written: expected a folder " + (folder / "none").string() +
                                 ", found none; create it first";
    expectError(Error::Kind::Output, testing::StrEq(expected), [&] { writeFile(target, bytesOf("new")); });
    EXPECT_THAT(folder.names(), IsEmpty());
}

TEST(WriteFile, refusesAPathBelowAFile) {
    const TemporaryFolder folder;
    put(folder / "file", "old");
    expectError(Error::Kind::Output, HasSubstr("to be a folder, found a file in its way"),
                [&] { writeFile(folder / "file/a", bytesOf("new")); });
    EXPECT_EQ(contents(folder / "file"), "old");
}

TEST(WriteFile, refusesAFoldersName) {
    const TemporaryFolder folder;
    fs::create_directory(folder / "a");
    expectError(Error::Kind::Output, HasSubstr("expected a file, found a folder"),
                [&] { writeFile(folder / "a", bytesOf("new")); });
    EXPECT_THAT(folder.names(), ElementsAre("a"));
}

TEST(WriteFile, saysThatADeviceIsFull) {
    expectError(Error::Kind::Output, StartsWith("/dev/full: cannot be written: expected room for the file, found: "),
                [] { writeFile("/dev/full", bytesOf("new")); });
}

TEST(WriteFile, keepsTheOldFileWhenTheNewOneFails) {
    const TemporaryFolder folder;
    put(folder / "a", "old");
    {
        const FileSizeLimit limit{2};
        expectError(Error::Kind::Output, HasSubstr("cannot be written"),
                    [&] { writeFile(folder / "a", bytesOf("new")); });
    }
    EXPECT_EQ(contents(folder / "a"), "old");
    EXPECT_THAT(folder.names(), ElementsAre("a"));
}

TEST(WriteMaps, writesDepthFromNearBlackToFarWhite) {
    const TemporaryFolder folder;
    writeMaps(smallMaps(), std::array{Map::Depth}, folder / "a.png");
    const DecodedPng depth = decodePng(contents(folder / "a.depth.png"));
    EXPECT_EQ(depth.colorType, PNG_COLOR_TYPE_GRAY);
    EXPECT_THAT(depth.image.pixels, ElementsAre(64, 255));  // 255 / 4, rounded
}

TEST(WriteMaps, writesDepthsThatAreNoNumberAsBlack) {
    const TemporaryFolder folder;
    Maps maps = smallMaps();
    maps.depth.pixels = {NAN, 100.0F};
    writeMaps(maps, std::array{Map::Depth}, folder / "a.png");
    EXPECT_THAT(decodePng(contents(folder / "a.depth.png")).image.pixels, ElementsAre(0, 255));
}

TEST(WriteMaps, writesNormalsAsHalfOfNPlusOne) {
    const TemporaryFolder folder;
    writeMaps(smallMaps(), std::array{Map::Normal}, folder / "a.png");
    const DecodedPng normal = decodePng(contents(folder / "a.normal.png"));
    EXPECT_EQ(normal.colorType, PNG_COLOR_TYPE_RGB);
    EXPECT_THAT(normal.image.pixels, ElementsAre(204, 25, 128, 128, 128, 0));
}

TEST(WriteMaps, writesEdgesBlackOnWhite) {
    const TemporaryFolder folder;
    const std::vector<fs::path> files =
        writeMaps(smallMaps(), std::array{Map::DepthEdges, Map::NormalEdges, Map::Edges}, folder / "{map}.png");
    EXPECT_THAT(files, ElementsAre(folder / "outline.png", folder / "depth-edges.png", folder / "normal-edges.png",
                                   folder / "edges.png"));
    EXPECT_THAT(decodePng(contents(files[0])).image.pixels, ElementsAre(0, 255));
    EXPECT_THAT(decodePng(contents(files[1])).image.pixels, ElementsAre(0, 255));
    EXPECT_THAT(decodePng(contents(files[2])).image.pixels, ElementsAre(255, 0));
    EXPECT_THAT(decodePng(contents(files[3])).image.pixels, ElementsAre(0, 0));
}

TEST(WriteMaps, writesTheSameValuesToTiff) {
    const TemporaryFolder folder;
    Maps maps = smallMaps();
    maps.picture = noise({67, 131}, 4);
    writeMaps(maps, {}, folder / "a.tif");
    const DecodedFile file = decodeFile(folder / "a.tif");
    EXPECT_STREQ(OIIO::ImageInput::open((folder / "a.tif").string())->format_name(), "tiff");
    EXPECT_EQ(file.spec.format, OIIO::TypeUInt8);
    EXPECT_EQ(file.spec.alpha_channel, 3);
    EXPECT_EQ(file.spec.get_int_attribute("oiio:UnassociatedAlpha"), 1) << "alpha is not multiplied in";
    ASSERT_EQ(file.image.pixels.size(), maps.picture.pixels.size());
    for (std::size_t i = 0; i < maps.picture.pixels.size(); ++i) {
        ASSERT_EQ(std::lround(file.image.pixels[i] * 255.0F), maps.picture.pixels[i]) << "value " << i;
    }
}

TEST(WriteMaps, namesTheLayersOfAnExr) {
    const TemporaryFolder folder;
    writeMaps(smallMaps(), allMaps, folder / "a.exr");
    const DecodedFile file = decodeFile(folder / "a.exr");
    EXPECT_THAT(file.spec.channelnames,
                testing::UnorderedElementsAre("Y", "depth.Z", "normal.X", "normal.Y", "normal.Z", "depth-edges.Y",
                                              "normal-edges.Y", "edges.Y"));
    EXPECT_EQ(file.spec.channelnames.front(), "Y");
    for (const char* const exact : {"depth.Z", "normal.X", "normal.Y", "normal.Z"}) {
        EXPECT_EQ(file.spec.channelformat(file.spec.channelindex(exact)), OIIO::TypeFloat) << exact;
    }
}

TEST(WriteMaps, keepsFloatMapsExactlyInAnExr) {
    const TemporaryFolder folder;
    writeMaps(smallMaps(), allMaps, folder / "a.exr");
    const DecodedFile file = decodeFile(folder / "a.exr");
    EXPECT_THAT(file.channel("Y"), ElementsAre(0.0F, 1.0F));
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
    maps.types = Image<std::uint16_t>{maps.picture.size, 1};
    maps.types.pixels = {0x8001, 0xFFFF};
    writeMaps(maps, std::array{Map::Types}, folder / "a.exr");
    EXPECT_THAT(decodeFile(folder / "a.exr").channel("types.bits"), ElementsAre(32769.0F, 65535.0F));
}

TEST(WriteMaps, writesTypesAsTheColourOfTheFirst) {
    const TemporaryFolder folder;
    Maps maps = smallMaps();
    maps.types = Image<std::uint16_t>{maps.picture.size, 1};
    maps.types.pixels = {0, 2 | 32};  // an occlusion between two objects
    writeMaps(maps, std::array{Map::Types}, folder / "a.png");
    EXPECT_THAT(decodePng(contents(folder / "a.types.png")).image.pixels, ElementsAre(255, 255, 255, 20, 150, 40));
}

TEST(WriteMaps, keepsRowsOfATallExrInOrder) {
    const TemporaryFolder folder;
    Maps maps = smallMaps();
    maps.picture = Image<std::uint8_t>{{3, 201}, 1, 255};
    maps.depth = Image<float>{{3, 201}, 1};
    for (std::size_t i = 0; i < maps.depth.pixels.size(); ++i) maps.depth.pixels[i] = static_cast<float>(i);
    writeMaps(maps, std::array{Map::Depth}, folder / "a.exr");
    EXPECT_THAT(decodeFile(folder / "a.exr").channel("depth.Z"), ElementsAreArray(maps.depth.pixels));
}

TEST(WriteMaps, putsOnlyTheMapsAskedForIntoAnExr) {
    const TemporaryFolder folder;
    writeMaps(smallMaps(), std::array{Map::Edges, Map::Edges}, folder / "a.exr");
    EXPECT_THAT(decodeFile(folder / "a.exr").spec.channelnames, ElementsAre("Y", "edges.Y"));
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
    maps.picture = Image<std::uint8_t>{{2, 1}, 4};
    maps.picture.pixels = {255, 188, 0, 255, 255, 0, 0, 51};
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
                [&] { static_cast<void>(openModule(io::imageModule, folders, Error::Kind::Output)); });
}

TEST(ImageModule, refusesAFileThatIsNone) {
    const TemporaryFolder folder;
    put(folder / io::imageModule.file, "no library");
    const std::array<fs::path, 1> folders{folder.path()};
    expectError(Error::Kind::Input, AllOf(HasSubstr("that can be opened, found: "), HasSubstr("reinstall")),
                [&] { static_cast<void>(openModule(io::imageModule, folders, Error::Kind::Input)); });
}

TEST(MetadataJson, hasTheCameraRowByRow) {
    const Maps maps = smallMaps();
    const auto camera = nlohmann::json::parse(metadataJson(triangle(), maps, {})).at("camera");
    EXPECT_EQ(camera.at("view").dump(), "[[1.0,0.0,0.0,1.0],[0.0,1.0,0.0,2.0],[0.0,0.0,1.0,-3.0],[0.0,0.0,0.0,1.0]]");
    const glm::dmat4 projection = maps.camera.projection({2, 1});
    EXPECT_EQ(camera.at("projection").at(2).at(3), projection[3][2]);
    EXPECT_EQ(camera.at("projection").at(3).at(2), -1.0);
    EXPECT_EQ(camera.at("near"), 2.0);
    EXPECT_EQ(camera.at("far"), 4.0);
    EXPECT_EQ(camera.at("eye").dump(), "[-1.0,-2.0,3.0]");
    EXPECT_EQ(camera.at("view_angle"), 35.0);
    EXPECT_FALSE(camera.contains("orthographic_height"));
}

TEST(MetadataJson, hasTheHeightOfAnOrthographicCamera) {
    Maps maps = smallMaps();
    maps.camera.orthographicHeight = 7.0;
    const auto camera = nlohmann::json::parse(metadataJson(triangle(), maps, {})).at("camera");
    EXPECT_EQ(camera.at("orthographic_height"), 7.0);
    EXPECT_FALSE(camera.contains("view_angle"));
}

TEST(MetadataJson, hasEverySettingAndNullWhereNoneIsGiven) {
    Settings settings;
    settings.picture.lineColor = {255, 0, 0};
    const auto json = nlohmann::json::parse(metadataJson(triangle(), smallMaps(), settings)).at("settings");
    EXPECT_EQ(json.size(), settingTable().size());
    for (const SettingDescription& setting : settingTable()) {
        const auto& value = json.at(std::string{setting.name});
        EXPECT_EQ(value.is_null() ? "" : value.get<std::string>(), setting.get(settings)) << setting.name;
    }
    EXPECT_TRUE(json.at("camera-position").is_null());
}

TEST(MetadataJson, hasTheSceneTheBackendAndTheTimes) {
    Maps maps = smallMaps();
    maps.backend.backend = "osmesa";
    maps.backend.renderer = "llvmpipe";
    maps.backend.software = true;
    maps.times = {{"draw", 1.5}, {"read back", 2.0}, {"draw", 1.0}};
    const auto json = nlohmann::json::parse(metadataJson(triangle(), maps, {}));
    EXPECT_EQ(json.at("size").dump(), "[2,1]");
    EXPECT_EQ(json.at("triangles"), 1);
    EXPECT_EQ(json.at("bounds").at("radius"), triangle().bounds().radius);
    EXPECT_EQ(json.at("bounds").at("centre").at(1), triangle().bounds().centre.y);
    EXPECT_EQ(json.at("warnings").at(0), "a warning");
    EXPECT_THAT(json.at("warnings").at(1).get<std::string>(), StartsWith("a name that is no UTF-8: "));
    EXPECT_EQ(json.at("backend").at("backend"), "osmesa");
    EXPECT_EQ(json.at("backend").at("renderer"), "llvmpipe");
    EXPECT_EQ(json.at("backend").at("software"), true);
    EXPECT_EQ(json.at("milliseconds").at("draw"), 2.5);
    EXPECT_EQ(json.at("milliseconds").at("read back"), 2.0);
}

TEST(MetadataJson, saysOfLinesWhatItSaysOfAPicture) {
    Maps maps = smallMaps();
    maps.backend.backend = "osmesa";
    maps.times = {{"draw", 1.5}};
    const Lines lines{{}, maps.picture.size, maps.camera, maps.backend, maps.times};
    EXPECT_EQ(metadataJson(triangle(), lines, {}), metadataJson(triangle(), maps, {}));
}
