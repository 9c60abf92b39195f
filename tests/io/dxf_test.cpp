#include "io/dxf.h"

#include <map>
#include <numbers>
#include <set>
#include <sstream>

#include <gmock/gmock.h>

#include <inkedge/write.h>

#include "base/expect_error.h"
#include "curves/curves.h"
#include "io/dxf_colors.h"
#include "io/lines_to_write.h"

namespace inkedge::io {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;

struct Group {
    int code;
    std::string value;
};

std::vector<Group> groupsOf(const std::string& dxf) {
    std::vector<Group> groups;
    std::istringstream stream{dxf};
    std::string code;
    std::string value;
    while (std::getline(stream, code) && std::getline(stream, value)) groups.push_back({std::stoi(code), value});
    return groups;
}

// A record: its groups, from one of code 0 to the next.
using Record = std::vector<Group>;
std::vector<Record> recordsOf(const std::string& dxf, const std::string& type) {
    std::vector<Record> records;
    bool wanted = false;
    for (const Group& group : groupsOf(dxf)) {
        if (group.code == 0) {
            wanted = group.value == type;
            if (wanted) records.emplace_back();
        }
        if (wanted) records.back().push_back(group);
    }
    return records;
}

std::vector<std::string> valuesOf(const Record& record, int code) {
    std::vector<std::string> values;
    for (const Group& group : record)
        if (group.code == code) values.push_back(group.value);
    return values;
}

Line hiddenCrease(Line line) { return hidden(typed(std::move(line), LineType::Crease)); }

TEST(LinesDxf, hasALayerATypeAndVisibilityWithItsWidthColourAndDashes) {
    const Lines lines =
        linesOf({curves::lineThrough({{0, 0}, {100, 0}}), hiddenCrease(curves::lineThrough({{0, 9}, {9, 9}}))});
    const std::string dxf = linesDxf(
        lines,
        settingsOf(
            {{"hidden", "dashed"}, {"dpi", "254"}, {"line-width", "0.5mm"}, {"line-style", "crease:color=#f00"}}));
    std::map<std::string, std::vector<std::string>> layers;
    for (const Record& layer : recordsOf(dxf, "LAYER"))
        layers[valuesOf(layer, 2).front()] = {valuesOf(layer, 62).front(), valuesOf(layer, 6).front(),
                                              valuesOf(layer, 370).front()};
    EXPECT_THAT(layers, ElementsAre(Pair("0", ElementsAre("7", "Continuous", "-3")),
                                    Pair("crease-hidden", ElementsAre("1", "HIDDEN2", "25")),
                                    Pair("outline-visible", ElementsAre("7", "Continuous", "50"))));
    const Record dashes = recordsOf(dxf, "LTYPE").back();
    EXPECT_EQ(valuesOf(dashes, 2).front(), "HIDDEN2");
    // Six widths and four, which round tips make seven and three: 0.25 mm each.
    EXPECT_THAT(valuesOf(dashes, 49), ElementsAre("1.75", "-0.75"));
    EXPECT_EQ(valuesOf(dashes, 40).front(), "2.5");
    EXPECT_EQ(valuesOf(recordsOf(dxf, "LWPOLYLINE").front(), 8).front(), "crease-hidden") << "what covers comes last";
}

TEST(LinesDxf, hasOneLineTypeOfDashesAtAScaleForEachPen) {
    const Line outline = hidden(curves::lineThrough({{0, 0}, {100, 0}}));
    const std::string dxf =
        linesDxf(linesOf({outline, hiddenCrease(curves::lineThrough({{0, 9}, {99, 9}}))}),
                 settingsOf({{"hidden", "dashed"}, {"line-width", "2"}, {"line-style", "outline:width=6"}}));
    EXPECT_EQ(recordsOf(dxf, "LTYPE").size(), 4U);
    std::map<std::string, std::vector<std::string>> scales;
    for (const Record& line : recordsOf(dxf, "LWPOLYLINE")) scales[valuesOf(line, 8).front()] = valuesOf(line, 48);
    EXPECT_THAT(scales,
                ElementsAre(Pair("crease-hidden", testing::IsEmpty()), Pair("outline-hidden", ElementsAre("3.0"))));
}

TEST(LinesDxf, isInMillimetresWithYUp) {
    const Lines lines = linesOf({curves::closedThrough({{0, 100}, {200, 100}, {200, 0}})});
    const Record onPaper = recordsOf(linesDxf(lines, settingsOf({{"dpi", "254"}})), "LWPOLYLINE").front();
    EXPECT_THAT(valuesOf(onPaper, 10), ElementsAre("0.0", "20.0", "20.0"));
    EXPECT_THAT(valuesOf(onPaper, 20), ElementsAre("0.0", "0.0", "10.0"));
    EXPECT_EQ(valuesOf(onPaper, 70).front(), "1") << "closed";
    EXPECT_EQ(valuesOf(onPaper, 90).front(), "3");
    const Record onPage = recordsOf(linesDxf(lines, settingsOf({{"page-size", "40mmx40mm"}})), "LWPOLYLINE").front();
    EXPECT_THAT(valuesOf(onPage, 10), ElementsAre("0.0", "40.0", "40.0"));
    EXPECT_THAT(valuesOf(onPage, 20), ElementsAre("10.0", "10.0", "30.0")) << "in its middle";
}

TEST(LinesDxf, hasTheModelsSizeInAnOrthographicView) {
    Lines lines = linesOf({curves::lineThrough({{10, 10}, {110, 10}})});
    lines.camera.orthographicHeight = 0.5;  // 0.005 a pixel
    const auto width = [&](LengthUnit unit, const std::vector<std::pair<std::string, std::string>>& values) {
        lines.source.unit = unit;
        const Record line = recordsOf(linesDxf(lines, settingsOf(values)), "LWPOLYLINE").front();
        return std::stod(valuesOf(line, 10)[1]) - std::stod(valuesOf(line, 10)[0]);
    };
    EXPECT_DOUBLE_EQ(width(LengthUnit::Metre, {}), 500.0);
    EXPECT_DOUBLE_EQ(width(LengthUnit::Inch, {{"dpi", "300"}}), 12.7);
    EXPECT_DOUBLE_EQ(width(LengthUnit::None, {}), 0.5);
    EXPECT_DOUBLE_EQ(width(LengthUnit::Metre, {{"page-size", "400mmx200mm"}}), 200.0) << "on paper";
}

TEST(LinesDxf, numbersEachThingOnce) {
    const std::string dxf =
        linesDxf(linesOf({curves::circle({90, 50}, 40, 30), hiddenCrease(curves::winding(20, 0.1, 2))}),
                 settingsOf({{"hidden", "solid"}}));
    std::set<std::string> handles;
    std::string next;
    for (std::size_t i = 0; const Group& group : groupsOf(dxf)) {
        if (group.code == 5 || group.code == 105) {
            if (i++ == 0)
                next = group.value;  // $HANDSEED
            else
                EXPECT_TRUE(handles.insert(group.value).second) << group.value;
        }
    }
    ASSERT_GT(handles.size(), 20U);
    for (const std::string& handle : handles) EXPECT_LT(std::stoi(handle, nullptr, 16), std::stoi(next, nullptr, 16));
    for (const char* table : {"VPORT", "LTYPE", "LAYER", "STYLE", "VIEW", "UCS", "APPID", "DIMSTYLE", "BLOCK_RECORD"})
        EXPECT_THAT(dxf, HasSubstr("TABLE\n  2\n" + std::string{table} + "\n")) << table;
}

TEST(LinesDxf, isAnEmptyDrawingWithoutLines) {
    const std::string dxf = linesDxf(linesOf({}), {});
    EXPECT_TRUE(recordsOf(dxf, "LWPOLYLINE").empty());
    EXPECT_THAT(dxf, testing::EndsWith("  0\nEOF\n"));
    expectError(Error::Kind::Usage, HasSubstr("at least one pixel"), [] { (void)linesDxf({}, {}); });
}

TEST(LinesDxf, drawsThinPartsAsThinAsTheyAreAndCurvesAsPolylines) {
    Line thin = curves::circle({100, 50}, 40, 200);
    thin.width = 0.5;
    const Settings settings = settingsOf({{"dpi", "254"}, {"line-width", "1mm"}, {"fit-curves", "0.1"}});
    const Record circle = recordsOf(linesDxf(linesOf({thin}), settings), "LWPOLYLINE").front();
    EXPECT_THAT(valuesOf(circle, 370), ElementsAre("50"));
    const auto xs = valuesOf(circle, 10);
    const auto ys = valuesOf(circle, 20);
    ASSERT_GT(xs.size(), 20U);
    for (std::size_t i = 0; i < xs.size(); ++i)
        EXPECT_NEAR(std::hypot(std::stod(xs[i]) - 10.0, std::stod(ys[i]) - 5.0), 4.0, 0.02) << "0.1 px and rounding";
}

TEST(Dxf, hasArcsAsTheyAre) {
    Drawing drawing;
    drawing.page = {{100, 100}, {0, 0}, 25.4, {}};
    Layer layer;
    layer.name = "arcs";
    Path path;
    path.moveTo({10, 50});
    path.arcTo(20, {50, 50});  // clockwise, half a circle: over the top
    path.arcTo(20, {30, 70});
    layer.paths.push_back({path, 1.0, {}});
    drawing.layers.push_back(layer);
    const Record arcs = recordsOf(dxfOf(drawing, 1.0), "LWPOLYLINE").front();
    ASSERT_EQ(valuesOf(arcs, 42).size(), 2U);
    EXPECT_NEAR(std::stod(valuesOf(arcs, 42)[0]), -1.0, 1e-3);
    EXPECT_NEAR(std::stod(valuesOf(arcs, 42)[1]), -std::tan(std::numbers::pi / 8.0), 1e-3);
}

TEST(DxfColor, isTheNearestOfThoseThatThereAre) {
    EXPECT_EQ(dxfColor({0, 0, 0}), 7);
    EXPECT_EQ(dxfColor({255, 255, 255}), 7);
    EXPECT_EQ(dxfColor({255, 0, 0}), 1);
    EXPECT_EQ(dxfColor({0, 0, 250}), 5);
    EXPECT_EQ(dxfColor({128, 128, 128}), 8);
    EXPECT_EQ(dxfColor({255, 127, 0}), 30);
    EXPECT_EQ(dxfColor({0, 76, 0}), 96);
}

TEST(DxfLineWidth, isTheNearestOfThoseThatThereAre) {
    EXPECT_EQ(dxfLineWidth(0.0), 0);
    EXPECT_EQ(dxfLineWidth(0.26), 25);
    EXPECT_EQ(dxfLineWidth(0.5), 50);
    EXPECT_EQ(dxfLineWidth(9.0), 211);
}

}  // namespace
}  // namespace inkedge::io
