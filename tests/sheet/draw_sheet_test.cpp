// Sheets, read back from what is written of them.
#include <inkedge/sheet.h>

#include <algorithm>
#include <limits>
#include <map>
#include <regex>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <inkedge/setting_table.h>

#include "base/expect_error.h"
#include "base/temporary_folder.h"
#include "scenes.h"
#include "settings/pens.h"
#include "sheet/page.h"
#include "sheet/pens.h"

namespace inkedge::sheet {
namespace {

using enum NamedView;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

constexpr double exact = 0.01;  // mm

Sheet drawn(const Scene& scene, const SheetSettings& settings, const Settings& lines = {}) {
    Renderer renderer{{}, ContextTime::WhenNeeded};
    return drawSheet(renderer, scene, lines, settings);
}

std::string svgOf(const Sheet& sheet) {
    const TemporaryFolder folder;
    writeSheet(sheet, folder / "sheet.svg");
    return contents(folder / "sheet.svg");
}

// Grows to hold the points of a path's data, whose commands are m, l and z.
void grow(Rect& rect, const std::string& data, glm::dvec2 origin) {
    static const std::regex token{"[a-z]|-?[0-9]*\\.?[0-9]+"};
    glm::dvec2 at{0.0};
    std::vector<double> numbers;
    for (std::sregex_iterator t{data.begin(), data.end(), token}; t != std::sregex_iterator{}; ++t) {
        const std::string text = t->str();
        if (std::isalpha(static_cast<unsigned char>(text[0])) != 0) continue;
        numbers.push_back(std::stod(text));
        if (numbers.size() % 2 != 0) continue;
        at += glm::dvec2{numbers[numbers.size() - 2], numbers.back()};
        rect.low = glm::min(rect.low, 0.1 * (origin + at));
        rect.high = glm::max(rect.high, 0.1 * (origin + at));
    }
}

// The rectangle that the lines of each view fill on the page, millimetres, and of all else as view "".
std::map<std::string, Rect> rectsIn(const std::string& svg) {
    static const std::regex group{"<g class=\"([^\"]*)\"([^>]*)>([^]*?)</g>"};
    static const std::regex moved{"translate\\(([-0-9.]+) ([-0-9.]+)\\)"};
    static const std::regex named{"data-view=\"([a-z]+)\""};
    static const std::regex path{" d=\"([^\"h]*)\""};
    std::map<std::string, Rect> rects;
    for (std::sregex_iterator g{svg.begin(), svg.end(), group}; g != std::sregex_iterator{}; ++g) {
        const std::string attributes = (*g)[2];
        const std::string paths = (*g)[3];
        std::smatch found;
        const glm::dvec2 origin = std::regex_search(attributes, found, moved)
                                      ? glm::dvec2{std::stod(found[1]), std::stod(found[2])}
                                      : glm::dvec2{0.0};
        const std::string view = std::regex_search(attributes, found, named) ? found[1].str() : "";
        if (view.empty() && (*g)[1] != "inkedge frame") continue;
        constexpr double infinity = std::numeric_limits<double>::infinity();
        Rect& rect = rects.try_emplace(view, Rect{glm::dvec2{infinity}, glm::dvec2{-infinity}}).first->second;
        for (std::sregex_iterator p{paths.begin(), paths.end(), path}; p != std::sregex_iterator{}; ++p) {
            std::string data = (*p)[1];
            for (std::size_t at = 0; (at = data.find('z')) != std::string::npos;) data.erase(at, 1);
            grow(rect, data, origin);
        }
    }
    return rects;
}

TEST(Sheet, HasItsViewsWhereTheyAreSaidToBeToAHundredthOfAMillimetre) {
    const Scene scene = scenes::sceneOf(scenes::box({60, 40, 20}));
    for (const Projection projection : {Projection::First, Projection::Third}) {
        for (const SheetPage page : {SheetPage{4, false}, {3, true}, {1, true}}) {
            SheetSettings settings;
            settings.projection = projection;
            settings.page = page;
            const Sheet sheet = drawn(scene, settings);
            const std::string svg = svgOf(sheet);
            const glm::dvec2 size = sizeOf(page);
            EXPECT_THAT(svg, HasSubstr(fmt::format("width=\"{}mm\" height=\"{}mm\" viewBox=\"0 0 {} {}\"", size.x,
                                                   size.y, 10 * size.x, 10 * size.y)));
            const auto rects = rectsIn(svg);
            ASSERT_EQ(rects.size(), 5U) << "four views and the frame";
            const Rect front = rects.at("front");
            EXPECT_NEAR(front.size().x, sheet.scale * 60, exact);
            EXPECT_NEAR(front.size().y, sheet.scale * 40, exact);
            EXPECT_NEAR(rects.at("top").size().y, sheet.scale * 20, exact);
            EXPECT_NEAR(rects.at("right").size().x, sheet.scale * 20, exact);
            EXPECT_NEAR(rects.at("top").low.x, front.low.x, exact);
            EXPECT_NEAR(rects.at("top").high.x, front.high.x, exact);
            EXPECT_NEAR(rects.at("right").low.y, front.low.y, exact);
            EXPECT_NEAR(rects.at("right").high.y, front.high.y, exact);
            const bool first = projection == Projection::First;
            EXPECT_EQ(rects.at("right").high.x < front.low.x, first);
            EXPECT_EQ(rects.at("top").low.y > front.high.y, first);
            for (const SheetView& view : sheet.views) {
                const Rect found = rects.at(view.view == Iso     ? "iso"
                                            : view.view == Front ? "front"
                                            : view.view == Top   ? "top"
                                                                 : "right");
                EXPECT_NEAR(glm::distance(found.middle(), view.middle), 0.0, exact);
                EXPECT_NEAR(glm::distance(found.size(), view.size), 0.0, exact);
            }
        }
    }
}

TEST(Sheet, TakesTheModelsUnitAndTheScaleThatIsAsked) {
    Scene::Data data;
    data.meshes = {scenes::box({0.06, 0.04, 0.02})};
    data.instances = {{"part", 0}};
    data.source.unit = LengthUnit::Metre;
    const Scene metres{std::move(data)};
    SheetSettings settings;
    settings.scale = 1.5;
    const Sheet sheet = drawn(metres, settings);
    EXPECT_EQ(sheet.scale, 1.5);
    EXPECT_NEAR(sheet.views.front().size.x, 90.0, exact);
    settings.scale.reset();
    EXPECT_EQ(drawn(metres, settings).scale, drawn(scenes::sceneOf(scenes::box({60, 40, 20})), settings).scale);
    settings.scale = 10.0;
    expectError(Error::Kind::Usage,
                AllOf(HasSubstr("--scale: expected views that fit on A3, found them too large at 10:1; "),
                      HasSubstr(":1 fits")),
                [&] { (void)drawn(metres, settings); });
}

TEST(Sheet, HasHiddenLinesInTheViewsOfSixSidesAlone) {
    Scene::Data data;
    data.meshes = {scenes::box({60, 40, 20}), scenes::box({20, 20, 10})};
    data.instances = {{"plate", 0}, {"boss", 1, scenes::translation({5, 3, -15})}};
    const Scene scene{std::move(data)};
    const auto countHidden = [&](HiddenLines hidden, bool iso) {
        SheetSettings settings;
        settings.hidden = hidden;
        std::ptrdiff_t count = 0;
        for (const SheetView& view : drawn(scene, settings).views)
            if ((view.view == Iso) == iso) count += std::ranges::count(view.lines.lines, false, &Line::visible);
        return count;
    };
    EXPECT_GT(countHidden(HiddenLines::Dashed, false), 0);
    EXPECT_EQ(countHidden(HiddenLines::Dashed, true), 0);
    EXPECT_EQ(countHidden(HiddenLines::None, false), 0);
    SheetSettings settings;
    EXPECT_THAT(svgOf(drawn(scene, settings)), HasSubstr("stroke-dasharray=\"27.5 10\"")) << "3 and 0.75 mm are seen";
}

TEST(Sheet, HasTheLineWidthsOfIso128) {
    const auto widths = [](const SheetPage& page, LineType type, const PictureSettings& given = {}) {
        const auto pens = settings::pens(sheetPens(given, page));
        const auto i = static_cast<std::size_t>(bitIndex(type));
        return std::pair{pens[i].width / 10.0, pens[i + lineTypeCount].width / 10.0};
    };
    for (const SheetPage page : {SheetPage{4, false}, {3, true}, {2, true}})
        EXPECT_EQ(widths(page, LineType::Crease), (std::pair{0.5, 0.25}));
    for (const SheetPage page : {SheetPage{1, true}, {0, true}})
        EXPECT_EQ(widths(page, LineType::Outline), (std::pair{0.7, 0.35}));
    for (const LineType type : formLineTypes) EXPECT_EQ(widths({3, true}, type).first, 0.25);
    PictureSettings given;
    given.lineWidth = {1.0, true};
    given.pens[0].width = PictureLength{2.0, true};
    EXPECT_EQ(widths({3, true}, LineType::Outline, given).first, 2.0);
    EXPECT_EQ(widths({3, true}, LineType::Crease, given), (std::pair{1.0, 0.5}));
}

TEST(Sheet, OfWhatIsFlatOrASingleLineIsASheet) {
    const Scene flat = scenes::sceneOf(scenes::quad({0, 0, 0}, {30, 0, 0}, {30, 20, 0}, {0, 20, 0}));
    const auto rects = rectsIn(svgOf(drawn(flat, {})));
    EXPECT_NEAR(rects.at("top").size().y, 0.0, exact);
    EXPECT_NEAR(rects.at("front").size().y, 2.0 / 3.0 * rects.at("front").size().x, exact);

    Mesh wire;
    wire.lines = {{0, 0, 0}, {50, 0, 0}};
    const Sheet line = drawn(scenes::sceneOf(wire), {});
    EXPECT_NEAR(rectsIn(svgOf(line)).at("front").size().x, 50.0 * line.scale, exact);
}

TEST(Sheet, HasAFrameAndATitleBlock) {
    SheetSettings settings;
    settings.title = "Plate & hole";
    const Sheet sheet = drawn(scenes::sceneOf(scenes::box({60, 40, 20})), settings);
    const std::string svg = svgOf(sheet);
    EXPECT_THAT(svg, AllOf(HasSubstr("<title>Plate &amp; hole</title>"), HasSubstr("inkscape:label=\"frame\""),
                           HasSubstr("inkscape:label=\"title-block\""), HasSubstr("inkscape:label=\"text\""),
                           HasSubstr("inkscape:label=\"symbol\"")));
    const std::size_t from = svg.find("<metadata>") + 10;
    const auto metadata = nlohmann::json::parse(svg.substr(from, svg.find("</metadata>") - from));
    EXPECT_EQ(metadata.at("page"), "A3");
    EXPECT_EQ(metadata.at("projection"), "first");
    EXPECT_EQ(metadata.at("views").size(), 4U);
    const Rect frame = rectsIn(svg).at("");
    EXPECT_GE(frame.low.x, 0.0);
    EXPECT_LE(frame.high.x, 420.0);
    EXPECT_EQ(svg, svgOf(drawn(scenes::sceneOf(scenes::box({60, 40, 20})), settings))) << "the same each time";
    settings.projection = Projection::Third;
    EXPECT_NE(svg, svgOf(drawn(scenes::sceneOf(scenes::box({60, 40, 20})), settings)));
}

TEST(Sheet, SaysWhatItsTitleBlockCannotWrite) {
    const Scene scene = scenes::sceneOf(scenes::box({60, 40, 20}));
    SheetSettings settings;
    settings.title = "\u6B6F\u8ECA";
    EXPECT_THAT(drawn(scene, settings).warnings, testing::ElementsAre(HasSubstr("no letters for \u6B6F\u8ECA")));
    settings.title = std::string(200, 'W');
    EXPECT_THAT(drawn(scene, settings).warnings, testing::ElementsAre(HasSubstr("has no room for 'WWW")));
    settings.title = "Gear";
    EXPECT_THAT(drawn(scene, settings).warnings, IsEmpty());
}

TEST(Sheet, RefusesWhatItCannotDraw) {
    const Scene scene = scenes::sceneOf(scenes::box({60, 40, 20}));
    SheetSettings none;
    none.views.clear();
    expectError(Error::Kind::Usage, HasSubstr("--views: expected at least one view"),
                [&] { (void)drawn(scene, none); });
    expectError(Error::Kind::Usage, HasSubstr("expected a name that ends in .svg, .pdf, .dxf or .png, found .tif"),
                [] { expectSheetFile("a.tif"); });
    expectError(Error::Kind::Usage, HasSubstr("found no extension"), [] { expectSheetFile("a"); });
    expectError(Error::Kind::Usage, HasSubstr("found .json"), [] { expectSheetFile("a.json"); });
}

TEST(SheetOptions, TakeWhatTheySayAndNothingElse) {
    const std::map<std::string_view, std::pair<std::vector<std::string>, std::vector<std::string>>> texts{
        {"projection", {{"first", "third"}, {"second", "", "First"}}},
        {"views", {{"front", "iso,top,bottom"}, {"", "front,front", "frnt", "front,", "turntable:3"}}},
        {"page", {{"A4", "a0", "A3-portrait", "A4-landscape"}, {"A5", "", "A", "A33", "A4-", "letter", "A4landscape"}}},
        {"scale", {{"auto", "1:2", "20:1", "1:1.5"}, {"", "0:1", "1", "1:0", "-1:2", "x"}}},
        {"hidden", {{"none", "dashed", "solid"}, {"", "dotted"}}},
        {"title", {{"", "anything"}, {}}},
        {"date", {{"2026-11-30"}, {}}}};
    for (const SheetOption& option : sheetOptions()) {
        ASSERT_TRUE(texts.contains(option.name)) << "a new option, " << option.name << ", needs texts above";
        for (const std::string& good : texts.at(option.name).first) {
            SheetSettings settings;
            EXPECT_NO_THROW(option.set(settings, good)) << option.name << ' ' << good;
        }
        for (const std::string& bad : texts.at(option.name).second) {
            SheetSettings settings;
            expectError(Error::Kind::Usage,
                        AllOf(HasSubstr(fmt::format("--{}: expected ", option.name)),
                              HasSubstr(fmt::format(", found '{}'", bad)), Not(HasSubstr("\n"))),
                        [&] { option.set(settings, bad); });
        }
    }
}

}  // namespace
}  // namespace inkedge::sheet
