#include <inkedge/compare_lines.h>

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <inkedge/error.h>
#include <inkedge/write.h>

#include "base/expect_error.h"
#include "base/temporary_folder.h"
#include "io/lines_to_write.h"

namespace inkedge {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr Size size{200, 160};

ComparedLine straight(glm::dvec2 a, glm::dvec2 b, LineType type = LineType::Crease) {
    return {type, true, false, 1, {a, b}};
}

ComparedLine circle(glm::dvec2 centre, double radius, int corners = 64) {
    ComparedLine line{LineType::Crease, true, true, 1, {}};
    for (int i = 0; i < corners; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / corners;
        line.points.push_back(centre + radius * glm::dvec2{std::cos(angle), std::sin(angle)});
    }
    return line;
}

// A plate with a hole, a chamfer's edge and a ridge.
ComparedLines plate() {
    ComparedLines all{.lines = {}, .size = size, .objects = {{1, "plate"}}};
    all.lines = {{LineType::Outline, true, true, 1, {{20, 20}, {180, 20}, {180, 140}, {20, 140}}},
                 circle({70, 80}, 25),
                 straight({30, 30}, {170, 30}),
                 straight({120, 60}, {120, 120})};
    return all;
}

TEST(CompareLines, OfTheSameFindsNoChange) {
    ComparedLines moved = plate();
    for (ComparedLine& line : moved.lines)
        for (glm::dvec2& point : line.points) point += glm::dvec2{0.9, -1.0};
    const LinesComparison found = compareLines(plate(), moved);
    EXPECT_TRUE(found.same);
    EXPECT_THAT(found.changes, IsEmpty()) << comparisonText(found);
    EXPECT_EQ(found.specks, 0);
    EXPECT_NEAR(found.lengthBefore, 560.0 + 157.0 + 140.0 + 60.0, 0.5);
}

TEST(CompareLines, SayHowFarAHoleMoved) {
    ComparedLines after = plate();
    after.lines[1] = circle({72, 80}, 25, 60);
    const LinesComparison found = compareLines(plate(), after);
    ASSERT_EQ(found.changes.size(), 1) << comparisonText(found);
    const LineChange& change = found.changes[0];
    EXPECT_EQ(change.kind, LineChangeKind::Moved);
    EXPECT_EQ(change.type, LineType::Crease);
    EXPECT_EQ(change.objectName, "plate");
    EXPECT_NEAR(change.distance, 2.0, 0.05);
    ASSERT_TRUE(change.way);
    EXPECT_NEAR(change.way->x, 2.0, 0.05);
    EXPECT_NEAR(change.way->y, 0.0, 0.05);
    EXPECT_NEAR(change.length, 157.0, 0.5) << "all around, not only where it moved across itself";
    EXPECT_FALSE(found.same);
    EXPECT_NEAR(found.share, 157.0 / 917.0, 0.001);
    EXPECT_THAT(comparisonText(found), HasSubstr("moved      crease of plate, 157.0 px, by 2.0 px (2.0 right, 0.0 "));
}

TEST(CompareLines, OfAStraightLineKnowTheWayAcross) {
    ComparedLines after = plate();
    after.lines[3] = straight({123, 62}, {123, 118});
    const LinesComparison found = compareLines(plate(), after);
    ASSERT_EQ(found.changes.size(), 1) << comparisonText(found);
    EXPECT_EQ(found.changes[0].kind, LineChangeKind::Moved);
    ASSERT_TRUE(found.changes[0].way);
    EXPECT_NEAR(found.changes[0].way->x, 3.0, 1e-6);
    EXPECT_NEAR(found.changes[0].way->y, 0.0, 1e-6);
}

TEST(CompareLines, LeaveTheSideOfAnLWhereItIs) {
    ComparedLines before = plate();
    ComparedLines after = plate();
    before.lines[3] = {LineType::Crease, true, false, 1, {{120, 60}, {120, 120}, {136, 120}}};
    after.lines[3] = {LineType::Crease, true, false, 1, {{120, 60}, {120, 125}, {136, 125}}};
    const LinesComparison found = compareLines(before, after);
    ASSERT_FALSE(found.changes.empty());
    for (const LineChange& change : found.changes) EXPECT_LT(change.length, 20.0) << comparisonText(found);
}

TEST(CompareLines, NameWhatVanishedAndAppeared) {
    ComparedLines after = plate();
    after.lines.pop_back();
    after.lines.push_back(straight({150, 60}, {150, 100}, LineType::Boundary));
    const LinesComparison found = compareLines(plate(), after);
    ASSERT_EQ(found.changes.size(), 2) << comparisonText(found);
    EXPECT_EQ(found.changes[0].kind, LineChangeKind::Vanished);
    EXPECT_NEAR(found.changes[0].length, 60.0, 1e-6);
    EXPECT_EQ(found.changes[1].kind, LineChangeKind::Appeared);
    EXPECT_EQ(found.changes[1].type, LineType::Boundary);
    EXPECT_NEAR(found.changes[1].length, 40.0, 1e-6);
    ASSERT_EQ(found.changes[1].after.size(), 1);
    EXPECT_THAT(found.changes[1].after[0].points, ElementsAre(glm::dvec2{150, 60}, glm::dvec2{150, 100}));
}

TEST(CompareLines, GiveThePartOfALineThatVanished) {
    ComparedLines after = plate();
    after.lines[3] = straight({120, 60}, {120, 90});
    const LinesComparison found = compareLines(plate(), after);
    ASSERT_EQ(found.changes.size(), 1) << comparisonText(found);
    EXPECT_NEAR(found.changes[0].length, 30.0 - 1.5, 0.5) << "up to the distance beyond its end it is the same";
}

TEST(CompareLines, JoinWhatOtherLinesCross) {
    ComparedLines before = plate();
    before.lines.push_back(straight({40, 100}, {160, 100}, LineType::Occlusion));  // across the hole and the ridge
    before.lines.push_back({LineType::Occlusion, true, false, 1, {{160, 100}, {160, 130}}});
    const LinesComparison found = compareLines(before, plate());
    ASSERT_EQ(found.changes.size(), 2) << comparisonText(found);
    EXPECT_NEAR(found.changes[0].length, 120.0, 1e-6);
    EXPECT_NEAR(found.changes[1].length, 30.0, 1e-6) << "around a corner is another line";
}

TEST(CompareLines, SeeOtherTypesAndVisibility) {
    ComparedLines after = plate();
    after.lines[2].type = LineType::Boundary;
    ComparedLines before = plate();
    before.lines[3].visible = false;
    const LinesComparison found = compareLines(before, after);
    ASSERT_EQ(found.changes.size(), 2) << comparisonText(found);
    EXPECT_EQ(found.changes[0].kind, LineChangeKind::Retyped);
    EXPECT_EQ(found.changes[0].typeBefore, LineType::Crease);
    EXPECT_EQ(found.changes[0].type, LineType::Boundary);
    EXPECT_EQ(found.changes[1].kind, LineChangeKind::Visibility);
    EXPECT_FALSE(found.changes[1].visibleBefore);
    EXPECT_THAT(comparisonText(found), HasSubstr("now seen   crease of plate, was hidden crease, 60.0 px"));
}

TEST(CompareLines, TakeACoveredLineForTheSame) {
    ComparedLines before = plate();
    before.lines.push_back(straight({20, 20.5}, {180, 20.5}));  // beside the outline, which is left
    EXPECT_THAT(compareLines(before, plate()).changes, IsEmpty());
    EXPECT_THAT(compareLines(plate(), before).changes, IsEmpty());
}

TEST(CompareLines, KnowNothingOfTypesInPictures) {
    ComparedLines picture = plate();
    for (ComparedLine& line : picture.lines) line.type.reset();
    EXPECT_THAT(compareLines(picture, plate()).changes, IsEmpty());
}

TEST(CompareLines, LeaveSpecksOutAndCountThem) {
    ComparedLines after = plate();
    after.lines.push_back(straight({150, 60}, {153, 60}));
    LineTolerance tolerance;
    const LinesComparison found = compareLines(plate(), after, tolerance);
    EXPECT_TRUE(found.same);
    EXPECT_EQ(found.specks, 1);
    EXPECT_NEAR(found.speckLength, 3.0, 1e-9);
    EXPECT_THAT(comparisonText(found), HasSubstr("left out   1 speck under 4 px, 3.0 px together"));
    tolerance.speck = 2.0;
    EXPECT_FALSE(compareLines(plate(), after, tolerance).same);
}

TEST(CompareLines, AllowAShare) {
    ComparedLines after = plate();
    after.lines.pop_back();
    LineTolerance tolerance{.share = 0.06};
    EXPECT_FALSE(compareLines(plate(), after, tolerance).same) << "60 of 917 are 0.065";
    tolerance.share = 0.07;
    EXPECT_TRUE(compareLines(plate(), after, tolerance).same);
}

TEST(CompareLines, IgnoreHiddenOnesThatStayHidden) {
    ComparedLines before = plate();
    ComparedLines after = plate();
    before.lines[3].visible = false;
    after.lines.push_back({LineType::Crease, false, false, 1, {{140, 60}, {140, 120}}});
    const LinesComparison found = compareLines(before, after, {.hidden = HiddenChanges::Ignore});
    ASSERT_EQ(found.changes.size(), 1) << comparisonText(found);
    EXPECT_EQ(found.changes[0].kind, LineChangeKind::Visibility);
    EXPECT_NEAR(found.lengthBefore, 917.0 - 60.0, 0.5);
}

TEST(CompareLines, OfNothing) {
    const ComparedLines none{.lines = {}, .size = size, .objects = {}};
    EXPECT_TRUE(compareLines(none, none).same);
    EXPECT_NEAR(compareLines(none, plate()).share, 1.0, 1e-9);
    EXPECT_NEAR(compareLines(plate(), none).share, 1.0, 1e-9);
}

TEST(CompareLines, RefuseOtherSizesAndNumbers) {
    ComparedLines other = plate();
    other.size = {200, 100};
    expectError(Error::Kind::Input, HasSubstr("200 x 160 and 200 x 100"), [&] { (void)compareLines(plate(), other); });
    expectError(Error::Kind::Usage, HasSubstr("distance: expected a number over 0"),
                [&] { (void)compareLines(plate(), plate(), {.distance = 0.0}); });
    expectError(Error::Kind::Usage, HasSubstr("speck: expected"),
                [&] { (void)compareLines(plate(), plate(), {.speck = -1.0}); });
}

TEST(CompareLines, AreTheSameReadFromSvgAndJson) {
    Lines lines = io::linesOf({}, size);
    lines.names.instances = {{.id = 1, .node = "plate & <bolt>", .mesh = "", .materials = {}, .transform = {}}};
    for (const ComparedLine& compared : plate().lines) {
        Line& line = lines.lines.emplace_back();
        line.type = *compared.type;
        line.closed = compared.closed;
        line.object = 1;
        line.visible = compared.closed;  // the straight ones are hidden
        for (const glm::dvec2& point : compared.points) line.points.push_back({point, {}});
    }
    const TemporaryFolder folder;
    for (const double curves : {0.0, 0.5}) {
        Settings settings;
        settings.lines.hidden = HiddenLines::Dashed;
        settings.lines.fitCurves = curves;
        writeLines(lines, settings, folder / "lines.svg");
        writeLines(lines, settings, folder / "lines.json");
        const ComparedLines svg = readComparedLines(folder / "lines.svg");
        const LinesComparison found = compareLines(readComparedLines(folder / "lines.json"), svg, {.distance = 0.75});
        EXPECT_THAT(found.changes, IsEmpty()) << comparisonText(found);
        EXPECT_NEAR(found.lengthAfter, found.lengthBefore, 1.0);
        EXPECT_EQ(svg.objects.at(1), "plate & <bolt>");
    }
    Settings varying;
    varying.lines.strokeTaper = 10.0;
    writeLines(lines, varying, folder / "varying.svg");
    expectError(Error::Kind::Input, HasSubstr("expected lines, found outlines of them"),
                [&] { (void)readComparedLines(folder / "varying.svg"); });
}

TEST(CompareLines, AreDrawnAndWrittenAsJson) {
    ComparedLines after = plate();
    after.lines[1] = circle({72, 80}, 25);
    after.lines.pop_back();
    after.lines.push_back(straight({150, 60}, {150, 100}));
    const LinesComparison found = compareLines(plate(), after);
    const auto json = nlohmann::json::parse(comparisonJson(found));
    EXPECT_EQ(json.at("changes").at(0).at("change"), "moved");
    EXPECT_NEAR(json.at("changes").at(0).at("distance").get<double>(), 2.0, 0.05);
    EXPECT_EQ(json.at("changes").at(2).at("after").at(0).at("pixels"), nlohmann::json::parse("[[150,60],[150,100]]"));
    const TemporaryFolder folder;
    writeComparison(found, folder / "changes.svg");
    writeComparison(found, folder / "changes.pdf");
    writeComparison(found, folder / "changes.png");
    expectError(Error::Kind::Usage, HasSubstr(".svg, .pdf or"),
                [&] { writeComparison(found, folder / "changes.dxf"); });
}

}  // namespace
}  // namespace inkedge
