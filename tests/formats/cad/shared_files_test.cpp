// Real files, where they are there.
#include <cstdio>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include <inkedge/load_scene.h>
#include <inkedge/views.h>

#include "lines/object_lines.h"

namespace inkedge::cad {
namespace {

TEST(SharedCadFiles, areReadAndHaveLines) {
    const std::filesystem::path folder = std::filesystem::path{INKEDGE_SOURCE_DIR} / "../shared/cad";
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << "SKIPPED: no files in ../shared/cad";
    int tested = 0;
    for (const auto& entry : std::filesystem::directory_iterator{folder}) {
        if (entry.path().extension() == ".md") continue;
        SCOPED_TRACE(entry.path().filename());
        LoadSettings load;
        load.tolerance = 2.0;  // for speed
        Settings settings;
        settings.picture.size = {400, 400};
        load.pictures = {{CameraSettings{}}, settings.picture, {}};
        const Scene scene = loadScene(entry.path(), load);
        const Camera camera = frameCamera(scene, {}, settings.picture.size);
        double outline = 0.0;
        double inner = 0.0;
        for (const Line& line : lines::ObjectLines{scene}.find(camera, settings).lines) {
            for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
                const double length = glm::distance(line.points[i].pixel, line.points[i + 1].pixel);
                (line.type == LineType::Outline || line.type == LineType::Boundary ? outline : inner) += length;
            }
        }
        EXPECT_GT(outline, 400.0);  // around a part that fills the picture one way at least
        EXPECT_GT(inner, 100.0);
        ++tested;
    }
    EXPECT_GT(tested, 10);
}

}  // namespace
}  // namespace inkedge::cad
