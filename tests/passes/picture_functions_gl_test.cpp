// Surface functions that read a picture of a file.
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>

#include <inkedge/encode_png.h>
#include <inkedge/setting_table.h>

#include "base/temporary_folder.h"
#include "gl/gl_test.h"
#include "scenes.h"

namespace inkedge::passes {
namespace {

INKEDGE_ON_EACH_BACKEND(PictureFunctions);

// Of one grey, or of two in stripes.
void putPicture(const std::filesystem::path& file, int stripe) {
    Image<std::uint8_t> picture{{16, 16}, 1, 128};
    for (int y = 0; y < 16 && stripe > 0; ++y)
        for (int x = 0; x < 16; ++x) picture.at(x, y) = x / stripe % 2 == 0 ? 0 : 255;
    const std::vector<std::uint8_t> png = encodePng(picture);
    put(file, {png.begin(), png.end()});
}

TEST_P(PictureFunctions, drawAPictureAsItIsOnDiskNow) {
    Mesh square = scenes::quad({-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0});
    for (const glm::vec3& p : square.positions) square.textureCoordinates.push_back(0.5F * glm::vec2{p} + 0.5F);
    LoadSettings load;
    load.textureCoordinates = true;
    const Scene scene = scenes::sceneOf({{square, glm::dmat4{1.0}}}, load);
    const TemporaryFolder folder;
    const std::filesystem::path file = folder / "picture.png";
    Settings settings;
    settings.picture.size = {96, 72};
    settings.maps = {Map::Edges};
    settings.detector.detector = Detector::None;
    set(settings, "function", "texture:file=" + file.string(), "");
    CameraSettings front;
    front.elevationAngle = 0.0;
    front.azimuthAngle = 0.0;
    const Camera camera = frameCamera(scene, front, settings.picture.size);
    const auto marked = [&] {
        return std::ranges::count(renderer().render(scene, camera, settings).edges.pixels(), 255);
    };
    putPicture(file, 0);
    const auto plain = marked();
    putPicture(file, 4);
    std::filesystem::last_write_time(file, std::filesystem::last_write_time(file) + std::chrono::hours{1});
    const auto striped = marked();
    EXPECT_GT(striped, plain + 100);
    EXPECT_EQ(marked(), striped);
}

}  // namespace
}  // namespace inkedge::passes
