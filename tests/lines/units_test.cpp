// The same drawing in any unit of length.
#include <cmath>
#include <limits>

#include <gmock/gmock.h>

#include "lines/see/ray_caster.h"
#include "lines/views.h"

namespace inkedge::lines {
namespace {

using namespace scenes;
using namespace views;

// A box, and a ball and a sheet that it partly hides, all times a scale.
Scene sceneIn(double scale) {
    std::vector<std::pair<Mesh, glm::dmat4>> parts{{box({2, 3, 1}), glm::dmat4{1.0}},
                                                   {sphere(0.9, 48), translation({1.0, 0.4, -1.2})},
                                                   {sheet(4.0, 3), translation({0.0, -1.5, 0.0})}};
    for (auto& [mesh, transform] : parts) {
        for (glm::vec3& p : mesh.positions) p = glm::vec3{scale * glm::dvec3{p}};
        transform[3] = glm::dvec4{scale * glm::dvec3{transform[3]}, 1.0};
    }
    return sceneOf(parts);
}

std::vector<Line> linesIn(const Scene& scene, bool orthographic) {
    CameraSettings view;
    view.azimuthAngle = 24.0;
    view.elevationAngle = 31.0;
    if (orthographic) view.orthographicHeight = 0.0;
    const LineOptions options{.hidden = HiddenLines::Dashed};
    return linesOf(scene, frameCamera(scene, view, options.size), options);
}

TEST(Units, FromTinyToHugeGiveTheSameLines) {
    constexpr double near = 1e-3;  // pixels: positions are floats, and powers of ten round them
    for (const bool orthographic : {false, true}) {
        const std::vector<Line> expected = linesIn(sceneIn(1.0), orthographic);
        ASSERT_GT(expected.size(), 5U);
        for (const double scale : {1e-30, 1e-20, 3e-13, 1e-12, 1e-7, 1e-3, 1e4, 1e7, 1e12, 1e14, 1e20, 1e30}) {
            SCOPED_TRACE(testing::Message() << "scale " << scale << (orthographic ? ", orthographic" : ""));
            const std::vector<Line> found = linesIn(sceneIn(scale), orthographic);
            ASSERT_EQ(found.size(), expected.size());
            for (std::size_t i = 0; i < found.size(); ++i) {
                EXPECT_EQ(found[i].type, expected[i].type);
                EXPECT_EQ(found[i].visible, expected[i].visible);
                ASSERT_EQ(found[i].points.size(), expected[i].points.size());
                for (std::size_t k = 0; k < found[i].points.size(); ++k)
                    EXPECT_LT(glm::distance(found[i].points[k].pixel, expected[i].points[k].pixel), near);
            }
        }
    }
}

// Rays with numbers that are not finite, or of instances that have no inverse in floats, end the process in Embree.
TEST(Units, AtTheEndsOfTheRangeOfFloatsDoNotEndTheProcess) {
    for (const double scale : {1e-44, 1e-40, 1e-36, 1e36, 5e37})
        for (const bool orthographic : {false, true}) EXPECT_NO_THROW((void)linesIn(sceneIn(scale), orthographic));
    for (const double thin : {0.0, 1e-300, 1e-40, 1e-30, 1e-20, 1e-14}) {
        for (const glm::dvec3 scale : {glm::dvec3{1, thin, 1}, glm::dvec3{thin, thin, 1}, glm::dvec3{thin}}) {
            const Scene scene = sceneOf({{cube(), scaling(scale)}, {cube(), translation({0.5, 0.3, 3.0})}});
            EXPECT_NO_THROW((void)linesIn(scene, true)) << thin;
        }
    }
}

TEST(Units, RaysThatAreNoNumbersMeetNothing) {
    const Scene scene = sceneOf(cube());
    const RayCaster rays{scene};
    const Screen screen{perspective({0, 0, 5}), scene.bounds().centre, {400, 300}};
    for (const double wrong :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e30}) {
        EXPECT_FALSE(rays.meets(screen, {wrong, 0, -9}));
        EXPECT_FALSE(rays.hides(screen, {0, wrong, -9}, {}));
        EXPECT_FALSE(rays.meetsBetween({0, 0, wrong}, {0, 0, 0}, [](scene::SceneFace, glm::dvec3) { return true; }));
    }
}

}  // namespace
}  // namespace inkedge::lines
