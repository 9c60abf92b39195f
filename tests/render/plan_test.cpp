// What is drawn, found and inked for which settings.
#include <algorithm>
#include <string>
#include <variant>

#include <gtest/gtest.h>

#include <inkedge/setting_table.h>

#include "passes/sumi.h"
#include "render/plan.h"

namespace inkedge::render {
namespace {

RenderSettings with(Detector detector, std::vector<Map> maps = {}, Style style = Style::Ink) {
    RenderSettings settings;
    settings.detector.detector = detector;
    settings.maps = std::move(maps);
    settings.style.style = style;
    return settings;
}

RenderSettings fromObject(std::vector<Map> maps = {}) {
    RenderSettings settings = with(Detector::Planes, std::move(maps));
    settings.lines.from = LinesFrom::Object;
    return settings;
}

// As "planes surface functions".
std::string drawn(const Plan& plan) {
    std::string words;
    if (plan.planes) words += "planes ";
    if (plan.surface) words += "surface ";
    if (plan.functions) words += "functions ";
    return words.substr(0, words.size() - (words.empty() ? 0 : 1));
}

TEST(PlanOf, aPictureOfLinesDrawsWhatItsDetectorReads) {
    const Plan planes = planOf(with(Detector::Planes));
    EXPECT_EQ(planes.lines, LineSource::Planes);
    EXPECT_EQ(drawn(planes), "planes");
    EXPECT_TRUE(planes.tracesLines);
    EXPECT_FALSE(planes.detectsEdges);

    const Plan classic = planOf(with(Detector::Classic));
    EXPECT_EQ(classic.lines, LineSource::Classic);
    EXPECT_EQ(drawn(classic), "surface");
    EXPECT_FALSE(classic.tracesLines);
    EXPECT_TRUE(classic.detectsEdges);
    EXPECT_EQ(classic.magnitudes, passes::Magnitudes::Drop);

    const Plan profiles = planOf(with(Detector::SaitoTakahashi));
    EXPECT_EQ(profiles.lines, LineSource::Profiles);
    EXPECT_EQ(drawn(profiles), "surface");
    EXPECT_FALSE(profiles.tracesLines);
    EXPECT_FALSE(profiles.detectsEdges);
}

TEST(PlanOf, linesOfTheMeshDrawNothing) {
    const Plan plan = planOf(fromObject());
    EXPECT_EQ(plan.lines, LineSource::Object);
    EXPECT_EQ(drawn(plan), "");
    EXPECT_FALSE(plan.drawsTiles());
    EXPECT_FALSE(plan.needsContext());
    EXPECT_FALSE(planOf(with(Detector::None)).needsContext());
    EXPECT_TRUE(planOf(with(Detector::Planes)).needsContext());
}

TEST(PlanOf, mapsOfLinesAreFoundWhateverThePicturesLinesAre) {
    for (const Map map : {Map::Types, Map::Ids}) {
        const Plan plan = planOf(fromObject({map}));
        EXPECT_EQ(drawn(plan), "planes") << name(map);
        EXPECT_TRUE(plan.tracesLines) << name(map);
        EXPECT_EQ(plan.types, map == Map::Types);
        EXPECT_EQ(plan.ids, map == Map::Ids ? trace::TraceIds::Keep : trace::TraceIds::Drop);
    }
}

TEST(PlanOf, mapsOfTheSurfaceAreDrawnBesideThePicturesLines) {
    for (const Map map : {Map::Depth, Map::Normal}) {
        const Plan plan = planOf(with(Detector::Planes, {map}));
        EXPECT_EQ(drawn(plan), "planes surface") << name(map);
        EXPECT_FALSE(plan.detectsEdges) << name(map);
        EXPECT_EQ(plan.surfaceMaps.depth, map == Map::Depth);
        EXPECT_EQ(plan.surfaceMaps.normal, map == Map::Normal);
    }
    for (const Map map : {Map::DepthEdges, Map::NormalEdges}) {
        const Plan plan = planOf(fromObject({map}));
        EXPECT_EQ(drawn(plan), "surface") << name(map);
        EXPECT_TRUE(plan.detectsEdges) << name(map);
        EXPECT_EQ(plan.magnitudes, passes::Magnitudes::Keep) << name(map);
        EXPECT_EQ(plan.edgeMaps.depth, map == Map::DepthEdges);
        EXPECT_EQ(plan.edgeMaps.normal, map == Map::NormalEdges);
        EXPECT_FALSE(plan.edgeMaps.either);
    }
}

TEST(PlanOf, theMapOfEdgesHasThoseOfTheDetector) {
    const Plan planes = planOf(fromObject({Map::Edges}));
    EXPECT_TRUE(planes.lineMask);
    EXPECT_TRUE(planes.inkMask);
    EXPECT_FALSE(planes.edgeMaps.either);
    EXPECT_EQ(drawn(planes), "planes");

    const Plan classic = planOf(with(Detector::Classic, {Map::Edges}, Style::Sumi));
    EXPECT_FALSE(classic.lineMask);
    EXPECT_TRUE(classic.inkMask);
    EXPECT_TRUE(classic.edgeMaps.either);
    EXPECT_TRUE(classic.detectsEdges);

    const Plan none = planOf(with(Detector::None, {Map::Edges}));
    EXPECT_EQ(drawn(none), "");
    EXPECT_TRUE(none.inkMask);
    EXPECT_FALSE(planOf(with(Detector::Planes)).inkMask);
}

TEST(PlanOf, planesAndSurfaceAreDrawnTogetherWhereOnePassCan) {
    RenderSettings settings = with(Detector::Planes, {Map::Depth});
    EXPECT_TRUE(planOf(settings).together);
    settings.picture.supersampling = 2;  // surfaces are drawn in pixels
    EXPECT_FALSE(planOf(settings).together);
    settings.picture.supersampling = 1;
    settings.detector.normalLights = NormalLights::TwoPass;
    EXPECT_FALSE(planOf(settings).together);
    EXPECT_FALSE(planOf(with(Detector::Planes)).together);
}

TEST(PlanOf, functionsAreDrawnBesideAnyLines) {
    RenderSettings settings = fromObject();
    settings.detector.functions = {surfaceFunction("height")};
    const Plan plan = planOf(settings);
    EXPECT_EQ(plan.lines, LineSource::Object);
    EXPECT_EQ(drawn(plan), "functions");
    EXPECT_TRUE(plan.needsContext());
}

TEST(PlanOf, hatchMarksReadPlanesBesideAnyLines) {
    const Plan alone = planOf(with(Detector::None, {}, Style::Hatch));
    EXPECT_EQ(alone.lines, LineSource::None);
    EXPECT_EQ(drawn(alone), "planes");
    EXPECT_FALSE(alone.tracesLines);
    EXPECT_EQ(alone.margin, raster::tileMargin);
    EXPECT_EQ(alone.paper, settings::Paper::Background);
    EXPECT_EQ(planOf(with(Detector::Planes, {}, Style::Hatch)).lines, LineSource::Planes);
}

TEST(PlanOf, aBrushReplacesLinesAndReachesFar) {
    RenderSettings settings = with(Detector::Classic, {}, Style::Sumi);
    settings.style.sumiLength = 100.0;
    settings.picture.supersampling = 2;
    const Plan plan = planOf(settings);
    EXPECT_EQ(plan.lines, LineSource::None);
    EXPECT_EQ(drawn(plan), "surface");
    EXPECT_FALSE(plan.detectsEdges);
    EXPECT_GT(plan.margin, raster::tileMargin);
    EXPECT_EQ(plan.margin, 2 * passes::sumiReach(settings.style));
    settings.lines.from = LinesFrom::Object;
    EXPECT_EQ(planOf(settings).lines, LineSource::None);
}

TEST(PlanOf, aPencilDrawsOverWhatLiesOnNothing) {
    RenderSettings settings = fromObject();
    settings.style.style = Style::Pencil;
    const Plan plan = planOf(settings);
    EXPECT_EQ(plan.lines, LineSource::Object);
    EXPECT_EQ(drawn(plan), "");
    EXPECT_TRUE(plan.needsContext());
    EXPECT_EQ(plan.paper, settings::Paper::Transparent);
}

TEST(PlanOf, aShadeIsDrawnForThePictureOrForItsMap) {
    RenderSettings settings = fromObject();
    EXPECT_EQ(planOf(settings).shade, Shade::None);
    settings.maps = {Map::Shade};
    Plan plan = planOf(settings);
    EXPECT_EQ(plan.shade, Shade::Gooch);
    EXPECT_FALSE(plan.underlaid);
    EXPECT_EQ(plan.paper, settings::Paper::Background);
    EXPECT_TRUE(plan.drawsTiles());
    settings.shade.shade = Shade::Light;
    plan = planOf(settings);
    EXPECT_EQ(plan.shade, Shade::Light);
    EXPECT_TRUE(plan.underlaid);
    EXPECT_EQ(plan.paper, settings::Paper::Transparent);
    settings.maps = {};
    EXPECT_EQ(planOf(settings).shade, Shade::Light);
    EXPECT_EQ(planOfShade(settings).shade, Shade::Light);
    EXPECT_EQ(drawn(planOfShade(settings)), "");
}

TEST(PlanOf, noStyleIsNoLinesWhateverTheDetector) {
    for (const Detector detector : {Detector::Planes, Detector::Classic, Detector::RaskarCohen}) {
        const Plan plan = planOf(with(detector, {}, Style::None));
        EXPECT_EQ(plan.lines, LineSource::None);
        EXPECT_FALSE(plan.drawsTiles());
    }
}

TEST(PlanOf, fattenedFacesAreDrawnAlone) {
    const Plan plan = planOf(with(Detector::RaskarCohen));
    EXPECT_EQ(plan.lines, LineSource::Fattened);
    EXPECT_TRUE(plan.fattened);
    EXPECT_TRUE(plan.drawsTiles());
    EXPECT_EQ(drawn(plan), "");
    EXPECT_FALSE(planOf(with(Detector::RaskarCohen, {}, Style::Sumi)).fattened);
}

TEST(PlanOfImageLines, isOfTracedLinesAlone) {
    const Plan plan = planOfImageLines();
    EXPECT_EQ(plan.lines, LineSource::Planes);
    EXPECT_EQ(drawn(plan), "planes");
    EXPECT_TRUE(plan.tracesLines);
    EXPECT_EQ(plan.ids, trace::TraceIds::Drop);
    EXPECT_FALSE(plan.types || plan.lineMask || plan.inkMask || plan.detectsEdges);
    EXPECT_EQ(plan.style->style, Style::Ink);
}

// What --style takes.
TEST(Styles, haveARowEach) {
    const auto row = std::ranges::find(settingTable(), "style", &SettingDescription::name);
    ASSERT_NE(row, settingTable().end());
    const auto* const choice = std::get_if<Choice>(&row->constraint);
    ASSERT_NE(choice, nullptr);
    for (std::size_t i = 0; i < choice->names.size(); ++i) {
        const auto style = static_cast<Style>(i);
        EXPECT_EQ(styleRow(style).style, style) << choice->names[i];
        EXPECT_EQ(styleRow(style).stage, choice->names[i]);
    }
}

}  // namespace
}  // namespace inkedge::render
