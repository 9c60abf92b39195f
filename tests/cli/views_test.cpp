#include <set>

#include "cli/command.h"

namespace {

using nlohmann::json;
using testing::HasSubstr;

class Views : public Command {};

TEST_F(Views, AreDrawnAsOneByOneHoweverManyAtATime) {
    constexpr int count = 12;
    const auto pictures = [&](const std::string& jobs, const Arguments& more) {
        Arguments arguments{"render", asset("gear.glb"), "-o",           "view{view}.png", "--size",
                            "64x48",  "--views",         "turntable:12", "--jobs",         jobs};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Outcome outcome = run(arguments);
        EXPECT_EQ(outcome.exitCode, 0) << outcome.error;
        std::vector<std::string> all;
        for (int i = 0; i < count; ++i) {
            const std::string number = std::to_string(i);
            all.push_back(contents(folder_ / ("view" + std::string(3 - number.size(), '0') + number + ".png")));
        }
        return all;
    };
    const auto alone = pictures("1", {});
    EXPECT_EQ(pictures("3", {}), alone);
    EXPECT_EQ(std::set<std::string>(alone.begin(), alone.end()).size(), static_cast<std::size_t>(count));
    const Outcome single =
        run({"render", asset("gear.glb"), "-o", "one.png", "--size", "64x48", "--azimuth", "90", "--elevation", "0"});
    EXPECT_EQ(single.exitCode, 0) << single.error;
    EXPECT_EQ(pictures("2", {"--elevation", "0"}).at(3), contents(folder_ / "one.png"));
}

TEST_F(Views, HaveMetadataAndJsonEach) {
    const Outcome outcome = run({"render", asset("cube.glb"), "-o", "{model}_{view}_{map}.png", "--maps", "depth",
                                 "--size", "32x32", "--views", "sphere:5", "--metadata", "{view}.json", "--json"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.error;
    const json all = json::parse(outcome.out);
    ASSERT_EQ(all.size(), 5U);
    EXPECT_EQ(all.at(4).at("files"), (json{"cube_004_outline.png", "cube_004_depth.png"}));
    EXPECT_EQ(json::parse(contents(folder_ / "004.json")).at("camera"), all.at(4).at("camera"));
    EXPECT_EQ(folder_.names().size(), 15U);
}

TEST_F(Views, ShareMetadataWhoseNameIsOne) {
    const std::string views = file("views.json", R"([{"name": "a"}, {"name": "b", "camera-azimuth-angle": 40}])");
    const Outcome outcome = run({"render", asset("cube.glb"), asset("gear.glb"), "-o", "{model}_{view}.png", "--size",
                                 "32x32", "--views", views, "--metadata", "{model}.json", "--json"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.error;
    const json printed = json::parse(outcome.out);
    for (const auto& [model, first] : {std::pair{"cube", 0}, std::pair{"gear", 2}}) {
        const json all = json::parse(contents(folder_ / (std::string{model} + ".json")));
        EXPECT_EQ(all.at("model"), asset(std::string{model} + ".glb"));
        ASSERT_EQ(all.at("views").size(), 2U);
        for (const int i : {0, 1}) {
            const json& view = all.at("views").at(static_cast<std::size_t>(i));
            const json& alone = printed.at(static_cast<std::size_t>(first + i));
            for (const char* key : {"view", "files", "camera", "size", "dpi"}) EXPECT_EQ(view.at(key), alone.at(key));
            EXPECT_EQ(view.at("files").at(0), std::string{model} + (i == 0 ? "_a.png" : "_b.png"));
        }
    }
}

TEST_F(Views, NeedAFileNameEach) {
    const auto refused = [&](Arguments more, const std::string& message) {
        Arguments arguments{"render", asset("cube.glb"), "--views", "turntable:2"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Outcome outcome = run(arguments);
        EXPECT_EQ(outcome.exitCode, 2);
        EXPECT_THAT(outcome.error, HasSubstr(message));
        EXPECT_THAT(folder_.names(), testing::IsEmpty());
    };
    refused({"-o", "a.png"}, "--output: expected {view} in it for 2 views, found 'a.png'");
    refused({"-o", "{view}.png", "--metadata", "001.png"},
            "001.png: expected a file for --output 001.png alone, found it asked for by --metadata too");
    refused({"-o", "-"}, "--views: expected --output FILE, found -");
    refused({"-o", "{view}.png", "--jobs", "0"}, "--jobs");
}

// The view that cannot be drawn is the second; no picture of a later one may be lost in silence.
TEST_F(Views, EndWithTheFirstError) {
    const std::string views = file("views.json", R"([{}, {"camera-index": 7}])");
    const Outcome outcome = run({"render", asset("cube.glb"), "-o", "{view}.png", "--size", "32x32", "--views", views});
    EXPECT_EQ(outcome.exitCode, 2);
    EXPECT_THAT(outcome.error, HasSubstr("camera-index: "));
}

}  // namespace
