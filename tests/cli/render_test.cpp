// inkedge render: what it writes, where, and what it says.
#include "cli/command.h"
#include "cli/decode_png.h"

namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

class Render : public Command {};

TEST_F(Render, DrawsBlackLinesOnWhiteByDefault) {
    expectSuccess(run({"render", asset("cube.glb"), "-o", "cube.png", "--size", "80x60", "--detector", "classic"}));
    const Picture picture = decodePng(contents(folder_ / "cube.png"));
    EXPECT_EQ(picture.width, 80U);
    EXPECT_EQ(picture.height, 60U);
    const auto black = std::ranges::count(picture.grey, '\0');
    const auto white = std::ranges::count(picture.grey, '\xff');
    EXPECT_GT(black, 100);
    EXPECT_GT(white, 2400);
    EXPECT_THAT(folder_.names(), ElementsAre("cube.png"));
}

TEST_F(Render, SaysNothingWhenAllIsWell) {
    const Outcome outcome = render(roof());
    expectSuccess(outcome);
    EXPECT_EQ(outcome.out, "");
    EXPECT_THAT(outcome.error, testing::Not(HasSubstr("inkedge")));
}

TEST_F(Render, WritesTheSamePngToStandardOutputAsToAFile) {
    const Arguments look{"--size", "40x30", "--detector", "classic"};
    Arguments toFile{"render", roof(), "-o", "roof.png"};
    Arguments toOutput{"render", roof(), "-o", "-"};
    toFile.insert(toFile.end(), look.begin(), look.end());
    toOutput.insert(toOutput.end(), look.begin(), look.end());
    expectSuccess(run(toFile));
    const Outcome outcome = run(toOutput);
    expectSuccess(outcome);
    EXPECT_EQ(decodePng(outcome.out).width, 40U);
    EXPECT_EQ(outcome.out, contents(folder_ / "roof.png"));
    EXPECT_THAT(folder_.names(), ElementsAre("roof.png"));
}

TEST_F(Render, RefusesASecondUseOfStandardOutput) {
    expectFailure(run({"render", roof(), "-o", "-", "--json"}), 2,
                  HasSubstr("--json: expected --output FILE, found -"));
    expectFailure(run({"render", roof(), "-o", "-", "--maps", "depth"}), 2,
                  HasSubstr("--maps: expected --output FILE, found -"));
}

TEST_F(Render, WritesEveryMapBesideThePicture) {
    expectSuccess(render(roof(), {"--maps", everyMap()}));
    std::vector<std::string> expected{"metadata.json", "picture.png"};
    for (const char* map : {"depth", "normal", "depth-edges", "normal-edges", "edges", "types", "ids-patch",
                            "ids-across", "ids-object", "ids-material", "shade"})
        expected.push_back(std::string{"picture."} + map + ".png");
    EXPECT_THAT(folder_.names(), testing::UnorderedElementsAreArray(expected));
    for (const auto& name : folder_.names()) {
        if (name == "metadata.json") continue;
        EXPECT_EQ(decodePng(contents(folder_ / name)).width, 48U) << name;
    }
}

TEST_F(Render, FillsTheFieldsOfTheOutputsName) {
    expectSuccess(run({"render", roof(), "-o", "{model}-{view}-{map}.png", "--size", "8x8", "--maps", "depth,edges"}));
    EXPECT_THAT(folder_.names(), ElementsAre("roof-0-depth.png", "roof-0-edges.png", "roof-0-outline.png"));
}

TEST_F(Render, PutsEveryLayerIntoOneExr) {
    expectSuccess(run({"render", roof(), "-o", "roof.exr", "--size", "48x32", "--maps", everyMap()}));
    EXPECT_THAT(folder_.names(), ElementsAre("roof.exr"));
    const std::string header = contents(folder_ / "roof.exr").substr(0, 4096);
    EXPECT_THAT(header, StartsWith("\x76\x2f\x31\x01"));
    for (const char* channel :
         {"R", "G", "B", "depth.Z", "normal.X", "normal.Y", "normal.Z", "depth-edges.Y", "normal-edges.Y", "edges.Y",
          "types.V", "object.V", "patch.V", "across.V", "material.V", "shade.R", "shade.G", "shade.B", "shade.A"}) {
        EXPECT_NE(header.find(std::string{'\0'} + channel + '\0'), std::string::npos) << channel;
    }
    for (const char* entry : {"inkedge:near", "inkedge:far", "inkedge:view", "inkedge:projection", "inkedge:names"}) {
        EXPECT_NE(header.find(std::string{entry} + '\0'), std::string::npos) << entry;
    }
    const json comparison = json::parse(run({"compare", "roof.exr", "roof.exr", "--json"}).out);
    EXPECT_EQ(comparison["channels"], 19);
    EXPECT_EQ(comparison["width"], 48);
    EXPECT_EQ(comparison["height"], 32);
}

