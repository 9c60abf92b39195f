#include <nlohmann/json.hpp>

#include "cli/command.h"

namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

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
    ASSERT_EQ(found.at("instances").size(), 3U);
    json pane = found.at("instances").at(1);
    EXPECT_NEAR(pane.at("transform").at(2).at(3).get<double>(), 0.6, 1e-6);
    pane.erase("transform");
    EXPECT_EQ(pane, (json{{"id", 2}, {"node", "lantern/pane"}, {"mesh", "pane"}, {"materials", {2}}}));
    EXPECT_EQ(found.at("scenes"), (json{"", "leaf alone"}));
    EXPECT_EQ(found.at("animations"), json{"swing"});
    EXPECT_EQ(found.at("materials").at(0), (json{{"id", 1}, {"name", "tin"}, {"double_sided", false}}));
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
    EXPECT_THAT(found.at("warnings").at(0).get<std::string>(), HasSubstr("primitives of points are not drawn"));
}

TEST_F(Inspect, TakesTheSettingsOfTheModel) {
    EXPECT_EQ(inspected(asset("lantern.glb"), {"--scene", "1"}).at("instances").size(), 1U);
    EXPECT_EQ(inspected(asset("lantern.glb"), {"--transparent", "ignore"}).at("instances").size(), 2U);
    EXPECT_EQ(run({"inspect", asset("lantern.glb"), "--size", "3x3"}).exitCode, 2);
}

TEST_F(Inspect, SaysItInLinesForPeople) {
    const Outcome outcome = run({"inspect", asset("lantern.glb")});
    EXPECT_EQ(outcome.exitCode, 0);
    for (const char* line :
         {"glTF 2.0\n", "in 3 instances of 3 meshes\n", "     0  cup: 10 triangles, 20 vertices, 1 instances\n",
          "     1  leaf alone\n", "     0  swing\n", "     1  tin: single-sided\n"})
        EXPECT_THAT(outcome.out, HasSubstr(line));
}

TEST_F(Inspect, CountsLines) {
    const std::string wire = file("wire.obj", "v 0 0 0\nv 1 0 0\nv 1 2 0\nl 1 2 3\n");
    const json found = inspected(wire);
    EXPECT_EQ(found.at("triangles"), 0);
    EXPECT_EQ(found.at("lines"), 2);
    EXPECT_EQ(found.at("meshes").at(0).at("lines"), 2);
    EXPECT_EQ(found.at("not_drawn"), json::array());
    EXPECT_EQ(found.at("bounds").at("max"), json({1.0, 2.0, 0.0}));
    EXPECT_THAT(run({"inspect", wire}).out,
                AllOf(HasSubstr("triangles  0 in 1 instances of 1 meshes\nlines      2, as straight pieces\n"),
                      HasSubstr("wire: 0 triangles, 2 lines, ")));
    EXPECT_EQ(inspected(asset("gear.glb")).at("lines"), 0);
    EXPECT_THAT(run({"inspect", asset("gear.glb")}).out, Not(HasSubstr("lines")));
}

TEST_F(Inspect, SaysWhatThereIsInsteadOfTriangles) {
    const std::string cloud = file("cloud.ply",
                                   "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
                                   "property float z\nend_header\n0 0 0\n1 0 0\n");
    const json found = inspected(cloud);
    EXPECT_EQ(found.at("triangles"), 0);
    EXPECT_EQ(found.at("not_drawn"), json({"2 points"}));
    EXPECT_EQ(found.at("bounds"), nullptr);
    const Outcome outcome = run({"inspect", cloud});
    EXPECT_EQ(outcome.exitCode, 0);
    EXPECT_THAT(outcome.out,
                StartsWith(cloud + ": PLY\ntriangles  0 in 0 instances of 0 meshes\nnot drawn  2 points\nwarning"));
    const Outcome refused = run({"render", cloud, "-o", "cloud.png"});
    EXPECT_EQ(refused.exitCode, 3);
    EXPECT_THAT(refused.error,
                HasSubstr("cloud.ply: expected at least one triangle or line to draw, found none: 2 points\n"));
    EXPECT_EQ(inspected(emptyModel()).at("not_drawn"), json({"no mesh"}));
    EXPECT_EQ(inspected(asset("primitives.glb")).at("not_drawn"), json::array());
}

TEST_F(Inspect, ErrorsAreThoseOfRender) {
    const std::string broken = file("broken.obj", "v 0 0 0\nf 1 2 3\n");
    for (const Outcome& outcome : {run({"inspect", broken}), run({"render", broken, "-o", "broken.png"})}) {
        EXPECT_EQ(outcome.exitCode, 3);
        EXPECT_THAT(outcome.error, HasSubstr("broken.obj: line 2: expected a vertex from 1 to 1, found 3\n"));
    }
    EXPECT_EQ(run({"inspect", "missing.glb"}).exitCode, 3);
    EXPECT_EQ(run({"inspect"}).exitCode, 2);
}

}  // namespace
