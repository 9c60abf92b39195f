#include <chrono>
#include <filesystem>

#include <gmock/gmock.h>

#include <inkedge/encode_png.h>
#include <inkedge/renderer.h>

#include "base/temporary_folder.h"
#include "gl/gl_test.h"
#include "scenes.h"

namespace inkedge::render {
namespace {

INKEDGE_ON_EACH_BACKEND(BrushFile);

void putBrush(const std::filesystem::path& file, std::uint8_t grey) {
    const std::vector<std::uint8_t> png = encodePng(Image<std::uint8_t>{{8, 8}, 1, grey});
    put(file, {png.begin(), png.end()});
}

TEST_P(BrushFile, isReadAgainWhenItHasChanged) {
    const Scene scene = scenes::sceneOf(scenes::cube());
    const TemporaryFolder folder;
    Settings settings;
    settings.picture.size = {96, 72};
    settings.lines.from = LinesFrom::Object;
    settings.lines.brush = (folder / "brush.png").string();
    const Camera camera = frameCamera(scene, {}, settings.picture.size);
    const auto draw = [&] { return renderer().render(scene, camera, settings).picture.pixels(); };
    putBrush(settings.lines.brush, 0);
    const auto full = draw();
    EXPECT_THAT(full, testing::Contains(0)) << "a dark brush gives full ink";
    putBrush(settings.lines.brush, 255);
    std::filesystem::last_write_time(settings.lines.brush,
                                     std::filesystem::last_write_time(settings.lines.brush) + std::chrono::hours{1});
    EXPECT_THAT(draw(), testing::Each(255)) << "a clear brush gives none";
}

}  // namespace
}  // namespace inkedge::render
