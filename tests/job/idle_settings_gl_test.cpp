// A setting that cannot act says so, and one that says so does not act: every row of the table, on every kind of output
// and beside the settings that decide what is drawn.
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <inkedge/encode_png.h>
#include <inkedge/job.h>
#include <inkedge/setting_table.h>
#include <inkedge/write.h>

#include "base/temporary_folder.h"
#include "gl/gl_test.h"
#include "mesh/curved_shapes.h"
#include "scenes.h"

namespace inkedge::job {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using Values = std::vector<std::pair<std::string, std::string>>;

// What is drawn beside the setting that is tried.
struct Beside {
    std::string name;
    Values values;
    OutputKinds kinds;
};

const std::vector<Beside>& surroundings() {
    static const OutputKinds picture{.pictures = true};
    static const OutputKinds svg{.vectors = true};
    static const OutputKinds dxf{.dxf = true};
    static const OutputKinds json{.json = true};
    static const OutputKinds both{.pictures = true, .vectors = true};
    static const std::vector<Beside> all{
        {"planes", {}, picture},
        {"planes with maps", {{"maps", "types,normal"}}, picture},
        {"classic", {{"detector", "classic"}}, picture},
        {"classic with edges", {{"detector", "classic"}, {"lines-from", "object"}, {"maps", "edges"}}, picture},
        {"profiles", {{"detector", "saito-takahashi"}}, picture},
        {"object", {{"lines-from", "object"}}, picture},
        {"hidden", {{"hidden", "dashed"}}, picture},
        {"form",
         {{"lines", "all"},
          {"lines-from", "object"},
          {"feature-size", "4"},
          {"suggestive-threshold", "0.02"},
          {"ridge-threshold", "0.02"},
          {"apparent-threshold", "0.02"}},
         picture},
        {"form from image",
         {{"lines", "all"},
          {"suggestive-threshold", "0.02"},
          {"ridge-threshold", "0.02"},
          {"apparent-threshold", "0.02"}},
         picture},
        {"image", {{"lines-from", "image"}}, picture},
        {"hatch", {{"style", "hatch"}}, picture},
        {"sumi", {{"style", "sumi"}}, picture},
        {"pencil", {{"style", "pencil"}}, picture},
        {"no lines", {{"style", "none"}, {"shade", "light"}}, picture},
        {"shade", {{"shade", "gooch"}}, picture},
        {"map of the shade", {{"maps", "shade"}}, picture},
        {"fattened", {{"detector", "raskar-cohen"}}, picture},
        {"function", {{"function", "height"}, {"lines-from", "object"}}, picture},
        {"orthographic", {{"camera-orthographic", "0"}}, picture},
        {"svg", {}, svg},
        {"tapered svg", {{"stroke-taper", "5"}}, svg},
        {"svg with hidden lines", {{"hidden", "dashed"}}, svg},
        {"svg with shade", {{"shade", "light"}}, svg},
        {"svg from image", {{"lines-from", "image"}}, svg},
        {"svg and picture", {}, both},
        {"dxf", {}, dxf},
        {"dxf of an orthographic view", {{"camera-orthographic", "0"}, {"hidden", "dashed"}}, dxf},
        {"tapered dxf", {{"stroke-taper", "5"}}, dxf},
        {"json", {}, json},
        {"json from image", {{"lines-from", "image"}}, json},
    };
    return all;
}

// A value other than the default that shows wherever it acts on the scene below.
std::map<std::string_view, std::string> samples(const std::string& brush) {
    return {{"maps", "depth"},
            {"size", "72x40"},
            {"crop", "3"},
            {"scale", "3:1"},
            {"line-color", "#a02000"},
            {"background", "#e0f0c0"},
            {"line-width", "3"},
            {"dpi", "200"},
            {"page-size", "A6"},
            {"supersampling", "2"},
            {"lines", "outline,occlusion"},
            {"line-style", "outline:width=4;hidden:width=1.5"},
            {"contour", "smooth"},
            {"hidden", "solid"},
            {"coincident", "keep"},
            {"stroke-width", "depth"},
            {"stroke-taper", "12"},
            {"brush", brush},
            {"simplify", "4"},
            {"fit-curves", "0.5"},
            {"subdivide-adaptive", "2"},
            {"isolines", "3"},
            {"feature-size", "20"},
            {"suggestive-threshold", "90"},
            {"ridge-threshold", "90"},
            {"apparent-threshold", "90"},
            {"style", "pencil"},
            {"shade", "flat"},
            {"light", "60,-20"},
            {"path-order", "travel"},
            {"hatch-bend", "60"},
            {"hatch-shade", "0"},
            {"hatch-width", "2"},
            {"sumi-width", "2"},
            {"sumi-length", "3"},
            {"sumi-streaks", "3"},
            {"pencil-strokes", "1"},
            {"pencil-looseness", "9"},
            {"pencil-seed", "7"},
            {"camera-position", "4,5,6"},
            {"camera-focal-point", "0.5,0,0"},
            {"camera-view-up", "1,1,0"},
            {"camera-view-angle", "60"},
            {"camera-orthographic", "3"},
            {"camera-direction", "-1,-1,-2"},
            {"view", "front"},
            {"framing", "together"},
            {"camera-azimuth-angle", "70"},
            {"camera-elevation-angle", "55"},
            {"camera-index", "0"},
            {"camera-zoom-factor", "2"},
            {"detector", "classic"},
            {"kernel", "farid"},
            {"depth-map", "window"},
            {"depth-threshold", "0"},
            {"normal-threshold", "0"},
            {"normal-lights", "two-pass"},
            {"light-space", "world"},
            {"normal-space", "world"},
            {"profile-limit", "1"},
            {"edge-limit", "0.01"},
            {"function", "height:levels=5"}};
}

// They choose between ways to one picture.
const std::set<std::string_view> unseen{"tile-size", "contour-finder", "lines-from", "backend", "device"};
// They are refused with files of lines alone.
const std::set<std::string_view> forPictures{"maps", "style", "function"};
// They act where there is something to act on, which is not in every drawing of the scene below: coincident lines cover
// each other in a picture, lines whose hidden parts are drawn have no free ends, and two passes of light round only.
const std::set<std::string_view> oftenUnseen{"coincident", "stroke-taper", "normal-lights"};
// They act on the scene, whatever is drawn of it; settings_flags_test shows how.
const std::set<std::string_view> ofTheScene{"model", "limits"};

// A sphere, shaded smooth, two boxes that touch, a sheet with texture coordinates, and one with a dent.
Scene scene() {
    Scene::Data data;
    Mesh sheet = scenes::quad({-1.5, -1, 1}, {0, -1, 1.2}, {0, 0.2, 1}, {-1.5, 0.2, 1});
    sheet.textureCoordinates = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    const Mesh dented = curved::sheet(14, [](double x, double y) { return -0.5 * std::exp(-4.0 * (x * x + y * y)); });
    data.meshes = {scenes::sphere(0.8, 12), scenes::cube(1.0), sheet, dented};
    data.instances = {{"ball", 0, scenes::translation({0.3, 0.9, 0})},
                      {"left", 1, scenes::translation({-0.5, -0.5, 0})},
                      {"right", 1, scenes::translation({0.5, -0.5, 0})},
                      {"sheet", 2, glm::dmat4{1.0}},
                      {"dented", 3, scenes::translation({-1.1, 0.8, 0.3}) * scenes::scaling(glm::dvec3{0.4})}};
    data.cameras = {{"ahead", scenes::translation({0, 0, 6}), 50.0, 0.0}};
    LoadSettings settings;
    settings.textureCoordinates = true;
    return Scene{std::move(data), settings};
}

class IdleSettings : public testing::Test {
protected:
    void SetUp() override {
        for (const Backend backend : {Backend::Egl, Backend::Osmesa}) {
            gl_test::Equipment* const equipment = gl_test::Backends::instance().equipment(backend);
            if (equipment == nullptr) continue;
            renderer_ = &equipment->renderer;
            break;
        }
        if (renderer_ == nullptr) GTEST_SKIP() << "no backend works here";
        Image<std::uint8_t> brush{{8, 4}, 1, std::uint8_t{255}};
        for (int x = 0; x < 5; ++x) brush(x, 1) = 0;
        const std::vector<std::uint8_t> png = encodePng(brush);
        put(brush_, {png.begin(), png.end()});
    }

