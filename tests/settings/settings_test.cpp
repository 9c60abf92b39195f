#include <inkedge/setting_table.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <inkedge/error.h>

#include "base/expect_error.h"
#include "settings/setting_samples.h"

namespace inkedge::settings {
namespace {

using namespace setting_samples;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Not;
using testing::StrEq;

TEST(SettingTable, namesEachSettingOnce) {
    std::set<std::string_view> names;
    for (const SettingDescription& row : settingTable()) {
        EXPECT_THAT(row.name, Not(IsEmpty()));
        EXPECT_TRUE(names.insert(row.name).second) << row.name;
        if (!row.shortName.empty()) {
            EXPECT_TRUE(names.insert(row.shortName).second) << row.shortName;
        }
    }
    EXPECT_GE(settingTable().size(), 24U);
}

TEST(SettingTable, namesAreLowerCaseWordsJoinedByDashes) {
    for (const SettingDescription& row : settingTable()) {
        EXPECT_EQ(row.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz-"), std::string_view::npos) << row.name;
        EXPECT_NE(row.name.front(), '-');
        EXPECT_NE(row.name.back(), '-');
    }
}

TEST(SettingTable, describesEverySettingInOneLine) {
    for (const SettingDescription& row : settingTable()) {
        for (const std::string& text : {std::string{row.group}, row.values(), row.range(), std::string{row.help}}) {
            EXPECT_THAT(text, Not(IsEmpty())) << row.name;
        }
        for (const std::string& text : {row.values(), row.range(), row.defaultValue(), std::string{row.help}}) {
            EXPECT_EQ(text.find('\n'), std::string::npos) << row.name;
        }
    }
}

TEST(SettingTable, keepsTheSettingsOfAGroupTogether) {
    std::set<std::string_view> closed;
    std::string_view group;
    for (const SettingDescription& row : settingTable()) {
        if (row.group == group) continue;
        EXPECT_TRUE(closed.insert(row.group).second) << row.group << " opens twice, at " << row.name;
        group = row.group;
    }
}

TEST(SettingTable, givesBackEveryTextThatItTakes) {
    for (const SettingDescription& row : settingTable()) {
        for (const std::string& sample : samples(row)) {
            Settings settings;
            ASSERT_NO_THROW(set(settings, row.name, sample, "test")) << row.name << " " << sample;
            EXPECT_EQ(row.get(settings), sample) << row.name;
        }
    }
}

TEST(SettingTable, settingOneChangesNoOther) {
    for (const SettingDescription& row : settingTable()) {
        Settings settings;
        for (const std::string& sample : samples(row)) set(settings, row.name, sample, "test");
        for (const SettingDescription& other : settingTable()) {
            if (other.name == row.name) continue;
            EXPECT_EQ(other.get(settings), other.get(Settings{})) << row.name << " changes " << other.name;
        }
    }
}

TEST(SettingTable, takesItsOwnDefaults) {
    for (const SettingDescription& row : settingTable()) {
        const std::string before = row.get(Settings{});
        if (before.empty()) continue;  // not given
        Settings settings;
        for (const std::string& sample : samples(row)) set(settings, row.name, sample, "test");
        set(settings, row.name, before, "test");
        EXPECT_EQ(row.get(settings), before) << row.name;
    }
}

TEST(SettingTable, statesTheDefaultsInForce) {
    for (const SettingDescription& row : settingTable()) {
        const std::string inForce = row.get(Settings{});
        if (inForce.empty() || row.defaultValue() == "all") continue;  // said in words
        Settings stated;
        ASSERT_NO_THROW(set(stated, row.name, row.defaultValue(), "test")) << row.name;
        EXPECT_EQ(row.get(stated), inForce) << row.name;
    }
}

TEST(SettingTable, joinsTextsAsItTakesThem) {
    const auto joined = [](std::string_view name, const std::vector<std::string>& texts) {
        return findSetting(name)->joined(texts);
    };
    EXPECT_EQ(joined("size", {"640", "480"}), "640x480");
    EXPECT_EQ(joined("page-size", {"90mm", "60mm"}), "90mmx60mm");
    EXPECT_EQ(joined("scale", {"1", "2"}), "1:2");
    EXPECT_EQ(joined("eye", {"1", "2", "3"}), "1,2,3");
    EXPECT_EQ(joined("light", {"30", "35"}), "30,35");
    EXPECT_EQ(joined("maps", {"depth", "types"}), "depth,types");
    EXPECT_EQ(joined("only", {"arm", "leg"}), "arm;leg");
    EXPECT_EQ(joined("line-style", {"outline:width=2", "crease:width=1"}), "outline:width=2;crease:width=1");
    EXPECT_EQ(joined("lines", {}), "");
}

TEST(SettingTable, refusesWhatIsNoChoiceAndListsTheChoices) {
    for (const SettingDescription& row : settingTable()) {
        if (!isChoice(row) || isCount(row)) continue;
        std::string list;
        for (const std::string& choice : split(row.values(), '|')) list += (list.empty() ? "" : ", ") + choice;
        const bool one = list.find(',') == std::string::npos;
        expectRefusal(row.name, "Nonsense",
                      "--flag: expected " + (one ? list : "one of " + list) + ", found 'Nonsense'");
        expectRefusal(row.name, "", "--flag: expected " + (one ? list : "one of " + list) + ", found ''");
    }
}

TEST(Set, appliesEveryChoice) {
    EXPECT_EQ(with("normals", "auto").load.normals, Normals::Auto);
    EXPECT_EQ(with("normals", "authored").load.normals, Normals::Authored);
    EXPECT_EQ(with("normals", "flat").load.normals, Normals::Flat);
    EXPECT_EQ(with("detector", "classic").detector.detector, Detector::Classic);
    EXPECT_EQ(with("kernel", "sobel").detector.kernel, Kernel::Sobel);
    EXPECT_EQ(with("kernel", "farid").detector.kernel, Kernel::Farid);
    EXPECT_EQ(with("depth-map", "linear").detector.depthMap, DepthMap::Linear);
    EXPECT_EQ(with("depth-map", "window").detector.depthMap, DepthMap::Window);
    EXPECT_EQ(with("normal-lights", "single").detector.normalLights, NormalLights::Single);
    EXPECT_EQ(with("normal-lights", "two-pass").detector.normalLights, NormalLights::TwoPass);
    EXPECT_EQ(with("light-space", "camera").detector.lightSpace, LightSpace::Camera);
    EXPECT_EQ(with("light-space", "world").detector.lightSpace, LightSpace::World);
    EXPECT_EQ(with("normal-space", "camera").normalSpace, NormalSpace::Camera);
    EXPECT_EQ(with("normal-space", "world").normalSpace, NormalSpace::World);
    EXPECT_EQ(with("backend", "auto").backend.backend, Backend::Auto);
    EXPECT_EQ(with("backend", "egl").backend.backend, Backend::Egl);
    EXPECT_EQ(with("backend", "osmesa").backend.backend, Backend::Osmesa);
}

TEST(Set, fillsTheFieldThatTheNameSays) {
    EXPECT_THAT(with("maps", "edges,depth").maps, ElementsAre(Map::Edges, Map::Depth));
    EXPECT_EQ(with("size", "640x480").picture.size, (Size{640, 480}));
    EXPECT_EQ(with("size", "90x60mm").frame.size, (PictureExtent{90.0, 60.0, true}));
    EXPECT_EQ(with("size", "9cm").frame.size, (PictureExtent{90.0, 0.0, true}));
    EXPECT_EQ(with("size", "1inx2in").frame.size, (PictureExtent{25.4, 50.8, true}));
    EXPECT_EQ(with("size", "1063").frame.size, (PictureExtent{1063.0, 0.0, false}));
    EXPECT_EQ(with("crop", "2mm").frame.crop, (PictureLength{2.0, true}));
    EXPECT_EQ(with("scale", "1:2").frame.scale, 0.5);
    EXPECT_EQ(with("up", "-y").load.up, glm::dvec3(0, -1, 0));
    EXPECT_EQ(with("up", "Z").load.up, glm::dvec3(0, 0, 1));
    EXPECT_EQ(with("up", "0,3,4").load.up, glm::dvec3(0, 3, 4));
    EXPECT_THAT(with("only", "a;b").load.only, ElementsAre("a", "b"));
    EXPECT_EQ(with("view", "dimetric").camera.view, NamedView::Dimetric);
    EXPECT_EQ(with("background", "transparent").picture.background, std::nullopt);
    EXPECT_EQ(with("camera-position", "1,2,3").camera.position, glm::dvec3(1, 2, 3));
    EXPECT_EQ(with("camera-focal-point", "1,2,3").camera.focalPoint, glm::dvec3(1, 2, 3));
    EXPECT_EQ(with("camera-view-up", "1,2,3").camera.viewUp, glm::dvec3(1, 2, 3));
    EXPECT_EQ(with("camera-direction", "1,2,3").camera.direction, glm::dvec3(1, 2, 3));
    EXPECT_EQ(with("camera-view-angle", "50").camera.viewAngle, 50.0);
    EXPECT_EQ(with("camera-orthographic", "0").camera.orthographicHeight, 0.0);
    EXPECT_EQ(with("camera-azimuth-angle", "-400").camera.azimuthAngle, -400.0);
    EXPECT_EQ(with("camera-elevation-angle", "-90").camera.elevationAngle, -90.0);
    EXPECT_EQ(with("camera-index", "3").camera.index, 3);
    EXPECT_EQ(with("camera-zoom-factor", "2.5").camera.zoomFactor, 2.5);
    EXPECT_EQ(with("crease-angle", "180").load.creaseAngle, 180.0);
    EXPECT_EQ(with("depth-threshold", "0.25").detector.depthThreshold, 0.25F);
    EXPECT_EQ(with("normal-threshold", "0.25").detector.normalThreshold, 0.25F);
    EXPECT_EQ(with("device", "2").backend.device, 2);
}

TEST(Set, readsColorsInEveryForm) {
    EXPECT_EQ(with("line-color", "black").picture.lineColor, (Color{0, 0, 0}));
    EXPECT_EQ(with("line-color", "white").picture.lineColor, (Color{255, 255, 255}));
    EXPECT_EQ(with("line-color", "grey").picture.lineColor, (Color{128, 128, 128}));
    EXPECT_EQ(with("line-color", "red").picture.lineColor, (Color{255, 0, 0}));
    EXPECT_EQ(with("line-color", "green").picture.lineColor, (Color{0, 128, 0}));
    EXPECT_EQ(with("line-color", "blue").picture.lineColor, (Color{0, 0, 255}));
    EXPECT_EQ(with("line-color", "#1fC").picture.lineColor, (Color{0x11, 0xff, 0xcc}));
    EXPECT_EQ(with("line-color", "#01Ab9f").picture.lineColor, (Color{0x01, 0xab, 0x9f}));
    EXPECT_EQ(with("background", "none").picture.background, std::nullopt);
    EXPECT_EQ(with("background", "#102030").picture.background, (Color{0x10, 0x20, 0x30}));
}

TEST(Set, keepsTheOrderOfMapsAndDropsRepeats) {
    EXPECT_THAT(with("maps", "edges,depth,edges").maps, ElementsAre(Map::Edges, Map::Depth));
}

TEST(Set, refusesAnUnknownName) {
    Settings settings;
    expectError(Error::Kind::Usage, StrEq("inkedge.toml: linecolor: there is no setting named 'linecolor'; is it line-color?"),
                [&] { set(settings, "linecolor", "red", "inkedge.toml: linecolor"); });
    expectError(Error::Kind::Usage, StrEq("--x: there is no setting named ''"),
                [&] { set(settings, "", "red", "--x"); });
}

TEST(Set, refusesBadNumbers) {
    for (const std::string text : {"", " 1", "1 ", "one", "1,5", "nan", "inf", "1e999", "0x10", "--1"}) {
        expectRefusal("camera-azimuth-angle", text, "--flag: expected a number, found '" + text + "'");
    }
}

TEST(Set, refusesNumbersOutOfRange) {
    for (const std::string text : {"0", "-1", "-0"}) {
        expectRefusal("camera-zoom-factor", text,
                      "--flag: expected a number from 0.001 to 1000000, found '" + text + "'");
    }
    for (const std::string text : {"0", "180", "-35", "200"}) {
        expectRefusal("camera-view-angle", text, "--flag: expected a number from 0.001 to 179, found '" + text + "'");
    }
    for (const std::string text : {"-90.5", "91"}) {
        expectRefusal("camera-elevation-angle", text, "--flag: expected a number from -90 to 90, found '" + text + "'");
    }
    for (const std::string text : {"-1", "180.5"}) {
        expectRefusal("crease-angle", text, "--flag: expected a number from 0 to 180, found '" + text + "'");
    }
    for (const std::string name : {"subdivide", "subdivide-adaptive"}) {
        for (const std::string text : {"-1", "7", "1.5", "two"})
            expectRefusal(name, text, "--flag: expected a whole number from 0 to 6, found '" + text + "'");
    }
    for (const std::string name : {"depth-threshold", "normal-threshold"}) {
        expectRefusal(name, "-0.5", "--flag: expected a number from 0 to 1000000, found '-0.5'");
        expectRefusal(name, "2e6", "--flag: expected a number from 0 to 1000000, found '2e6'");
    }
    Settings settings;
    expectError(Error::Kind::Usage, testing::MatchesRegex("--flag: expected (0 or )?a number .*, found '-1'"),
                [&] { set(settings, "camera-orthographic", "-1", "--flag"); });
}

TEST(Set, refusesWhatIsNoWholeNumber) {
    for (const std::string name : {"camera-index", "device"}) {
        for (const std::string text : {"", "-1", "1.5", "1e3", "99999999999", "x"}) {
            expectRefusal(name, text, "--flag: expected a whole number from 0, found '" + text + "'");
        }
    }
}

TEST(Set, refusesWhatIsNoVector) {
    for (const std::string text : {"", "1", "1,2", "1,2,3,4", "1 2 3"}) {
        expectRefusal("camera-position", text, "--flag: expected three numbers x,y,z, found '" + text + "'");
    }
    for (const std::string text : {"1,2,", ",,", "1,b,3", "1,nan,3", "1, 2, 3"}) {
        expectRefusal("camera-position", text, "--flag: expected a number, found '" + text + "'");
    }
}

TEST(Set, refusesWhatIsNoSize) {
    for (const std::string text : {"", "640*480", "1x2x3", "640X480", "x", "640x", "x5", "-1x5", "1.5x2", "90mmx60"}) {
        expectRefusal("size", text,
                      "--flag: expected WIDTHxHEIGHT or WIDTH in pixels, as in 1024x768, or in mm, cm or in, as in "
                      "90x60mm or 90mm, found '" +
                          text + "'");
    }
    expectRefusal("size", "0mm", "--flag: expected a number over 0, found '0mm'");
    expectRefusal("size", "mm", "--flag: expected a number, found 'mm'");
    expectRefusal("size", "200000mm", "--flag: expected sides of at most 100000mm, found '200000mm'");
    for (const std::string text : {"0x0", "0x5", "5x0", "0", "5x99999999999", "5x99999999999999999999"}) {
        expectRefusal("size", text, "--flag: expected 1x1 to 32768x32768 pixels, found '" + text + "'");
    }
}

TEST(Set, refusesWhatIsNoAxisScaleOrMargin) {
    for (const std::string text : {"", "+", "up", "+Y+", "W"})
        expectRefusal("up", text, "--flag: expected an axis, as in +Z, or a direction x,y,z, found '" + text + "'");
    expectRefusal("up", "0,0,-0",
                  "--flag: expected an axis, as in +Z, or a direction other than 0,0,0, found '0,0,-0'");
    for (const std::string text : {"", "2", "1:2:3"})
        expectRefusal("scale", text,
                      "--flag: expected a length on paper and one of the model, as in 1:2, found '" + text + "'");
    expectRefusal("scale", "1:0", "--flag: expected a number from 1e-06 to 1000000, found '1:0'");
    expectRefusal("scale", "1000:0.000001", "--flag: expected 1:1000000 to 1000000:1, found '1000:0.000001'");
    expectRefusal("crop", "-1", "--flag: expected a number from 0 to 32768, found '-1'");
    expectRefusal("only", "a;;b", "--flag: expected names of nodes, found 'a;;b'");
    expectRefusal("line-style", "hidden:dash=3",
                  "--flag: expected dash=LENGTH:GAP in pixels, or in mm, as in dash=3mm:1.5mm, found 'hidden:dash=3'");
    expectRefusal("line-style", "hidden:dash=0:1", "--flag: expected dashes and gaps over 0, found 'hidden:dash=0:1'");
}

TEST(Set, namesDirectionsWithoutMinusZero) {
    EXPECT_EQ(got("camera-direction", with("camera-direction", "-0,0,-1")), "0,0,-1");
    EXPECT_EQ(got("up", with("up", "-0,-0,-1")), "-Z");
}

TEST(Set, refusesWhatIsNoColor) {
    for (const std::string name : {"line-color", "background"}) {
        for (const std::string text :
             {"", "Black", "#12", "#12345", "#12345678", "123456", "#12345g", "#+1-1f0", "rgb"}) {
            expectRefusal(name, text,
                          "--flag: expected a colour #RGB, #RRGGBB, black, white, grey, red, green or blue, found '" +
                              text + "'");
        }
    }
    EXPECT_THROW(with("line-color", "none"), Error);  // only the background may be missing
}

TEST(Set, refusesUnknownMaps) {
    const auto row = std::ranges::find(settingTable(), "maps", &SettingDescription::name);
    for (const std::string text : {"", "depth,", "depth,curvature"})
        expectRefusal("maps", text, "--flag: expected one of " + row->range() + ", found '" + text + "'");
    expectRefusal("maps", "Depth", "--flag: expected one of " + row->range() + ", found 'Depth'; is it depth?");
}

TEST(Set, leavesTheSettingsAloneWhenItRefuses) {
    for (const SettingDescription& row : settingTable()) {
        if (row.values() == "NAME|N" || row.values() == "NAME" || row.values() == "FILE") continue;  // take any text
        Settings settings;
        set(settings, row.name, samples(row).back(), "test");
        EXPECT_THROW(set(settings, row.name, "!", "test"), Error) << row.name;
        EXPECT_EQ(row.get(settings), samples(row).back()) << row.name;
    }
}

TEST(SettingDescription, refusesATextWithTheLibrarysError) {
    Settings settings;
    const auto row = std::ranges::find(settingTable(), "sumi-width", &SettingDescription::name);
    expectError(Error::Kind::Usage, StrEq("expected a number from 1 to 32, found '33'"),
                [&] { row->set(settings, "33"); });
    EXPECT_EQ(settings.style.sumiWidth, Settings{}.style.sumiWidth);
}

// Texts just beyond each end of a row's range, and at it.
TEST(SettingTable, holdsTextsToTheLimitsOfTheirConstraints) {
    int held = 0;
    for (const SettingDescription& row : settingTable()) {
        if (const auto* const number = std::get_if<Number>(&row.constraint); number != nullptr) {
            for (const double end : {number->min, number->max}) {
                if (!std::isfinite(end) || end == std::numeric_limits<double>::max()) continue;
                Settings settings;
                const double beyond = std::nextafter(end, end == number->min ? -1e300 : 1e300);
                EXPECT_EQ(throwsError([&] { row.set(settings, fmt::format("{}", end)); }), number->open) << row.name;
                EXPECT_TRUE(throwsError([&] { row.set(settings, fmt::format("{}", beyond)); })) << row.name;
                ++held;
            }
        }
        if (const auto* const count = std::get_if<Count>(&row.constraint); count != nullptr) {
            Settings settings;
            EXPECT_NO_THROW(row.set(settings, fmt::format("{}", count->choices.empty() ? count->min : 1))) << row.name;
            EXPECT_TRUE(throwsError([&] { row.set(settings, fmt::format("{}", count->max + 1)); })) << row.name;
            EXPECT_TRUE(throwsError([&] { row.set(settings, "-1"); })) << row.name;
            ++held;
        }
    }
    EXPECT_GT(held, 40);
}

TEST(Name, ofEveryMapIsItsNameInTheTable) {
    std::vector<Map> all;
    std::string names;
    for (int i = 0; i < mapCount; ++i) {
        all.push_back(static_cast<Map>(i));
        names += (i == 0 ? "" : ",") + std::string{name(static_cast<Map>(i))};
    }
    EXPECT_THAT(names, testing::StartsWith("depth,normal,depth-edges,normal-edges,edges"));
    EXPECT_EQ(with("maps", names).maps, all);
}

}  // namespace
}  // namespace inkedge::settings