TEST_F(Render, WritesTheSamePictureAsTiffAndAsPng) {
    for (const char* name : {"roof.tif", "roof.png"}) {
        expectSuccess(run({"render", roof(), "-o", name, "--size", "40x30", "--line-color", "#204060"}));
    }
    EXPECT_EQ(run({"compare", "roof.tif", "roof.png"}).exitCode, 0);
}

TEST_F(Render, KeepsATransparentBackground) {
    expectSuccess(render(roof(), {"--background", "none"}));
    const std::string png = contents(folder_ / "picture.png");
    ASSERT_GT(png.size(), 25U);
    EXPECT_EQ(png[25], PNG_COLOR_TYPE_RGB_ALPHA);
}

TEST_F(Render, MetadataHoldsCameraSizeBoundsSettingsBackendAndTimes) {
    expectSuccess(render(roof()));
    const json all = metadata();
    for (const char* matrix : {"view", "projection"}) {
        ASSERT_EQ(all["camera"][matrix].size(), 4U);
        for (const json& row : all["camera"][matrix]) EXPECT_EQ(row.size(), 4U);
    }
    EXPECT_EQ(all["camera"]["view"][3], json::parse("[0.0, 0.0, 0.0, 1.0]"));
    EXPECT_EQ(all["camera"]["projection"][3], json::parse("[0.0, 0.0, -1.0, 0.0]"));
    EXPECT_GT(all["camera"]["near"].get<double>(), 0.0);
    EXPECT_GT(all["camera"]["far"].get<double>(), all["camera"]["near"].get<double>());
    EXPECT_EQ(all["size"], json::parse("[48, 48]"));
    EXPECT_EQ(all["triangles"], 4);
    EXPECT_NEAR(all["bounds"]["radius"].get<double>(), std::sqrt(2.0), 0.05);
    EXPECT_EQ(all["settings"]["detector"], "classic");
    for (const char* text : {"backend", "platform", "vendor", "renderer", "version"}) {
        EXPECT_FALSE(all["backend"][text].get<std::string>().empty()) << text;
    }
    for (const char* stage :
         {"load", "prepare", "context", "upload", "surface", "edges", "composite", "read-back", "write"}) {
        EXPECT_GE(all["milliseconds"].value(stage, -1.0), 0.0) << stage;
    }
}

TEST_F(Render, JsonNamesTheModelAndTheFilesWritten) {
    const Outcome outcome = render(roof(), {"--json", "--maps", "depth"});
    expectSuccess(outcome);
    const json summary = json::parse(outcome.out);
    EXPECT_EQ(summary["model"], roof());
    EXPECT_EQ(summary["files"], (json{"picture.png", "picture.depth.png"}));
    EXPECT_EQ(summary["camera"], metadata()["camera"]);
}

TEST_F(Render, WarnsOnceOfWhatIsNotDrawnUnlessQuiet) {
    const Outcome loud = render(asset("primitives.glb"));
    expectSuccess(loud);
    EXPECT_THAT(loud.error, StartsWith("inkedge: warning: "));
    EXPECT_THAT(loud.error, HasSubstr("primitives of points are not drawn"));
    EXPECT_EQ(std::ranges::count(loud.error, '\n'), 2) << "and one of lines";
    for (const char* flag : {"-q", "--quiet"}) {
        const Outcome quiet = render(asset("primitives.glb"), {flag});
        expectSuccess(quiet);
        EXPECT_EQ(quiet.error, "");
    }
    EXPECT_EQ(metadata()["warnings"].size(), 1U);
}

TEST_F(Render, VerboseNamesBackendRendererStagesAndFiles) {
    for (const char* flag : {"-v", "--verbose"}) {
        const Outcome outcome = render(roof(), {flag});
        expectSuccess(outcome);
        EXPECT_EQ(outcome.out, "");
        const json backend = metadata()["backend"];
        for (const char* text : {"backend", "platform", "renderer", "version"}) {
            EXPECT_THAT(outcome.error, HasSubstr(backend[text].get<std::string>())) << text;
        }
        EXPECT_THAT(outcome.error, HasSubstr("surface"));
        EXPECT_THAT(outcome.error, HasSubstr("wrote picture.png"));
    }
}

TEST_F(Render, DrawsWithEveryBackendThatWorks) {
    int drawn = 0;
    for (const char* backend : {"egl", "osmesa"}) {
        if (!works(backend)) {
            std::printf("[  SKIPPED ] Render.DrawsWithEveryBackendThatWorks: %s does not work here\n", backend);
            continue;
        }
        expectSuccess(render(roof(), {"--backend", backend}));
        EXPECT_EQ(metadata()["backend"]["backend"], backend);
        ++drawn;
    }
    EXPECT_GT(drawn, 0);
}

TEST_F(Render, FollowsALinkAndReplacesAnOlderPicture) {
    put(folder_ / "target.png", "an older picture");
    std::filesystem::create_symlink("target.png", folder_ / "picture.png");
    expectSuccess(render(roof()));
    EXPECT_TRUE(std::filesystem::is_symlink(folder_ / "picture.png"));
    EXPECT_EQ(decodePng(contents(folder_ / "target.png")).width, 48U);
}

}  // namespace