    static Settings settingsOf(const Values& values) {
        Settings settings;
        settings.picture.size = {64, 48};
        settings.detector.depthThreshold.reset();
        for (const auto& [name, text] : values) set(settings, name, text, "test");
        return settings;
    }

    // Everything that is written with these settings, but for what repeats the settings.
    std::string written(const Settings& settings, const OutputKinds& kinds) const {
        const View view{"0", settings.camera};
        const FramedView framed = frameViews(scene_, {&view, 1}, settings).front();
        Settings resolved = settings;
        resolved.picture = framed.picture;
        std::string all;
        if (kinds.pictures) {
            const Maps maps = renderer_->render(scene_, framed.camera, resolved);
            const std::string file = folder_ / "picture.png";
            for (const auto& each : writeMaps(maps, settings.maps, file)) all += each.string() + contents(each);
        }
        if (!kinds.vectors && !kinds.dxf && !kinds.json) return all;
        const Lines lines = renderer_->lines(scene_, framed.camera, resolved);
        if (kinds.vectors) {
            const std::string svg = linesSvg(lines, resolved);
            const std::size_t from = svg.find("<metadata>");
            all += svg.substr(0, from) + svg.substr(svg.find("</metadata>"));
        }
        if (kinds.dxf) all += linesDxf(lines, resolved);
        if (kinds.json) {
            auto json = nlohmann::json::parse(linesJson(lines, resolved));
            json.erase("settings");
            all += json.dump();
        }
        return all;
    }

