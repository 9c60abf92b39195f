#include "lines/coincident.h"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <glm/trigonometric.hpp>

#include "lines/views.h"

namespace inkedge::lines {
namespace {

using namespace scenes;
using namespace views;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

constexpr double exact = 1e-6;  // pixels: doubles, from corners that floats hold

// Lines in the plane z = depth before a camera that sees a unit as a pixel: x to the right, y down.
class Plane {
public:
    Plane()
        : camera_{orthographic({200, -150, 100}, 300.0, {200, -150, 0})}, screen_{camera_, glm::dvec3{0.0}, size_} {}

    [[nodiscard]] static Line line(LineType type, std::vector<glm::dvec2> pixels, double depth = 0.0) {
        Line line;
        line.type = type;
        line.object = 1;
        for (const glm::dvec2 pixel : pixels) line.points.push_back({pixel, {pixel.x, -pixel.y, -depth}});
        return line;
    }
    [[nodiscard]] static Line hidden(Line line) {
        line.visible = false;
        return line;
    }
    [[nodiscard]] static Line closed(Line line) {
        line.closed = true;
        return line;
    }
    [[nodiscard]] std::vector<Line> merged(std::vector<Line> lines, LineTypes drawn = standardLineTypes) const {
        PictureSettings picture;
        picture.size = size_;
        picture.lines = drawn;
        picture.lineWidth = {lineWidth, false};
        return mergeCoincident(std::move(lines), picture, screen_, glm::dvec3{0.0});
    }

