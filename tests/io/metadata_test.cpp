#include <inkedge/write.h>

#include <cstring>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <inkedge/setting_table.h>

#include "io/decoded_files.h"

namespace {

using namespace inkedge::decoded_files;
using namespace inkedge;
using testing::StartsWith;

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

TEST(MetadataJson, hasTheCameraAsOpenCvHasIt) {
    Maps maps = smallMaps();
    maps.picture = Image<std::uint8_t>{{640, 480}, 1};
    const auto camera = nlohmann::json::parse(metadataJson(triangle(), maps, {})).at("camera");
    EXPECT_EQ(camera.at("world_to_camera").dump(),
              "[[1.0,0.0,0.0,1.0],[0.0,-1.0,0.0,-2.0],[0.0,0.0,-1.0,3.0],[0.0,0.0,0.0,1.0]]");
    const double focal = maps.camera.focalLength({640, 480});
    EXPECT_EQ(camera.at("K"), (nlohmann::json{{focal, 0.0, 319.5}, {0.0, focal, 239.5}, {0.0, 0.0, 1.0}}));
    maps.camera.axis = {0.5, -0.25};  // of a view that was cut out of a larger one
    const auto cut = nlohmann::json::parse(metadataJson(triangle(), maps, {})).at("camera");
    EXPECT_EQ(cut.at("K"), (nlohmann::json{{focal, 0.0, 479.5}, {0.0, focal, 299.5}, {0.0, 0.0, 1.0}}));
    maps.camera.pixelAspect = 2.0;
    const auto wide = nlohmann::json::parse(metadataJson(triangle(), maps, {})).at("camera");
    EXPECT_EQ(wide.at("K"), (nlohmann::json{{focal / 2.0, 0.0, 479.5}, {0.0, focal, 299.5}, {0.0, 0.0, 1.0}}));
    EXPECT_EQ(wide.at("pixel_aspect"), 2.0);
}

TEST(MetadataJson, namesModelViewFilesInstancesAndTheScaleOfDepth) {
    Settings settings;
    const ViewFiles files{"a/part.glb", "front", {"out/a.png", "out/a.depth.png"}};
    auto json = nlohmann::json::parse(metadataJson(triangle(), smallMaps(), settings, files));
    EXPECT_EQ(json.at("model"), "a/part.glb");
    EXPECT_EQ(json.at("view"), "front");
    EXPECT_EQ(json.at("files"), (nlohmann::json{"out/a.png", "out/a.depth.png"}));
    EXPECT_EQ(json.at("instances").at(0).at("node"), "triangle");
    EXPECT_EQ(json.at("materials"), nlohmann::json::array());
    EXPECT_FALSE(json.contains("depth_png"));
    EXPECT_EQ(json.at("dpi"), nullptr);
    settings.maps = {Map::Depth};
    Maps maps = smallMaps();
    maps.dpi = 300.0;
    json = nlohmann::json::parse(metadataJson(triangle(), maps, settings, files));
    EXPECT_EQ(json.at("dpi"), 300.0);
    EXPECT_EQ(json.at("depth_png"), (nlohmann::json{{"offset", 2.0}, {"scale", 2.0 / 65535.0}}));
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
    Lines lines;
    lines.size = maps.picture.size();
    lines.camera = maps.camera;
    lines.bounds = triangle().bounds();
    lines.source.triangles = triangle().triangleCount();
    lines.source.warnings = triangle().warnings();
    lines.backend = maps.backend;
    lines.times = maps.times;
    lines.names = namesOf(triangle());
    nlohmann::ordered_json ofPicture = nlohmann::ordered_json::parse(metadataJson(triangle(), maps, {}));
    EXPECT_EQ(ofPicture.at("up"), (nlohmann::ordered_json{0.0, 1.0, 0.0}));
    ofPicture.erase("up");  // which lines do not know
    EXPECT_EQ(metadataJson(lines, {}), ofPicture.dump(2) + '\n');
}

}  // namespace