    static std::string idleLine(std::string_view name, const Settings& settings, const OutputKinds& kinds) {
        for (const std::string& line : idleSettings(settings, kinds))
            if (line.starts_with("--" + std::string{name} + " does nothing: ")) return line;
        return {};
    }

    Renderer* renderer_ = nullptr;
    Scene scene_ = scene();
    TemporaryFolder folder_;
    std::filesystem::path brush_ = folder_ / "brush.png";
};

TEST_F(IdleSettings, AreThoseWithoutWhichTheOutputIsTheSame) {
    const auto values = samples(brush_);
    for (const Beside& beside : surroundings()) {
        const std::string without = written(settingsOf(beside.values), beside.kinds);
        for (const SettingDescription& row : settingTable()) {
            if (ofTheScene.contains(row.group) || unseen.contains(row.name)) continue;
            ASSERT_TRUE(values.contains(row.name)) << "a new setting, " << row.name << ", needs a value above";
            const bool given =
                std::ranges::any_of(beside.values, [&](const auto& one) { return one.first == row.name; });
            const bool noVectors = row.name == "brush" && (beside.kinds.vectors || beside.kinds.dxf);  // refused
            const bool refused = forPictures.contains(row.name) && !beside.kinds.pictures;
            if (given || noVectors || refused) continue;
            Values with = beside.values;
            with.emplace_back(row.name, values.at(row.name));
            const Settings settings = settingsOf(with);
            const std::string line = idleLine(row.name, settings, beside.kinds);
            std::string found;
            try {
                found = written(settings, beside.kinds);
            } catch (const Error&) {
                continue;  // a contradiction, which says so itself
            }
            if (found == without && line.empty() && oftenUnseen.contains(row.name)) continue;
            EXPECT_EQ(found == without, !line.empty())
                << beside.name << ": " << row.name << (line.empty() ? " acts, they say" : ": " + line);
        }
    }
}

TEST_F(IdleSettings, SayWhichFlagAndWhy) {
    const auto idle = [&](const Values& values, const OutputKinds& kinds) {
        return idleSettings(settingsOf(values), kinds);
    };
    EXPECT_THAT(idle({}, {.pictures = true}), IsEmpty());
    EXPECT_THAT(
        idle({{"page-size", "A4"}}, {.pictures = true}),
        testing::ElementsAre("--page-size does nothing: it is for .svg, .pdf and .dxf; --size takes millimetres"));
    EXPECT_THAT(idle({{"page-size", "A4"}, {"scale", "1:2"}}, {.pictures = true}), IsEmpty());
    EXPECT_THAT(idle({{"fit-curves", "1"}}, {.pictures = true, .vectors = true}), IsEmpty());
    EXPECT_THAT(idle({{"fit-curves", "1"}}, {.pictures = true}), Contains(HasSubstr("--fit-curves does nothing: ")));
    EXPECT_THAT(idle({{"hidden", "dashed"}, {"lines-from", "image"}}, {.pictures = true}),
                Contains("--hidden does nothing: it needs lines of the mesh, and --lines-from is image"));
    EXPECT_THAT(idle({{"framing", "together"}}, {.pictures = true, .views = 2}), IsEmpty());
    EXPECT_THAT(idle({{"time", "2"}}, {.pictures = true}),
                testing::ElementsAre("--time does nothing: there is no --animation"));
    EXPECT_THAT(idle({{"dpi", "200"}}, {.exr = true}), Not(IsEmpty()));
    EXPECT_THAT(idle({{"dpi", "200"}, {"line-width", "1mm"}}, {.exr = true}), IsEmpty());
    EXPECT_THAT(idle({{"line-style", "hidden:width=1"}}, {.vectors = true}),
                testing::ElementsAre("--line-style does nothing: hidden: is for --hidden dashed or solid"));
    EXPECT_THAT(idle({{"stroke-width", "strength"}}, {.vectors = true}),
                testing::ElementsAre("--stroke-width does nothing: strength is of lines of form, and --lines leaves "
                                     "them out"));
    EXPECT_THAT(idle({{"stroke-width", "strength"}, {"lines", "standard,ridge"}}, {.vectors = true}), IsEmpty());
    EXPECT_THAT(idle({{"suggestive-threshold", "1"}, {"lines", "ridge"}}, {.vectors = true}), testing::SizeIs(1));
}

TEST_F(IdleSettings, OfAJobAreThoseOfAllItsOutputs) {
    Job job{.model = "a.glb"};
    job.settings.lines.fitCurves = 1.0;
    job.outputs = {"{model}.png"};
    EXPECT_THAT(idleSettings(job), testing::SizeIs(1));
    job.outputs.emplace_back("{model}.SVG");
    EXPECT_THAT(idleSettings(job), IsEmpty());
    job.outputs.clear();
    EXPECT_THAT(idleSettings(job), testing::SizeIs(1)) << "pictures are drawn";
}

// --hidden dashed, --stroke-width and the like, of a picture without --lines-from.
TEST_F(IdleSettings, WhatNeedsLinesOfTheMeshTakesThem) {
    for (const auto& [name, value] : Values{{"hidden", "dashed"},
                                            {"stroke-width", "depth"},
                                            {"stroke-taper", "9"},
                                            {"isolines", "3"},
                                            {"brush", brush_},
                                            {"contour", "mesh"},
                                            {"coincident", "keep"},
                                            {"subdivide-adaptive", "1"}}) {
        const Values alone{{name, value}};
        const Values object{{name, value}, {"lines-from", "object"}};
        EXPECT_EQ(written(settingsOf(alone), {.pictures = true}), written(settingsOf(object), {.pictures = true}))
            << name;
        EXPECT_NE(written(settingsOf(alone), {.pictures = true}), written(settingsOf({}), {.pictures = true})) << name;
    }
}

}  // namespace
}  // namespace inkedge::job
