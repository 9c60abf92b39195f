// Every row of the settings table: its flag, second name, environment variable and configuration key.
#include <map>

#include <inkedge/setting_table.h>

#include "cli/command.h"

namespace {

using nlohmann::json;
using testing::HasSubstr;

struct Example {
    std::string value;
    std::string wrong;         ///< a value that must be refused; empty: there is none
    std::string shows;         ///< where it shows: a pointer into the metadata, or a file beside it
    std::string becomes = {};  ///< what stands there then; empty: something else than without the flag
    Arguments beside = {};     ///< flags in both runs
    std::string needs = {};    ///< a backend
    std::string asset = {};    ///< to draw; empty: a roof
};

// Limits change nothing that they let pass; load_gltf_features_test.cpp shows what they refuse.
Example limitExample(const std::string& name, const std::string& value, const std::string& wrong) {
    const char unit = value.back();
    const std::string zeros = unit == 'k' ? "000" : unit == 'M' ? "000000" : "000000000";
    return {.value = value,
            .wrong = wrong,
            .shows = "/settings/" + name,
            .becomes = '"' + value.substr(0, value.size() - 1) + zeros + '"'};
}

const std::map<std::string_view, Example>& examples() {
    const Arguments hatched{"--style", "hatch"};
    static const std::map<std::string_view, Example> all{
        {"maps", {.value = "depth,edges", .wrong = "depth,colour", .shows = "picture.depth.png"}},
        {"size", {.value = "40x30", .wrong = "40x", .shows = "/size", .becomes = "[40,30]"}},
        {"crop", {.value = "4", .wrong = "-1", .shows = "/size"}},
        {"scale", {.value = "1:500", .wrong = "2", .shows = "/camera/orthographic_height"}},
        {"line-color", {.value = "#f00", .wrong = "#f0", .shows = "picture.png"}},
        {"background", {.value = "grey", .wrong = "nothing", .shows = "picture.png"}},
        {"line-width", {.value = "4", .wrong = "0.1", .shows = "picture.png", .beside = {"--detector", "planes"}}},
        {"dpi",
         {.value = "300",
          .wrong = "0",
          .shows = "picture.png",
          .beside = {"--detector", "planes", "--line-width", "0.4mm"}}},
        {"tile-size", {.value = "256", .wrong = "255", .shows = "/settings/tile-size", .becomes = "\"256\""}},
        {"supersampling", {.value = "2", .wrong = "3", .shows = "picture.png", .beside = {"--detector", "planes"}}},
        {"lines",
         {.value = "outline,boundary",
          .wrong = "hatching",
          .shows = "picture.png",
          .beside = {"--detector", "planes"}}},
        {"line-style",
         {.value = "crease:width=3,color=#555",
          .wrong = "crease:color=#5",
          .shows = "picture.png",
          .beside = {"--detector", "planes"}}},
        {"lines-from", {.value = "image", .wrong = "scene", .shows = "/settings/lines-from", .becomes = "\"image\""}},
        {"contour", {.value = "smooth", .wrong = "round", .shows = "/settings/contour", .becomes = "\"smooth\""}},
        {"hidden", {.value = "dashed", .wrong = "dotted", .shows = "/settings/hidden", .becomes = "\"dashed\""}},
        {"coincident", {.value = "keep", .wrong = "all", .shows = "/settings/coincident", .becomes = "\"keep\""}},
        {"page-size",
         {.value = "A4-landscape", .wrong = "210x297", .shows = "/settings/page-size", .becomes = "\"297mmx210mm\""}},
        {"contour-finder",
         {.value = "random", .wrong = "all", .shows = "/settings/contour-finder", .becomes = "\"random\""}},
        {"stroke-width",
         {.value = "depth", .wrong = "thick", .shows = "/settings/stroke-width", .becomes = "\"depth\""}},
        {"stroke-taper", {.value = "20", .wrong = "-1", .shows = "/settings/stroke-taper", .becomes = "\"20\""}},
        {"brush", {.value = "dry.png", .wrong = "", .shows = "/settings/brush", .becomes = "\"dry.png\""}},
        {"simplify", {.value = "0.5", .wrong = "-1", .shows = "/settings/simplify", .becomes = "\"0.5\""}},
        {"fit-curves", {.value = "0.3", .wrong = "0.001", .shows = "/settings/fit-curves", .becomes = "\"0.3\""}},
        {"feature-size",
         {.value = "5",
          .wrong = "0",
          .shows = "/settings/feature-size",
          .becomes = "\"5\"",
          .beside = {"--lines", "standard,ridge"}}},
        {"suggestive-threshold",
         {.value = "0.5",
          .wrong = "-1",
          .shows = "/settings/suggestive-threshold",
          .becomes = "\"0.5\"",
          .beside = {"--lines", "standard,suggestive"}}},
        {"ridge-threshold",
         {.value = "0.5",
          .wrong = "101",
          .shows = "/settings/ridge-threshold",
          .becomes = "\"0.5\"",
          .beside = {"--lines", "standard,valley"}}},
        {"apparent-threshold",
         {.value = "0.5",
          .wrong = "x",
          .shows = "/settings/apparent-threshold",
          .becomes = "\"0.5\"",
          .beside = {"--lines", "standard,apparent"}}},
        {"isolines", {.value = "u:8,v:4", .wrong = "8.5", .shows = "/settings/isolines", .becomes = "\"u:8,v:4\""}},
        {"camera-position", {.value = "-4,3,2", .wrong = "-4,3", .shows = "/camera/eye", .becomes = "[-4.0,3.0,2.0]"}},
        {"camera-focal-point", {.value = "0.5,0,0", .wrong = "0.5,0,x", .shows = "/camera/view"}},
        {"camera-view-up", {.value = "1,0,0", .wrong = "up", .shows = "/camera/view"}},
        {"view", {.value = "right", .wrong = "side", .shows = "/camera/view"}},
        {"framing", {.value = "together", .wrong = "all", .shows = "/settings/framing", .becomes = "\"together\""}},
        {"camera-view-angle", {.value = "60", .wrong = "180", .shows = "/camera/view_angle", .becomes = "60.0"}},
        {"camera-orthographic",
         {.value = "3", .wrong = "-1", .shows = "/camera/orthographic_height", .becomes = "3.0"}},
        {"camera-direction", {.value = "-1,-1,-2", .wrong = "1,2,nan", .shows = "/camera/view"}},
        {"camera-azimuth-angle", {.value = "-70", .wrong = "north", .shows = "/camera/view"}},
        {"camera-elevation-angle", {.value = "55", .wrong = "91", .shows = "/camera/view"}},
        {"camera-index", {.value = "0", .wrong = "-1", .shows = "/camera/eye", .becomes = "[0.0,0.2,5.0]"}},
        {"camera-zoom-factor", {.value = "2", .wrong = "0", .shows = "/camera/projection"}},
        {"normals",
         {.value = "flat", .wrong = "smooth", .shows = "picture.normal.png", .beside = {"--crease-angle", "60"}}},
        {"creases",
         {.value = "angle",
          .wrong = "edges",
          .shows = "picture.png",
          .beside = {"--detector", "planes"},
          .asset = "teapot"}},
        {"crease-angle", {.value = "60", .wrong = "181", .shows = "picture.normal.png"}},
        {"subdivide", {.value = "2", .wrong = "7", .shows = "/triangles"}},
        {"subdivide-adaptive",
         {.value = "3", .wrong = "-1", .shows = "/settings/subdivide-adaptive", .becomes = "\"3\""}},
        {"unit", {.value = "in", .wrong = "inches", .shows = "/settings/unit", .becomes = "\"in\""}},
        {"up", {.value = "+Z", .wrong = "up", .shows = "/camera/view"}},
        {"only", {.value = "leaf;cup", .wrong = "", .shows = "/triangles", .asset = "lantern"}},
        {"hide", {.value = "cup", .wrong = "", .shows = "/triangles", .asset = "lantern"}},
        {"scene", {.value = "1", .wrong = "-1", .shows = "/bounds", .asset = "lantern"}},
        {"animation",
         {.value = "swing", .wrong = "", .shows = "/bounds", .beside = {"--time", "1"}, .asset = "lantern"}},
        {"time",
         {.value = "0.5", .wrong = "-1", .shows = "/bounds", .beside = {"--animation", "swing"}, .asset = "lantern"}},
        {"transparent", {.value = "ignore", .wrong = "yes", .shows = "/triangles", .asset = "lantern"}},
        {"alpha-mask", {.value = "ignore", .wrong = "yes", .shows = "/triangles", .asset = "lantern"}},
        {"back-faces", {.value = "material", .wrong = "cull", .shows = "picture.png", .asset = "lantern"}},
        {"max-file-size", limitExample("max-file-size", "1G", "0")},
        {"max-decompressed-size", limitExample("max-decompressed-size", "1G", "1T")},
        {"max-vertices", limitExample("max-vertices", "1M", "5000000000")},
        {"max-instances", limitExample("max-instances", "1k", "many")},
        {"max-nodes", limitExample("max-nodes", "1k", "-1")},
        {"max-node-depth", limitExample("max-node-depth", "1k", "1.5")},
        {"max-image-pixels", limitExample("max-image-pixels", "1M", "1 M")},
        {"max-reading-time", {.value = "60", .wrong = "0", .shows = "/settings/max-reading-time", .becomes = "\"60\""}},
        {"tolerance", {.value = "1", .wrong = "0", .shows = "/settings/tolerance", .becomes = "\"1\""}},
        {"function",
         {.value = "height:levels=4;depth",
          .wrong = "colour",
          .shows = "picture.edges.png",
          .beside = {"--detector", "none"}}},
        {"style", {.value = "hatch", .wrong = "ink pen", .shows = "picture.png", .asset = "statue"}},
        {"hatch-bend", {.value = "40", .wrong = "0", .shows = "picture.png", .beside = hatched, .asset = "statue"}},
        {"hatch-shade", {.value = "0.2", .wrong = "1.1", .shows = "picture.png", .beside = hatched, .asset = "statue"}},
        {"hatch-width", {.value = "2", .wrong = "0.1", .shows = "picture.png", .beside = hatched, .asset = "statue"}},
        {"shade", {.value = "light", .wrong = "dark", .shows = "picture.png"}},
        {"light", {.value = "80,10", .wrong = "80", .shows = "picture.png", .beside = {"--shade", "gooch"}}},
        {"path-order", {.value = "travel", .wrong = "short", .shows = "/settings/path-order", .becomes = "\"travel\""}},
        {"sumi-width", {.value = "3", .wrong = "0", .shows = "picture.png", .beside = {"--style", "sumi"}}},
        {"sumi-length", {.value = "5", .wrong = "-1", .shows = "picture.png", .beside = {"--style", "sumi"}}},
        {"sumi-streaks", {.value = "16", .wrong = "0.5", .shows = "picture.png", .beside = {"--style", "sumi"}}},
        {"pencil-strokes", {.value = "1", .wrong = "0", .shows = "picture.png", .beside = {"--style", "pencil"}}},
        {"pencil-looseness", {.value = "8", .wrong = "33", .shows = "picture.png", .beside = {"--style", "pencil"}}},
        {"pencil-seed", {.value = "7", .wrong = "-1", .shows = "picture.png", .beside = {"--style", "pencil"}}},
        {"profile-limit",
         {.value = "2", .wrong = "0", .shows = "picture.png", .beside = {"--detector", "saito-takahashi"}}},
        {"edge-limit",
         {.value = "0.05", .wrong = "-1", .shows = "picture.png", .beside = {"--detector", "saito-takahashi"}}},
        {"detector", {.value = "classic", .wrong = "sobel", .shows = "/settings/detector", .becomes = "\"classic\""}},
        {"kernel", {.value = "farid", .wrong = "5x5", .shows = "picture.edges.png"}},
        {"depth-map",
         {.value = "window", .wrong = "z", .shows = "picture.depth-edges.png", .beside = {"--depth-threshold", "0.5"}}},
        {"depth-threshold", {.value = "0", .wrong = "-0.1", .shows = "picture.depth-edges.png"}},
        {"normal-threshold", {.value = "0", .wrong = "low", .shows = "picture.normal-edges.png"}},
        {"normal-lights",
         {.value = "two-pass", .wrong = "2", .shows = "picture.normal.png", .beside = {"--crease-angle", "60"}}},
        {"light-space",
         {.value = "world",
          .wrong = "object",
          .shows = "picture.normal-edges.png",
          .beside = {"--normal-threshold", "1"},
          .asset = "teapot"}},
        {"normal-space", {.value = "world", .wrong = "view", .shows = "picture.normal.png"}},
        {"backend",
         {.value = "osmesa", .wrong = "glx", .shows = "/backend/backend", .becomes = "\"osmesa\"", .needs = "osmesa"}},
        {"device",
         {.value = "0", .wrong = "first", .shows = "/backend/platform", .becomes = "\"device 0\"", .needs = "egl"}},
    };
    return all;
}

TEST(SettingsFlags, NoExampleIsLeftOverFromASettingThatIsGone) {
    for (const auto& [name, example] : examples()) {
        EXPECT_THAT(inkedge::settingTable(),
                    testing::Contains(testing::Field(&inkedge::SettingDescription::name, name)));
    }
}

std::vector<std::string> settingNames() {
    std::vector<std::string> names;
    for (const auto& row : inkedge::settingTable()) names.emplace_back(row.name);
    return names;
}

// Equal but for the rounding of numbers.
bool isAbout(const json& found, const json& expected) {
    if (found.is_number() && expected.is_number()) return std::abs(found.get<double>() - expected.get<double>()) < 1e-9;
    if (!found.is_array() || !expected.is_array()) return found == expected;
    return std::ranges::equal(found, expected, isAbout);
}

class EverySetting : public Command, public testing::WithParamInterface<std::string> {
protected:
    void SetUp() override {
        ASSERT_TRUE(examples().contains(name())) << "a new setting needs an example above";
        example_ = examples().at(name());
    }

