#include <inkedge/write.h>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <inkedge/setting_table.h>

#include "base/expect_error.h"
#include "base/temporary_folder.h"
#include "curves/curves.h"
#include "images/read_png.h"
#include "io/lines_to_write.h"
#include "io/well_formed.h"

namespace inkedge::io {
namespace {

using curves::closedThrough;
using curves::lineThrough;
using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

std::string svg(const Lines& lines, const Settings& settings = {}) { return linesSvg(lines, settings); }

// A picture from base64 of a PNG.
Image<std::uint8_t> decoded(const std::string& text) {
    std::vector<std::uint8_t> bytes;
    std::uint32_t bits = 0;
    int count = 0;
    for (const char c : text) {
        const std::size_t value =
            std::string_view{"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/"}.find(c);
        if (value == std::string_view::npos) break;
        bits = bits << 6U | static_cast<std::uint32_t>(value);
        count += 6;
        if (count < 8) continue;
        count -= 8;
        bytes.push_back(static_cast<std::uint8_t>(bits >> static_cast<unsigned>(count)));
    }
    return images::readPngToLookAt(bytes, 1'000'000, images::PngChannels::Rgba);
}

std::string unescaped(std::string text) {
    for (const auto& [entity, character] : {std::pair{"&lt;", "<"}, {"&gt;", ">"}, {"&amp;", "&"}}) {
        for (std::size_t at = 0; (at = text.find(entity, at)) != std::string::npos; ++at) {
            text.replace(at, std::string{entity}.size(), character);
        }
    }
    return text;
}

std::string between(const std::string& text, const std::string& begin, const std::string& end) {
    const std::size_t from = text.find(begin);
    if (from == std::string::npos) return {};
    return text.substr(from + begin.size(), text.find(end, from + begin.size()) - from - begin.size());
}

// The begin of a group that is a layer, without what it is drawn with.
std::string layerOf(const std::string& type, const std::string& visibility) {
    return fmt::format(R"(<g class="inkedge {0} {1} {0}-{1}" inkscape:groupmode="layer" inkscape:label="{0}-{1}")",
                       type, visibility);
}

TEST(LinesSvg, hasTheShadeAsAnImageUnderThePaths) {
    Lines lines = linesOf({lineThrough({{1, 1}, {9, 9}})}, {20, 10});
    const std::string without = svg(lines);
    EXPECT_THAT(without, AllOf(Not(HasSubstr("<image")), Not(HasSubstr("xlink"))));
    lines.shade = Image<std::uint8_t>{{20, 10}, 4, std::uint8_t{0}};
    for (int x = 0; x < 7; ++x) {
        lines.shade(x, 3, 0) = static_cast<std::uint8_t>(30 * x);
        lines.shade(x, 3, 3) = 255;
    }
    const std::string text = svg(lines);
    expectWellFormed(text);
    EXPECT_LT(text.find("class=\"inkedge background\""), text.find("<image"));
    EXPECT_LT(text.find("<image"), text.find("<path"));
    EXPECT_THAT(text, AllOf(HasSubstr("width=\"20\" height=\"10\" preserveAspectRatio=\"none\""),
                            HasSubstr("xmlns:xlink=\"http://www.w3.org/1999/xlink\"")));
    EXPECT_EQ(decoded(between(text, "data:image/png;base64,", "\"")), lines.shade);

    const std::string page = svg(lines, settingsOf({{"page-size", "A4"}}));
    EXPECT_EQ(between(page, "<image", "xlink:href").substr(between(page, "<image", "xlink:href").find("transform")),
              between(page, "#000000\" stroke-width=\"1.5\" ", ">") + " ")
        << "moved as the paths are";
}

// The drawing's paths, each as the object and where it begins.
std::vector<std::string> beginnings(const std::string& text) {
    std::vector<std::string> found;
    for (std::size_t at = 0; (at = text.find("<path data-object=\"", at)) != std::string::npos; ++at) {
        const std::string path = text.substr(at, text.find("/>", at) - at);
        found.push_back(between(path, "data-object=\"", "\"") + ":" + between(path, "d=\"", "l"));
    }
    return found;
}

TEST(LinesSvg, hasAPathALineInAnOrderOfShortWays) {
    std::vector<Line> all{lineThrough({{100, 50}, {150, 50}}), lineThrough({{10, 10}, {40, 10}}),
                          lineThrough({{95, 50}, {41, 12}}), lineThrough({{5, 5}, {9, 10}})};
    for (std::size_t i = 0; i < all.size(); ++i) all[i].object = i < 3 ? 1 : 2;
    EXPECT_THAT(beginnings(svg(linesOf(all))),
                testing::ElementsAre(testing::StartsWith("1:"), testing::StartsWith("2:")))
        << "a path an object";
    EXPECT_THAT(beginnings(svg(linesOf(all), settingsOf({{"path-order", "travel"}}))),
                testing::ElementsAre(HasSubstr("2:m5 5 "), HasSubstr("1:m10 10 "), HasSubstr("1:m41 12 "),
                                     HasSubstr("1:m100 50 ")));
}

TEST(LinesSvg, groupsLinesByTypeAndVisibilityWithWhatCoversLast) {
    const Lines lines = linesOf({typed(lineThrough({{1, 1}, {9, 9}}), LineType::Outline),
                                 hidden(typed(lineThrough({{1, 1}, {9, 2}}), LineType::Outline)),
                                 typed(lineThrough({{1, 1}, {9, 5}}), LineType::Crease)});
    const std::string text =
        svg(lines, settingsOf({{"hidden", "dashed"}, {"line-style", "crease:width=3,color=#123456"}}));
    expectWellFormed(text);
    const std::size_t first =
        text.find(layerOf("outline", "hidden") + R"( stroke="#000000" stroke-width="0.75" stroke-dasharray="4.5 3">)");
    const std::size_t second = text.find(layerOf("crease", "visible") + R"( stroke="#123456" stroke-width="3">)");
    const std::size_t third = text.find(layerOf("outline", "visible") + R"( stroke="#000000" stroke-width="1.5">)");
    ASSERT_NE(third, std::string::npos) << text;
    EXPECT_LT(first, second);
    EXPECT_LT(second, third);
    EXPECT_THAT(text, HasSubstr(R"(d="m1 1 8 8"/>)"));
}

TEST(LinesSvg, drawsThinPartsAsThinAsTheyAre) {
    Line thin = lineThrough({{1, 1}, {9, 9}});
    thin.width = 0.25;
    const std::string text = svg(linesOf({thin, lineThrough({{1, 2}, {3, 4}})}), settingsOf({{"line-width", "2"}}));
    expectWellFormed(text);
    EXPECT_THAT(text, HasSubstr(R"( stroke-width="0.5" d="m1 1 8 8"/>)"));
    EXPECT_THAT(text, HasSubstr(R"("0" d="m1 2 2 2"/>)")) << "as wide as its group's pen";
}

TEST(LinesSvg, leavesOutWhatIsNotDrawn) {
    const Lines lines = linesOf({typed(lineThrough({{1, 1}, {9, 9}}), LineType::Outline),
                                 hidden(typed(lineThrough({{1, 1}, {9, 2}}), LineType::Outline)),
                                 typed(lineThrough({{1, 1}, {9, 5}}), LineType::Crease)});
    EXPECT_THAT(svg(lines),
                AllOf(Not(HasSubstr("outline hidden")), HasSubstr("outline visible"), HasSubstr("crease visible")));
    EXPECT_THAT(svg(lines, settingsOf({{"lines", "crease"}})),
                AllOf(Not(HasSubstr("outline visible")), HasSubstr("crease visible")));
    EXPECT_THAT(svg(lines, settingsOf({{"hidden", "solid"}})),
                AllOf(HasSubstr("outline hidden"), Not(HasSubstr("dasharray"))));
}

TEST(LinesSvg, isAnEmptyDrawingWithoutLines) {
    const std::string text = svg(linesOf({}));
    expectWellFormed(text);
    EXPECT_THAT(text,
                AllOf(HasSubstr(R"(viewBox="0 0 200 100")"), HasSubstr("fill=\"#ffffff\""), Not(HasSubstr("<g"))));
    EXPECT_THAT(svg(linesOf({}), settingsOf({{"background", "none"}})), Not(HasSubstr("<rect")));
    expectError(Error::Kind::Usage, HasSubstr("at least one pixel"), [] { (void)linesSvg({}, {}); });
    expectError(Error::Kind::Usage, HasSubstr("at least one pixel"), [] { (void)linesJson({}, {}); });
}

TEST(LinesSvg, refuseABrushWhichNeedsPixels) {
    const Settings settings = settingsOf({{"brush", "dry.png"}});
    expectError(Error::Kind::Usage, HasSubstr("brush: expected a picture of pixels, found a file of vectors"),
                [&] { (void)svg(linesOf({}), settings); });
}

TEST(LinesSvg, hasThePagesSizeAndWidthsThatHoldOnIt) {
    const Lines lines = linesOf({lineThrough({{1, 1}, {9, 9}})});
    EXPECT_THAT(svg(lines), HasSubstr(R"(width="200" height="100")"));
    // 254 dots an inch: ten a millimetre.
    EXPECT_THAT(svg(lines, settingsOf({{"line-width", "0.5mm"}, {"dpi", "254"}})),
                AllOf(HasSubstr(R"(width="20mm" height="10mm")"), HasSubstr(R"(stroke-width="5")")));
    EXPECT_THAT(svg(lines, settingsOf({{"dpi", "254"}})),
                AllOf(HasSubstr(R"(width="20mm" height="10mm")"), HasSubstr(R"(stroke-width="1.5")")));
    // 254 / 3 is 84.6666..: no reader that counts pixels begun as whole ones gets a 1001st.
    EXPECT_THAT(svg(linesOf({}, {1000, 500}), settingsOf({{"dpi", "300"}})),
                HasSubstr(R"(width="84.666mm" height="42.333mm" viewBox="0 0 1000 500")"));
    EXPECT_THAT(svg(linesOf({}, {300, 300}), settingsOf({{"dpi", "300"}})), HasSubstr(R"(width="25.4mm")"));
}

TEST(LinesSvg, standsInTheMiddleOfASheetWhoseShapeItsCoordinatesHave) {
    const Lines lines = linesOf({lineThrough({{10, 10}, {90, 90}})});
    // 200 pixels across 400 mm, with margins above and below: half a pixel a millimetre.
    const auto onSheet = [](const std::string& sheet) {
        return settingsOf({{"line-width", "3mm"}, {"page-size", sheet}, {"background", "#ffe"}});
    };
    const std::string text = svg(lines, onSheet("400mmx500mm"));
    expectWellFormed(text);
    const std::string moved = "transform=\"translate(0 75)\"";
    EXPECT_THAT(
        text, AllOf(HasSubstr(R"(width="400mm" height="500mm" viewBox="0 0 200 250")"),
                    HasSubstr(R"(<rect class="inkedge background" width="200" height="250" fill="#ffffee"/>)"),
                    HasSubstr(layerOf("outline", "visible") + R"( stroke="#000000" stroke-width="1.5" )" + moved + ">"),
                    HasSubstr("d=\"m10 10 80 80\"")));
    EXPECT_THAT(svg(lines, onSheet("500mmx200mm")),
                AllOf(HasSubstr(R"(viewBox="0 0 250 100")"), HasSubstr("translate(25 0)")));
    EXPECT_THAT(svg(lines, onSheet("400mmx200mm")),
                AllOf(HasSubstr(R"(viewBox="0 0 200 100")"), Not(HasSubstr("transform"))));
    EXPECT_THAT(svg(linesOf({}, {700, 300}), onSheet("210mmx90mm")), Not(HasSubstr("transform"))) << "but for rounding";
}

TEST(LinesSvg, hasTheSizeOnPaperThatIsAskedFor) {
    const Lines lines = linesOf({}, {340, 227});
    EXPECT_THAT(svg(lines, settingsOf({{"size", "90x60mm"}})),
                AllOf(HasSubstr(R"(width="90mm" height="60mm" viewBox="0 0 340.157 226.772")"),
                      HasSubstr(R"(<rect class="inkedge background" width="340.157" height="226.772")")));
    EXPECT_THAT(svg(lines, settingsOf({{"size", "90mm"}})), HasSubstr(R"(width="90mm" height="60.06mm")"));
    EXPECT_THAT(svg(lines, settingsOf({{"dpi", "96"}})), HasSubstr(R"(width="89.958mm" height="60.06mm")"));
    // At a scale a picture keeps its size on the page; without one it fills the page.
    const Lines drawn = linesOf({lineThrough({{10, 10}, {90, 90}})});
    EXPECT_THAT(svg(drawn, settingsOf({{"scale", "1:2"}, {"page-size", "254mmx127mm"}, {"dpi", "25.4"}})),
                AllOf(HasSubstr(R"(viewBox="0 0 254 127")"), HasSubstr("translate(27 13.5)")));
}

TEST(LinesSvg, drawsHiddenLinesAsTheirPenSays) {
    const Lines lines = linesOf({hidden(typed(lineThrough({{10, 10}, {90, 90}}), LineType::Crease))});
    const auto pen = [&](const std::string& style) {
        return svg(lines, settingsOf({{"hidden", "dashed"}, {"line-width", "2"}, {"line-style", style}}));
    };
    EXPECT_THAT(pen("crease:color=#00f"), HasSubstr(R"(stroke="#0000ff" stroke-width="1" stroke-dasharray="6 4")"));
    EXPECT_THAT(pen("hidden:width=3"), HasSubstr(R"(stroke="#000000" stroke-width="3" stroke-dasharray="18 12")"));
    EXPECT_THAT(pen("crease:color=#00f;hidden:color=#888,dash=5:2.5"),
                HasSubstr(R"(stroke="#888888" stroke-width="1" stroke-dasharray="5 2.5")"));
    EXPECT_THAT(svg(lines, settingsOf({{"hidden", "solid"}, {"line-style", "hidden:dash=1mm:1mm,width=1mm"}})),
                AllOf(HasSubstr(R"(stroke-width="3.78")"), Not(HasSubstr("dasharray"))));
}

TEST(LinesSvg, hasNoRectangleThatShowsNothing) {
    const auto onSheet = [](const std::string& page) {
        return settingsOf({{"page-size", page}, {"background", "none"}, {"line-width", "4"}});
    };
    const Lines inside = linesOf({lineThrough({{2.5, 2.5}, {190, 90}})});
    EXPECT_THAT(svg(inside, onSheet("A4")), AllOf(Not(HasSubstr("<rect")), Not(HasSubstr("clip"))));
    EXPECT_THAT(svg(inside), AllOf(HasSubstr("<rect"), Not(HasSubstr("clip"))));
    for (const Lines& cut : {linesOf({lineThrough({{10, 1.5}, {190, 90}})}),  // half its width lies beyond
                             linesOf({lineThrough({{10, 10}, {250, 90}})})}) {
        const std::string text = svg(cut, onSheet("A4"));
        expectWellFormed(text);
        EXPECT_THAT(text, AllOf(HasSubstr(R"(<clipPath id="picture"><rect width="200" height="100"/></clipPath>)"),
                                HasSubstr("clip-path=\"url(#picture)\">")));
        EXPECT_THAT(svg(cut, onSheet("400mmx200mm")), Not(HasSubstr("clip"))) << "the sheet's edges cut";
    }
    Settings settings = onSheet("A4");
    set(settings, "stroke-taper", "20", "stroke-taper");
    EXPECT_THAT(svg(inside, settings), Not(HasSubstr("clip")));
    EXPECT_THAT(svg(linesOf({lineThrough({{10, 10}, {250, 90}})}), settings), HasSubstr("clip-path"));
}

TEST(LinesSvg, escapesWhatXmlDoesNotTake) {
    const std::string title = "a<b>&\"c'\x01\xFF\xEF\xBF\xBF.svg";
    Settings settings;
    settings.load.animation = "<&\">]]>";
    const std::string text = linesSvg(linesOf({}), settings, title);
    expectWellFormed(text);
    EXPECT_EQ(between(text, "<title>", "</title>"), "a&lt;b&gt;&amp;\"c' \xEF\xBF\xBD\xEF\xBF\xBD.svg");
    const json metadata = json::parse(unescaped(between(text, "<metadata>", "</metadata>")));
    EXPECT_EQ(metadata.at("settings").at("animation"), "<&\">]]>");
    EXPECT_EQ(metadata.at("size"), json({200, 100}));
    EXPECT_EQ(metadata.at("camera").at("view").size(), 4U);
    EXPECT_GT(metadata.at("bounds").at("radius"), 0.5);
}

TEST(LinesSvg, keepsLongLinesShort) {
    std::vector<Line> all;
    for (unsigned seed = 0; seed < 40; ++seed) all.push_back(curves::winding(5000, 0.1, seed));
    const Lines lines = linesOf(all, {600, 400});
    const std::string polylines = svg(lines);
    const std::string fitted = svg(lines, settingsOf({{"fit-curves", "0.25"}}));
    // 200000 points: 3 MB as they are.
    EXPECT_LT(polylines.size(), 50'000U);
    EXPECT_LT(fitted.size(), polylines.size());
    EXPECT_THAT(between(fitted, "d=\"", "\""), HasSubstr("c"));
    EXPECT_THAT(between(polylines, "d=\"", "\""), Not(HasSubstr("c")));
}

TEST(LinesJson, holdsTheLinesAsTheyAre) {
    Line line = typed(closedThrough({{10.12345, 20}, {500, -30}, {40, 60}}), LineType::Occlusion);
    line.object = 3;
    line.patch = 17;
    const Lines lines = linesOf({line, hidden(lineThrough({{1, 2}, {3, 4}}))});
    const json all = json::parse(linesJson(lines, settingsOf({{"hidden", "solid"}})));
    EXPECT_EQ(all.at("size"), json({200, 100}));
    EXPECT_EQ(all.at("camera").at("projection").size(), 4U);
    EXPECT_EQ(all.at("settings").at("hidden"), "solid");
    ASSERT_EQ(all.at("lines").size(), 2U);
    const json& first = all.at("lines").at(0);
    EXPECT_EQ(first.at("type"), "occlusion");
    EXPECT_EQ(first.at("visible"), true);
    EXPECT_EQ(first.at("closed"), true);
    EXPECT_EQ(first.at("object"), 3);
    EXPECT_EQ(first.at("patch"), 17);
    ASSERT_EQ(first.at("pixels").size(), 3U);
    EXPECT_EQ(first.at("pixels").at(0), json({10.123, 20}));
    EXPECT_EQ(first.at("pixels").at(1), json({500, -30})) << "not cut";
    EXPECT_EQ(first.at("positions").at(2), json({2, 40, 60}));
    EXPECT_EQ(all.at("lines").at(1).at("visible"), false);
    EXPECT_EQ(json::parse(linesJson(lines, {})).at("lines").size(), 1U) << "hidden lines are not wanted";
    EXPECT_EQ(json::parse(linesJson(linesOf({}), {})).at("lines").size(), 0U);
}

TEST(WriteLines, choosesTheFormatByTheExtension) {
    const TemporaryFolder folder;
    const Lines lines = linesOf({lineThrough({{1, 1}, {9, 9}})});
    writeLines(lines, {}, folder / "a & b.SVG");
    EXPECT_THAT(contents(folder / "a & b.SVG"), HasSubstr("<title>a &amp; b.SVG</title>"));
    writeLines(lines, {}, folder / "a.json");
    EXPECT_TRUE(json::accept(contents(folder / "a.json")));
    writeLines(lines, {}, folder / "a.Pdf");
    EXPECT_THAT(contents(folder / "a.Pdf"), StartsWith("%PDF-"));
    writeLines(lines, {}, folder / "a.dxf");
    EXPECT_THAT(contents(folder / "a.dxf"), StartsWith("  0\nSECTION\n"));
    EXPECT_TRUE(holdsLines("x/y.svg"));
    EXPECT_TRUE(holdsLines("x/y.pdf"));
    EXPECT_FALSE(holdsLines("x/y.png"));
    expectError(Error::Kind::Usage,
                HasSubstr("expected a file name that ends in .svg, .pdf, .dxf or .json, found '.dwg'"),
                [&] { writeLines(lines, {}, folder / "a.dwg"); });
    expectError(Error::Kind::Output, HasSubstr("cannot be written"),
                [&] { writeLines(lines, {}, folder / "missing" / "a.svg"); });
    EXPECT_EQ(folder.names().size(), 4U);
}

}  // namespace
}  // namespace inkedge::io
