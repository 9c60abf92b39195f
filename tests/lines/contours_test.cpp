#include "lines/find/contours.h"

#include <map>

#include <gmock/gmock.h>

#include "lines/views.h"

namespace inkedge::lines {
namespace {

using namespace scenes;
using namespace views;

std::vector<glm::dvec3> pointsOf(const std::vector<Line>& lines) {
    std::vector<glm::dvec3> points;
    for (const Line& line : lines)
        for (const LinePoint& p : line.points) points.push_back(p.position);
    return points;
}

std::vector<glm::dvec3> contourOf(const Scene& scene, double height, Contour contour, std::uint32_t object = 1) {
    const Camera camera = orthographic({2, 3, 9}, height);
    return pointsOf(
        thoseOf(linesOf(scene, camera, {.contour = contour}), [&](const Line& line) { return line.object == object; }));
}

// Contour edges of a sphere of 64 segments are a fifteenth long or less: over 3 of 300 pixels for pictures of some 7
// and less.
constexpr double small = 20.0;
constexpr double large = 3.0;

TEST(Contours, OfSmallFacesAreSmoothThoseOfLargeOnesTheMeshs) {
    const Scene scene = sceneOf(sphere(1.0, 64));
    for (const double height : {small, large}) {
        const auto chosen = contourOf(scene, height, Contour::Auto);
        EXPECT_EQ(chosen, contourOf(scene, height, height == small ? Contour::Smooth : Contour::Mesh)) << height;
        EXPECT_NE(chosen, contourOf(scene, height, height == small ? Contour::Mesh : Contour::Smooth)) << height;
    }
}

TEST(Contours, AreChosenForEachPatch) {
    const Scene scene =
        sceneOf({{sphere(1.0, 64), translation({-2, 0, 0})}, {sphere(1.0, 12), translation({2, 0, 0})}});
    EXPECT_EQ(contourOf(scene, small, Contour::Auto, 1), contourOf(scene, small, Contour::Smooth, 1));
    EXPECT_EQ(contourOf(scene, small, Contour::Auto, 2), contourOf(scene, small, Contour::Mesh, 2));
    EXPECT_NE(contourOf(scene, small, Contour::Auto, 2), contourOf(scene, small, Contour::Smooth, 2));
}

// Pixels of each type, seen and hidden.
std::map<std::pair<LineType, bool>, double> lengths(const std::vector<Line>& lines) {
    std::map<std::pair<LineType, bool>, double> sums;
    for (const Line& line : lines) sums[{line.type, line.visible}] += length(line);
    return sums;
}

TEST(Contours, OfAMirroredInstanceAreThoseOfTheOtherSeenInAMirror) {
    glm::dmat4 mirror{1.0};
    mirror[0][0] = -1.0;
    const glm::dmat4 transform = rotation(25, {1, 2, 3});
    const std::vector<Mesh> meshes{torus(2.0, 0.8, 60, 24), box({1, 2, 3}), sheet(3.0, 4)};
    for (const Mesh& mesh : meshes) {
        const Scene scene = sceneOf(mesh, transform);
        const Scene mirrored = sceneOf(mesh, mirror * transform);
        for (const Contour contour : {Contour::Mesh, Contour::Smooth, Contour::Auto}) {
            for (const HiddenLines hidden : {HiddenLines::None, HiddenLines::Solid}) {
                const LineOptions options{.contour = contour, .hidden = hidden};
                const auto expected = lengths(linesOf(scene, perspective({5, 4, 7}), options));
                const auto found = lengths(linesOf(mirrored, perspective({-5, 4, 7}), options));
                ASSERT_EQ(found.size(), expected.size()) << mesh.name;
                for (const auto& [what, pixels] : expected) {
                    ASSERT_TRUE(found.contains(what)) << mesh.name;
                    EXPECT_NEAR(found.at(what), pixels, 0.5) << mesh.name;  // ends are found to a quarter
                }
            }
        }
    }
}

}  // namespace
}  // namespace inkedge::lines