    static const std::string& name() { return GetParam(); }
    static std::string flag() { return "--" + name(); }
    static const inkedge::SettingDescription& row() {
        return *std::ranges::find(inkedge::settingTable(), name(), &inkedge::SettingDescription::name);
    }

    [[nodiscard]] std::string drawn() const { return example_.asset.empty() ? roof() : asset(example_.asset + ".glb"); }

    /// What stands where the example shows, after a run with these flags besides.
    std::string shown(Arguments flags) const {
        flags.insert(flags.end(), example_.beside.begin(), example_.beside.end());
        if (name() != "maps") flags.insert(flags.end(), {"--maps", everyMap()});
        expectSuccess(render(drawn(), flags));
        if (example_.shows.front() != '/') return contents(folder_ / example_.shows);
        return metadata().value(json::json_pointer{example_.shows}, json{}).dump();
    }

    Example example_;
};

TEST_P(EverySetting, ShowsItsEffect) {
    if (!example_.needs.empty() && !works(example_.needs)) GTEST_SKIP() << example_.needs << " does not work here";
    const std::string without = shown({});
    const std::string with = shown({flag(), example_.value});
    if (example_.becomes.empty()) {
        EXPECT_TRUE(with != without) << example_.shows << " is the same with " << flag() << ' ' << example_.value;
    } else {
        EXPECT_TRUE(isAbout(json::parse(with), json::parse(example_.becomes))) << with;
    }
}

TEST_P(EverySetting, IsNamedWithTheValueThatIsWrong) {
    const auto message = [&](const std::string& source) {
        return testing::AllOf(testing::StartsWith("inkedge: error: " + source + ": expected "),
                              HasSubstr(", found '" + example_.wrong + "'"));
    };
    const std::string& wrong = example_.wrong;
    if (wrong.empty()) {
        inkedge::Settings settings;
        EXPECT_NO_THROW(inkedge::set(settings, name(), "*, any text: it may be right", "a test"));
        return;
    }
    expectFailure(render(roof(), {flag() + "=" + wrong}), 2, message(flag()));
    if (!row().shortName.empty()) {
        expectFailure(render(roof(), {"--" + std::string{row().shortName} + "=" + wrong}), 2, message(flag()));
    }

    std::string variable = "INKEDGE_" + name();
    std::ranges::transform(variable, variable.begin(),
                           [](unsigned char c) { return c == '-' ? '_' : static_cast<char>(std::toupper(c)); });
    // --size and --detector, which render() gives, come after the environment and are right: the wrong one is refused
    // even so.
    expectFailure(render(roof(), {}, {{variable, wrong}}), 2, message(variable));

    const std::string config = file("inkedge.conf", "# a comment\n\n" + name() + " = " + wrong + "\n");
    expectFailure(render(roof(), {"--config", config}), 2, message(config + ":3: " + name()));
    EXPECT_THAT(folder_.names(), testing::IsEmpty());
}

TEST_P(EverySetting, StandsInTheHelp) {
    const std::string help = run({"render", "--help"}).out;
    EXPECT_THAT(help, HasSubstr(flag()));
    EXPECT_THAT(help, HasSubstr(std::string{row().help}));
}

TEST_P(EverySetting, StandsInTheMetadataAsTextThatTheFlagTakes) {
    if (!example_.needs.empty() && !works(example_.needs)) GTEST_SKIP() << example_.needs << " does not work here";
    Arguments flags = example_.beside;
    flags.insert(flags.end(), {flag(), example_.value});
    expectSuccess(render(drawn(), flags));
    const auto text = metadata().at("settings").at(name()).get<std::string>();
    flags = example_.beside;
    flags.push_back(flag() + "=" + text);
    expectSuccess(render(drawn(), flags));
    EXPECT_EQ(metadata().at("settings").at(name()).get<std::string>(), text);
}

INSTANTIATE_TEST_SUITE_P(Table, EverySetting, testing::ValuesIn(settingNames()), [](const auto& test) {
    std::string name = test.param;
    std::ranges::replace(name, '-', '_');
    return name;
});

class SettingsSources : public Command {};

TEST_F(SettingsSources, FlagBeatsEnvironmentBeatsConfigurationBeatsPresetBeatsDefault) {
    const auto background = [&](const Arguments& flags, const Environment& environment = {}) {
        expectSuccess(render(roof(), flags, environment));
        return metadata().at("settings").at("background").get<std::string>();
    };
    const std::string config = file("inkedge.conf", "background = #ff0000\n");
    const Environment green{{"INKEDGE_BACKGROUND", "green"}};

    EXPECT_EQ(background({}), "#ffffff");
    EXPECT_EQ(background({"--preset", "blueprint"}), "#1f4e8c");
    EXPECT_EQ(background({"--preset", "blueprint", "--config", config}), "#ff0000");
    EXPECT_EQ(background({"--preset", "blueprint", "--config", config}, green), "#008000");
    EXPECT_EQ(background({"--preset", "blueprint", "--config", config, "--background", "blue"}, green), "#0000ff");
}

TEST_F(SettingsSources, EveryPresetRenders) {
    for (const inkedge::Preset& preset : inkedge::presets()) {
        expectSuccess(render(roof(), {"--preset", std::string{preset.name}}));
    }
}

TEST_F(SettingsSources, PrintConfigSaysWhatAPresetGivesAndDrawsNothing) {
    const Outcome plotter = run({"render", "--preset", "plotter", "--line-width", "0.5mm", "--print-config"});
    expectSuccess(plotter);
    EXPECT_EQ(plotter.out, "background = none\nline-width = 0.5mm\nlines-from = object\npath-order = travel\n");
    EXPECT_EQ(run({"render", roof(), "-o", "a.png", "--print-config"}).out, "");
    EXPECT_THAT(folder_.names(), testing::IsEmpty());
    const std::string config = file("plotter.conf", plotter.out);
    EXPECT_EQ(run({"render", "--config", config, "--print-config"}).out, plotter.out);
    expectFailure(run({"render", "--preset", "pencil", "--print-config"}), 2, HasSubstr("--preset: expected one of "));
}

TEST_F(SettingsSources, ConfigurationTakesQuotesCommentsAndWindowsLines) {
    const std::string config =
        file("inkedge.conf", "# colours\r\n  line-color = \"#123456\"\r\n\r\nmaps=depth,normal\r\nkernel = farid");
    expectSuccess(render(roof(), {"--config", config}));
    EXPECT_EQ(metadata().at("settings").at("line-color"), "#123456");
    EXPECT_EQ(metadata().at("settings").at("maps"), "depth,normal");
    EXPECT_EQ(metadata().at("settings").at("kernel"), "farid");
}

TEST_F(SettingsSources, UnknownPresetsAndKeysAndUnreadableConfigurationsAreRefused) {
    expectFailure(render(roof(), {"--preset", "pencil"}), 2, HasSubstr("--preset: expected one of paper, "));
    expectFailure(render(roof(), {"--config", file("a.conf", "colour = red\n")}), 2,
                  HasSubstr("a.conf:1: expected the name of a setting, found 'colour'"));
    expectFailure(render(roof(), {"--config", file("b.conf", "size 3x3\n")}), 2,
                  HasSubstr("b.conf:1: expected name = value, found 'size 3x3'"));
    expectFailure(render(roof(), {"--config", "missing.conf"}), 3, HasSubstr("missing.conf: "));
    expectFailure(render(roof(), {"--config", models_.path()}), 3, HasSubstr(models_.path().string()));
    EXPECT_THAT(folder_.names(), testing::IsEmpty());
}

TEST_F(SettingsSources, NegativeVectorsNeedNoEqualsSign) {
    for (const Arguments& eye : {Arguments{"--eye", "-1,2,3"}, Arguments{"--eye=-1,2,3"}}) {
        expectSuccess(render(roof(), eye));
        EXPECT_TRUE(isAbout(metadata().at("camera").at("eye"), json{-1.0, 2.0, 3.0})) << eye.front();
    }
}

}  // namespace