    double lineWidth = PictureSettings{}.lineWidth.value;

private:
    Size size_{400, 300};
    Camera camera_;
    Screen screen_;
};

void expectPixels(const Line& line, const std::vector<glm::dvec2>& pixels) {
    ASSERT_THAT(line.points, SizeIs(pixels.size()));
    for (std::size_t i = 0; i < pixels.size(); ++i) EXPECT_LT(glm::distance(line.points[i].pixel, pixels[i]), exact);
}

TEST(Coincident, LinesAreOneOfTheNearestSeenOne) {
    const Plane plane;
    const auto far = Plane::line(LineType::Crease, {{10, 20}, {110, 20}}, 5.0);
    auto near = Plane::line(LineType::Crease, {{110, 20.05}, {10, 20.05}}, 1.0);
    near.object = 2;
    for (const auto& lines : {std::vector{far, near}, std::vector{near, far}}) {
        const auto merged = plane.merged(lines);
        ASSERT_THAT(merged, SizeIs(1));
        EXPECT_EQ(merged[0].object, 2U);
    }
}

// More pieces than are compared at once: what has gone before its turn is left out of later comparisons.
TEST(Coincident, OfManyLinesOfManyPiecesTheNearestStays) {
    constexpr int lineCount = 12;
    std::vector<Line> lines;
    for (int i = 0; i < lineCount; ++i) {
        std::vector<glm::dvec2> pixels;
        for (int k = 0; k <= 300; ++k) pixels.emplace_back(20.0 + k + 0.01 * i, 40.0 + 5.0 * std::sin(0.02 * k));
        const bool isSeen = i % 2 == 0;
        const auto line = Plane::line(LineType::Crease, pixels, 50.0 - i);
        lines.push_back(isSeen ? line : Plane::hidden(line));
    }
    const auto merged = Plane{}.merged(lines);
    ASSERT_THAT(merged, Not(IsEmpty()));
    double ofNearest = 0.0;
    double ofOthers = 0.0;
    for (const Line& line : merged)
        (line.visible && line.points[0].position.z == -(50.0 - (lineCount - 2)) ? ofNearest : ofOthers) += length(line);
    EXPECT_NEAR(ofNearest, length(lines[lineCount - 2]), exact);
    EXPECT_EQ(ofOthers, 0.0);
}

TEST(Coincident, LinesTakeTheTypeThatComesFirstWhereTheyRun) {
    const auto merged = Plane{}.merged({Plane::line(LineType::Crease, {{10, 20}, {110, 20}}, 1.0),
                                        Plane::line(LineType::Outline, {{40, 20}, {80, 20}}, 5.0)});
    ASSERT_THAT(merged, SizeIs(3));
    EXPECT_EQ(merged[0].type, LineType::Crease);
    EXPECT_EQ(merged[1].type, LineType::Outline);
    EXPECT_EQ(merged[2].type, LineType::Crease);
    EXPECT_NEAR(length(merged[1]), 40.0, exact);
    EXPECT_NEAR(merged[1].points[0].position.z, -1.0, exact);
    EXPECT_NEAR(length(merged), 100.0, exact);
}

TEST(Coincident, HiddenLinesGoBelowSeenOnesAndKeepTheTypeOfThese) {
    const auto merged = Plane{}.merged({Plane::hidden(Plane::line(LineType::Outline, {{0, 20}, {110, 20}}, 0.0)),
                                        Plane::line(LineType::Crease, {{30, 20}, {110, 20}}, 0.0)});
    ASSERT_THAT(merged, SizeIs(2));
    EXPECT_FALSE(merged[0].visible);
    expectPixels(merged[0], {{0, 20}, {30, 20}});
    EXPECT_EQ(merged[1].type, LineType::Crease);
}

// Each falls on the line that it crosses for a fifth of a pixel, all together for a good part of it.
TEST(Coincident, LinesThatOnlyCrossAreWholeHoweverManyTheyAre) {
    std::vector<Line> lines{Plane::line(LineType::Crease, {{10, 50}, {110, 50}}, 5.0)};
    constexpr int count = 400;
    for (int i = 0; i < count; ++i)
        lines.push_back(Plane::line(LineType::Crease, {{15.0 + 0.2 * i, 49}, {15.1 + 0.2 * i, 51}}, 1.0));
    const auto merged = Plane{}.merged(lines);
    ASSERT_THAT(merged, SizeIs(count + 1));
    expectPixels(merged[0], {{10, 50}, {110, 50}});
}

TEST(Coincident, PartsOfALongLineHoldNoMoreThanTheirPoints) {
    std::vector<glm::dvec2> wave;
    for (int i = 0; i <= 3000; ++i) wave.emplace_back(10.0 + 0.1 * i, 50.0 + 0.02 * (i % 2));
    std::vector<Line> lines{Plane::line(LineType::Crease, wave, 5.0)};
    for (int i = 0; i < 40; ++i)
        lines.push_back(Plane::line(LineType::Crease, {{12.0 + 7.0 * i, 50}, {15.0 + 7.0 * i, 50}}, 1.0));
    const auto merged = Plane{}.merged(lines);
    EXPECT_GT(merged.size(), 75U);
    std::size_t held = 0;
    for (const Line& line : merged) held += line.points.capacity();
    EXPECT_LT(held, 3U * wave.size());
}

TEST(Coincident, OfSeveralHiddenLinesOneStays) {
    std::vector<Line> lines;
    for (int i = 0; i < 5; ++i) lines.push_back(Plane::hidden(Plane::line(LineType::Crease, {{10, 20}, {110, 50}}, i)));
    const auto merged = Plane{}.merged(lines);
    ASSERT_THAT(merged, SizeIs(1));
    EXPECT_EQ(merged[0].points[0].position.z, 0.0);
}

TEST(Coincident, ClosedLinesAreCutOpenWhereOthersRunAndStayWholeElsewhere) {
    const std::vector<glm::dvec2> square{{10, 10}, {110, 10}, {110, 110}, {10, 110}};
    const auto whole = Plane::closed(Plane::line(LineType::Crease, square, 1.0));
    EXPECT_THAT(Plane{}.merged({whole, whole}), SizeIs(1));
    const auto merged = Plane{}.merged({whole, Plane::line(LineType::Outline, {{110, 20}, {110, 90}}, 0.0)});
    ASSERT_THAT(merged, SizeIs(2));
    EXPECT_FALSE(merged[0].closed);
    expectPixels(merged[0], {{110, 90}, {110, 110}, {10, 110}, {10, 10}, {110, 10}, {110, 20}});
}

TEST(Coincident, ALineThatRunsBackOverItselfIsDrawnOnce) {
    const auto merged = Plane{}.merged({Plane::line(LineType::Crease, {{10, 20}, {110, 20}, {30, 20}})});
    EXPECT_NEAR(length(merged), 100.0, 1.5);  // a bend's own pixel stays
}

TEST(Coincident, LinesThatCrossOrMeetOrRunFurtherOffStay) {
    std::vector<Line> lines;
    for (int i = 0; i < 100; ++i)  // as near to each other along the first line as to it
        lines.push_back(Plane::line(LineType::Crease, {{10 + 0.3 * i, 10}, {10 + 0.3 * i, 110}}));
    lines.push_back(Plane::line(LineType::Occlusion, {{0, 50}, {100, 50}}));
    lines.push_back(Plane::line(LineType::Boundary, {{0, 50.15}, {100, 50.15}}));
    lines.push_back(Plane::line(LineType::Outline, {{0, 200}, {100, 200}}));
    lines.push_back(Plane::line(LineType::Outline, {{100, 200}, {200, 210}}));
    const auto merged = Plane{}.merged(lines);
    ASSERT_THAT(merged, SizeIs(lines.size()));
    for (std::size_t i = 0; i < lines.size(); ++i)
        expectPixels(merged[i], {lines[i].points[0].pixel, lines[i].points[1].pixel});
}

TEST(Coincident, LinesThatAreNotDrawnMakeNoneGo) {
    const std::vector<Line> lines{Plane::line(LineType::Outline, {{10, 20}, {110, 20}}),
                                  Plane::line(LineType::Crease, {{10, 20}, {110, 20}})};
    const auto merged = Plane{}.merged(lines, LineType::Crease);
    EXPECT_THAT(thoseOf(merged, LineType::Crease), SizeIs(1));
    EXPECT_THAT(thoseOf(Plane{}.merged(lines), LineType::Crease), IsEmpty());
}

// Where no line is both nearer than the next and within reach of it, the last may not go for one that went itself.
TEST(Coincident, SomeLineStaysWhereverOneWas) {
    std::vector<Line> lines;
    for (int i = 0; i < 40; ++i) {
        const double y = 20 + 0.07 * i;
        lines.push_back(Plane::line(i % 2 == 0 ? LineType::Crease : LineType::Outline, {{10, y}, {110, y}}, 0.07 * i));
    }
    const auto merged = Plane{}.merged(lines);
    EXPECT_LT(merged.size(), lines.size());
    for (const Line& line : lines) {
        const auto near = [&](const Line& other) {
            return std::abs(other.points[0].pixel.y - line.points[0].pixel.y) <= coincidentWithin;
        };
        EXPECT_TRUE(std::ranges::any_of(merged, near)) << line.points[0].pixel.y;
    }
}

// Of a hidden line's pen by default.
constexpr double hiddenPen = 0.75;  // pixels
constexpr double dashAndGap = 7.5;

Line hiddenCircle(double radius, int facets, double turn, double depth) {
    std::vector<glm::dvec2> pixels;
    for (int i = 0; i < facets; ++i) {
        const double angle = 2.0 * std::numbers::pi * (i + turn) / facets;
        pixels.push_back({200.0 + radius * std::cos(angle), 150.0 + 0.4 * radius * std::sin(angle)});
    }
    return Plane::hidden(Plane::closed(Plane::line(LineType::Crease, pixels, depth)));
}

TEST(Coincident, HiddenCirclesOfDifferentFacetsRoundOneHoleAreOne) {
    for (const double radius : {20.0, 50.0, 100.0}) {
        for (const int facets : {24, 32, 37, 48, 64}) {
            const Line nearest = hiddenCircle(radius, 32, 0.0, 1.0);
            const auto merged =
                Plane{}.merged({hiddenCircle(radius, facets, 0.3, 2.0), nearest, hiddenCircle(radius, 40, 0.1, 3.0)});
            EXPECT_NEAR(length(merged), length(nearest), 1e-6) << radius << ", " << facets;
            EXPECT_THAT(merged, SizeIs(1));
        }
    }
}

// Further apart than the pen is wide they are two, but no piece is shorter than dashes need to be seen.
TEST(Coincident, HiddenLinesAreNotCutIntoPiecesShorterThanADashAndItsGap) {
    for (int facets = 5; facets < 60; ++facets) {
        for (const Line& line : Plane{}.merged({hiddenCircle(140, 48, 0.0, 1.0), hiddenCircle(140, facets, 0.2, 2.0)}))
            EXPECT_GE(length(line), dashAndGap) << facets;
    }
}

TEST(Coincident, HiddenLinesAsNearAsTheirPenIsWideAreOne) {
    const auto lines = [&](double apart) {
        return std::vector{Plane::hidden(Plane::line(LineType::Crease, {{10, 20}, {110, 20}})),
                           Plane::hidden(Plane::line(LineType::Crease, {{10, 20 + apart}, {110, 20 + apart}}))};
    };
    EXPECT_THAT(Plane{}.merged(lines(hiddenPen - 0.01)), SizeIs(1));
    EXPECT_THAT(Plane{}.merged(lines(hiddenPen + 0.01)), SizeIs(2));
    Plane wide;
    wide.lineWidth = 8.0;
    EXPECT_THAT(wide.merged(lines(3.9)), SizeIs(1));
    EXPECT_THAT(wide.merged(lines(4.1)), SizeIs(2));
    Plane thin;
    thin.lineWidth = 0.2;
    EXPECT_THAT(thin.merged(lines(0.49)), SizeIs(1));
    EXPECT_THAT(thin.merged(lines(0.51)), SizeIs(2));
}

TEST(Coincident, HiddenLinesThatCrossStayWhole) {
    for (const double angle : {15.0, 30.0, 90.0}) {
        const glm::dvec2 along{std::cos(glm::radians(angle)), std::sin(glm::radians(angle))};
        const glm::dvec2 middle{200, 150};
        const std::vector lines{
            Plane::hidden(Plane::line(LineType::Crease, {{100, 150}, {300, 150}}, 1.0)),
            Plane::hidden(Plane::line(LineType::Crease, {middle - 90.0 * along, middle + 90.0 * along}))};
        EXPECT_NEAR(length(Plane{}.merged(lines)), 380.0, exact) << angle;
    }
}

TEST(Coincident, HiddenLinesThatManyCrossInARowStayWhole) {
    const Plane plane;
    std::vector<Line> lines{Plane::hidden(Plane::line(LineType::Crease, {{10, 100}, {390, 100}}, 5.0))};
    for (int i = 0; i < 150; ++i)  // nearer ones at 45 degrees, so close that together they cover all of the line
        lines.push_back(Plane::hidden(Plane::line(LineType::Crease, {{20.0 + 2 * i, 60}, {100.0 + 2 * i, 140}}, 1.0)));
    const auto merged = plane.merged(lines);
    ASSERT_THAT(merged, SizeIs(151));
    expectPixels(merged[0], {{10, 100}, {390, 100}});
}

TEST(Coincident, AHiddenLineTooShortForADashGoesBelowALongerOneBehindIt) {
    const auto merged =
        Plane{}.merged({Plane::hidden(Plane::line(LineType::Intersection, {{50, 20.3}, {54, 20.4}}, 1.0)),
                        Plane::hidden(Plane::line(LineType::Crease, {{10, 20}, {110, 20}}, 2.0))});
    ASSERT_THAT(merged, SizeIs(1));
    EXPECT_EQ(merged[0].type, LineType::Crease);
}

Settings keeping(HiddenLines hidden, CoincidentLines coincident) {
    Settings settings = settingsOf({.size = {400, 300}, .contour = Contour::Auto, .hidden = hidden});
    settings.lines.coincident = coincident;
    return settings;
}

TEST(Coincident, TheSameMeshTwiceIsDrawnAsOnce) {
    const Scene once = sceneOf(cube(2.0));
    Scene::Data data;
    data.meshes = {cube(2.0)};
    data.instances = {{"a", 0, glm::dmat4{1.0}}, {"b", 0, glm::dmat4{1.0}}};
    const Scene twice{std::move(data)};
    const Camera camera = perspective({5, 4, 7});
    for (const HiddenLines hidden : {HiddenLines::None, HiddenLines::Dashed}) {
        const auto merge = keeping(hidden, CoincidentLines::Merge);
        const double right = length(ObjectLines{once}.find(camera, merge).lines);
        EXPECT_NEAR(length(ObjectLines{twice}.find(camera, merge).lines), right, exact);
        const auto keep = keeping(hidden, CoincidentLines::Keep);
        EXPECT_NEAR(length(ObjectLines{twice}.find(camera, keep).lines), 2.0 * right, exact);
    }
}

// Boards side by side, and boards that lie on each other, as one mesh or as many.
TEST(Coincident, APlanOfEqualBoardsHasEveryLineOnce) {
    constexpr int across = 8;
    constexpr int layers = 5;
    const glm::dvec3 board{0.25, 0.1, 1.5};
    std::vector<std::pair<Mesh, glm::dmat4>> boards;
    for (int i = 0; i < across * layers; ++i)
        boards.emplace_back(box(board), translation(board * glm::dvec3{i % across - 3.5, i / across, 0.0}));
    const Scene scene = sceneOf(boards);
    constexpr double pixels = 300.0 / 2.0;  // a unit
    constexpr double ends = 1.0;            // pixels: at the ends of lines, whose corners are rounded to floats
    const auto isHidden = [](const Line& line) { return !line.visible; };
    for (const HiddenLines hidden : {HiddenLines::None, HiddenLines::Dashed}) {
        const auto settings = keeping(hidden, CoincidentLines::Merge);
        const auto plan = ObjectLines{scene}.find(orthographic({0, 5, 0}, 2.0), settings).lines;
        EXPECT_NEAR(length(plan), pixels * (2.0 * across * board.x + (across + 1) * board.z), ends);
        EXPECT_NEAR(length(thoseOf(plan, isHidden)), 0.0, exact);
        const auto front = ObjectLines{scene}.find(orthographic({0, 0.2, 5}, 2.0, {0, 0.2, 0}), settings).lines;
        EXPECT_NEAR(length(front), pixels * ((layers + 1) * across * board.x + (across + 1) * layers * board.y), ends);
        EXPECT_NEAR(length(thoseOf(front, isHidden)), 0.0, exact);
    }
}

}  // namespace
}  // namespace inkedge::lines
