// Strips narrower than a sample, between a crease and where its surface ends: both lines are whole, the crease as wide
// as the strip.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <glm/geometric.hpp>

#include "gl/gl_test.h"
#include "scenes.h"

namespace inkedge::trace {
namespace {

INKEDGE_ON_EACH_BACKEND(Strips);

constexpr Size square{240, 240};
constexpr double pixel = 0.02;

Camera cameraFrom(const glm::dmat4& turn) {
    Camera camera;
    camera.view = scenes::translation({0, 0, -10}) * turn;
    camera.orthographicHeight = pixel * square.height;
    camera.near = 2.0;
    camera.far = 18.0;
    return camera;
}

Settings fromImage() {
    Settings settings;
    settings.picture.size = square;
    settings.lines.from = LinesFrom::Image;
    return settings;
}

double lengthOf(const Line& line) {
    double length = line.closed ? glm::distance(line.points.front().pixel, line.points.back().pixel) : 0.0;
    for (std::size_t i = 1; i < line.points.size(); ++i)
        length += glm::distance(line.points[i - 1].pixel, line.points[i].pixel);
    return length;
}

std::vector<double> lengthsOf(const Lines& lines) {
    std::vector<double> lengths;
    for (const Line& line : lines.lines) lengths.push_back(lengthOf(line));
    return lengths;
}

constexpr double slabWidth = 2.4;
constexpr double slabHeight = 1.4;
constexpr double wallSide = 4.0;

// A slab before a wall, turned so that one of its narrow sides is seen as a strip of some pixels along its lower edge.
struct Slab {
    double strip;
    double gap;
};

Scene sceneOf(const Slab& slab) {
    constexpr double depth = 0.2;
    const double turn = -std::asin(slab.strip * pixel / depth) * 180.0 / std::numbers::pi;
    const Mesh wall = scenes::box({wallSide, wallSide, depth});
    const glm::dmat4 pose = scenes::rotation(7.0, {0, 0, 1}) * scenes::rotation(turn, {1, 0, 0});
    return scenes::sceneOf(
        {{scenes::box({slabWidth, slabHeight, depth}), pose * scenes::translation({0, 0, 0.5 * depth + slab.gap})},
         {wall, pose * scenes::translation({0, 0, -0.5 * depth})}});
}

// The sums of the lengths of lines as wide as their pen, and of narrower ones.
struct Sums {
    double wide = 0.0;
    double narrow = 0.0;
};

Sums sumsOf(const Lines& lines) {
    Sums sums;
    for (const Line& line : lines.lines) (line.width < 1.0 ? sums.narrow : sums.wide) += lengthOf(line);
    return sums;
}

constexpr double outlines = 2.0 * (slabWidth + slabHeight + 2.0 * wallSide) / pixel;
constexpr double creases = (slabWidth + wallSide) / pixel;

TEST_P(Strips, underASampleHaveACreaseThatIsWholeAndAsWideAsTheyAre) {
    const Camera camera = cameraFrom(glm::dmat4{1.0});
    for (const double strip : {0.1, 0.25, 0.5, 0.8}) {
        for (const double gap : {0.0, 0.002, 0.05}) {
            SCOPED_TRACE(testing::Message() << strip << " pixels, a gap of " << gap);
            const Lines lines = renderer().lines(sceneOf({strip, gap}), camera, fromImage());
            EXPECT_THAT(lengthsOf(lines), testing::Each(testing::Gt(20.0))) << "no dashes";
            EXPECT_NEAR(sumsOf(lines).wide, outlines, 12.0);
            EXPECT_NEAR(sumsOf(lines).narrow, creases, 12.0);
            for (const Line& line : lines.lines) {
                if (line.width == 1.0) continue;
                EXPECT_NEAR(line.width, strip, 0.02 + 0.02 * strip);
            }
        }
    }
}

TEST_P(Strips, ofASampleAndMoreHaveTwoLines) {
    const Lines lines = renderer().lines(sceneOf({1.3, 0.002}), cameraFrom(glm::dmat4{1.0}), fromImage());
    EXPECT_NEAR(sumsOf(lines).wide, outlines + creases, 20.0);
    EXPECT_EQ(sumsOf(lines).narrow, 0.0);
}

TEST_P(Strips, ofContactFacesSeenAlmostEdgeOnLeaveNoSpecks) {
    const Mesh base = scenes::box({3.0, 0.8, 2.0});
    const Mesh block = scenes::box({1.0, 0.6, 0.9});
    const Scene scene = scenes::sceneOf({{base, scenes::translation({0, -0.4, 0})},
                                         {block, scenes::translation({-0.8, 0.3, 0.2})},
                                         {block, scenes::translation({0.7, 0.3, -0.3})}});
    for (const double azimuth : {0.0, 10.0, 37.0}) {
        for (const bool perspective : {false, true}) {
            const auto linesAt = [&](double elevation) {
                Camera camera =
                    cameraFrom(scenes::rotation(elevation, {1, 0, 0}) * scenes::rotation(-azimuth, {0, 1, 0}));
                if (perspective) camera.orthographicHeight = 0.0;
                return renderer().lines(scene, camera, fromImage());
            };
            for (const double elevation : {-0.02, 0.02}) {
                SCOPED_TRACE(testing::Message()
                             << azimuth << ", " << elevation << (perspective ? ", perspective" : ""));
                EXPECT_THAT(lengthsOf(linesAt(elevation)), testing::Each(testing::Gt(4.0)));
                EXPECT_NEAR(sumsOf(linesAt(elevation)).wide, sumsOf(linesAt(0.0)).wide, 6.0)
                    << "as seen exactly edge-on";
            }
        }
    }
}

}  // namespace
}  // namespace inkedge::trace
