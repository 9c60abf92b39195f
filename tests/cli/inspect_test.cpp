#include <nlohmann/json.hpp>

#include "cli/command.h"

namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;

class Inspect : public Command {
protected:
    json inspected(const std::string& model, Arguments more = {}) const {
        Arguments arguments{"inspect", model, "--json"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Outcome outcome = run(arguments);
        EXPECT_EQ(outcome.exitCode, 0) << outcome.error;
        return json::parse(outcome.out);
    }
};

TEST_F(Inspect, SaysWhatIsInAFile) {
    const json found = inspected(asset("lantern.glb"));
    EXPECT_EQ(found.at("format"), "glTF 2.0");
    EXPECT_EQ(found.at("instances"), 3);
    EXPECT_EQ(found.at("scenes"), (json{"", "leaf alone"}));
    EXPECT_EQ(found.at("animations"), json{"swing"});
    EXPECT_EQ(found.at("materials").at(0), (json{{"name", "tin"}, {"double_sided", false}}));
    EXPECT_EQ(found.at("meshes").at(0).at("triangles"), 10);
    EXPECT_EQ(found.at("meshes").at(0).at("instances"), 1);
    EXPECT_NEAR(found.at("bounds").at("min").at(0).get<double>(), -0.4, 1e-6);
    EXPECT_EQ(found.at("warnings"), json::array());
}

TEST_F(Inspect, SaysWhichCamerasThereAreAndWhatIsNotDrawn) {
    const json found = inspected(asset("primitives.glb"));
    ASSERT_EQ(found.at("cameras").size(), 1U);
    EXPECT_EQ(found.at("cameras").at(0).at("type"), "orthographic");
    EXPECT_EQ(found.at("cameras").at(0).at("name"), "front");
    EXPECT_NEAR(found.at("cameras").at(0).at("height").get<double>(), 5.4, 1e-6);
    ASSERT_EQ(found.at("warnings").size(), 1U);
    EXPECT_THAT(found.at("warnings").at(0).get<std::string>(),
                HasSubstr("primitives of points or lines are not drawn"));
}

TEST_F(Inspect, TakesTheSettingsOfTheModel) {
    EXPECT_EQ(inspected(asset("lantern.glb"), {"--scene", "1"}).at("instances"), 1);
    EXPECT_EQ(inspected(asset("lantern.glb"), {"--transparent", "ignore"}).at("instances"), 2);
    EXPECT_EQ(run({"inspect", asset("lantern.glb"), "--size", "3x3"}).exitCode, 2);
}

TEST_F(Inspect, SaysItInLinesForPeople) {
    const Outcome outcome = run({"inspect", asset("lantern.glb")});
    EXPECT_EQ(outcome.exitCode, 0);
    for (const char* line :
         {"glTF 2.0\n", "in 3 instances of 3 meshes\n", "     0  cup: 10 triangles, 20 vertices, 1 instances\n",
          "     1  leaf alone\n", "     0  swing\n", "     0  tin: single-sided\n"})
        EXPECT_THAT(outcome.out, HasSubstr(line));
}

TEST_F(Inspect, ErrorsAreThoseOfRender) {
    const Outcome outcome = run({"inspect", emptyModel()});
    EXPECT_EQ(outcome.exitCode, 3);
    EXPECT_THAT(outcome.error, HasSubstr("empty.gltf: expected at least one triangle to draw, found none\n"));
    EXPECT_EQ(run({"inspect", "missing.glb"}).exitCode, 3);
    EXPECT_EQ(run({"inspect"}).exitCode, 2);
}

}  // namespace
