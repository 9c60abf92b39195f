#include <inkedge/views.h>

#include <cmath>
#include <fstream>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <inkedge/error.h>

#include "base/expect_error.h"
#include "base/temporary_folder.h"

namespace inkedge::camera {
namespace {

using testing::HasSubstr;
using testing::SizeIs;

glm::dvec3 towardsCamera(const CameraSettings& camera) {
    const double azimuth = glm::radians(camera.azimuthAngle.value());
    const double elevation = glm::radians(camera.elevationAngle.value());
    return {std::cos(elevation) * std::sin(azimuth), std::sin(elevation), std::cos(elevation) * std::cos(azimuth)};
}

TEST(Turntable, GoesRoundEvenlyFromTheBasesAzimuth) {
    CameraSettings base;
    base.azimuthAngle = 10.0;
    base.elevationAngle = 20.0;
    const std::vector<View> views = viewsOf("turntable:8", base);
    ASSERT_THAT(views, SizeIs(8));
    for (std::size_t i = 0; i < 8; ++i) {
        EXPECT_EQ(views[i].name, fmt::format("{:03}", i));
        EXPECT_DOUBLE_EQ(*views[i].camera.azimuthAngle, 10.0 + 45.0 * static_cast<double>(i));
        EXPECT_EQ(views[i].camera.elevationAngle, base.elevationAngle);
    }
    EXPECT_EQ(viewsOf("turntable:1", {}).front().camera.azimuthAngle, 0.0);
    EXPECT_EQ(viewsOf("turntable:20000", {}).back().name, "19999");
}

TEST(SphereOfViews, SpreadsEvenly) {
    constexpr std::size_t count = 200;
    const std::vector<View> views = viewsOf("sphere:200", {});
    glm::dvec3 sum{0.0};
    double nearest = 2.0;
    for (std::size_t i = 0; i < count; ++i) {
        sum += towardsCamera(views[i].camera);
        for (std::size_t k = 0; k < i; ++k)
            nearest = std::min(nearest, glm::distance(towardsCamera(views[i].camera), towardsCamera(views[k].camera)));
    }
    EXPECT_LE(glm::length(sum) / count, 0.01);
    // Of a hexagonal packing of as many points the distance is sqrt(8 pi / (sqrt(3) n)); the lattice keeps most of it.
    EXPECT_GE(nearest, 0.75 * std::sqrt(8.0 * M_PI / (std::sqrt(3.0) * count)));
}

TEST(RandomViews, AreTheSameForTheSameSeedAndSpreadOverTheSphere) {
    constexpr std::size_t count = 4000;
    const std::vector<View> views = viewsOf("random:4000:7", {});
    ASSERT_THAT(views, SizeIs(count));
    EXPECT_EQ(views[17].name, "0017");
    // 64 bits of mt19937_64 are the standard's; the first of seed 7 by another program: azimuth, then elevation.
    EXPECT_DOUBLE_EQ(*views[0].camera.azimuthAngle, 271.5787094950289);
    EXPECT_DOUBLE_EQ(*views[0].camera.elevationAngle, 63.97496350620857);
    glm::dvec3 sum{0.0};
    std::size_t above30 = 0;
    for (const View& view : views) {
        sum += towardsCamera(view.camera);
        if (*view.camera.elevationAngle > 30.0) ++above30;
    }
    // Sums of so many unit vectors lie within 4 standard deviations, 4 / sqrt(3 n) a component, of their mean, 0; a
    // quarter of a sphere lies above 30 degrees.
    EXPECT_LE(glm::length(sum) / count, 4.0 / std::sqrt(static_cast<double>(count)));
    EXPECT_NEAR(static_cast<double>(above30), 0.25 * count, 4.0 * std::sqrt(0.25 * 0.75 * count));
    EXPECT_NE(viewsOf("random:1:8", {})[0].camera.azimuthAngle, views[0].camera.azimuthAngle);
    EXPECT_EQ(viewsOf("random:3", {})[2].camera.azimuthAngle, viewsOf("random:3:0", {})[2].camera.azimuthAngle);
    EXPECT_THAT(viewsOf("turntable:2,random:2:1", {}), SizeIs(4));
    for (const char* wrong : {"random:2:", "random:2:x", "random:2:-1", "random:2:1:1"})
        expectError(Error::Kind::Usage, HasSubstr("expected a whole number as the seed of random views, found"),
                    [&] { static_cast<void>(viewsOf(wrong, {})); });
}

TEST(NamedViews, StandInAListWithTurntablesAndSpheres) {
    CameraSettings base;
    base.elevationAngle = 12.0;
    const std::vector<View> views = viewsOf("top,turntable:2,iso,sphere:3", base);
    std::vector<std::string> names;
    for (const View& view : views) {
        names.push_back(view.name);
        EXPECT_EQ(view.camera.orthographicHeight, 0.0) << "all as the named ones";
    }
    EXPECT_THAT(names, testing::ElementsAre("top", "000", "001", "iso", "002", "003", "004"));
    EXPECT_EQ(views[0].camera.view, NamedView::Top);
    EXPECT_EQ(views[0].camera.elevationAngle, std::nullopt);
    EXPECT_EQ(views[2].camera.azimuthAngle, 180.0);
    EXPECT_EQ(views[2].camera.elevationAngle, 12.0);
    EXPECT_EQ(views[2].camera.view, std::nullopt);
    EXPECT_TRUE(framedTogether(views));
    EXPECT_FALSE(framedTogether(viewsOf("top", {})));
    EXPECT_FALSE(framedTogether(viewsOf("turntable:4", {})));
    base = {};
    base.viewAngle = 30.0;
    EXPECT_EQ(viewsOf("front,back", base)[1].camera.orthographicHeight, std::nullopt);
    EXPECT_EQ(viewsOf("turntable:2,sphere:1", {})[0].camera.orthographicHeight, std::nullopt);
}

TEST(NamedViews, AreRefusedWithWhatIsWrong) {
    const auto refused = [](const std::string& text, const std::string& message, const CameraSettings& base = {}) {
        expectError(Error::Kind::Usage, HasSubstr(message), [&] { static_cast<void>(viewsOf(text, base)); });
    };
    refused("front,rigth",
            "--views: expected front, back, left, right, top, bottom, iso, dimetric, turntable:N, "
            "sphere:N or random:N:SEED, found 'rigth'");
    refused("front,", "found ''");
    refused("front,top,front", "--views: expected each view once, found 'front' again");
    refused("front,turntable:0", "--views: expected a number of views from 1 to 1000000");
    refused("turntable:1000000,front", "--views: expected at most 1000000 views, found more");
    CameraSettings base;
    base.azimuthAngle = 1.0;
    refused("front,top", "--views: expected no azimuth or elevation angle beside 'front,top', found one", base);
    EXPECT_NO_THROW(static_cast<void>(viewsOf("front,turntable:2", base)));
    base = {};
    base.view = NamedView::Iso;
    refused("front,top", "--view beside 'front,top', found one", base);
}

class ViewsFile : public testing::Test {
protected:
    [[nodiscard]] std::string file(const std::string& content) const {
        std::ofstream{folder_ / "views.json"} << content;
        return folder_ / "views.json";
    }
    void expectRefusal(const std::string& content, const std::string& message) const {
        expectError(Error::Kind::Usage, HasSubstr(message), [&] { static_cast<void>(viewsOf(file(content), {})); });
    }
    TemporaryFolder folder_;
};

TEST_F(ViewsFile, SetsWhatItNamesAndLeavesTheRestAsItIs) {
    CameraSettings base;
    base.viewAngle = 50.0;
    const auto views = viewsOf(
        file(
            R"([{"name": "front", "camera-azimuth-angle": 0}, {"camera-position": [1, 2, 3.5], "camera-view-angle": "20"}])"),
        base);
    ASSERT_THAT(views, SizeIs(2));
    EXPECT_EQ(views[0].name, "front");
    EXPECT_EQ(views[0].camera.azimuthAngle, 0.0);
    EXPECT_EQ(views[0].camera.viewAngle, 50.0);
    EXPECT_EQ(views[1].name, "001");
    EXPECT_EQ(views[1].camera.position, glm::dvec3(1, 2, 3.5));
    EXPECT_EQ(views[1].camera.viewAngle, 20.0);
}

TEST_F(ViewsFile, TakesNamedViews) {
    const auto views = viewsOf(file(R"([{"view": "iso"}, {"name": "a", "view": "top", "camera-view-angle": 20}])"), {});
    EXPECT_EQ(views[0].camera.view, NamedView::Iso);
    EXPECT_EQ(views[1].camera.view, NamedView::Top);
    expectRefusal(R"([{"view": "side"}])", "view 0: view: expected one of front, back, left, right, top, bottom, iso");
}

TEST_F(ViewsFile, IsRefusedWithTheViewThatIsWrong) {
    expectRefusal("{}", "expected a JSON list of 1 to 1000000 views, found object");
    expectRefusal("[]", "found 0");
    expectRefusal("[", "expected a JSON list of views, found something else");
    expectRefusal("[3]", "view 0: expected an object, found number");
    expectRefusal(R"([{}, {"size": "3x3"}])",
                  "view 1: expected name or a camera setting, as azimuth or camera-position, found 'size'");
    expectRefusal(R"([{"camera-position": [1, 2]}])",
                  "view 0: camera-position: expected three numbers x,y,z, found '1,2'");
    expectRefusal(R"([{"name": "../up"}])", "view 0: name: expected letters, digits, -, _ and ., found \"../up\"");
    expectRefusal(R"([{"name": "a"}, {"name": "a"}])", "view 1: expected a name of its own, found 'a' again");
}

TEST(ViewsText, IsRefusedWhenItNamesNothing) {
    expectError(Error::Kind::Input,
                HasSubstr("circle:8: expected front, back, left, right, top, bottom, iso, dimetric, turntable:N, "
                          "sphere:N or random:N:SEED, or a file of views, found none"),
                [] { static_cast<void>(viewsOf("circle:8", {})); });
    for (const char* wrong : {"turntable:", "turntable:0", "turntable:-3", "sphere:1.5", "sphere:2000000"})
        expectError(Error::Kind::Usage, HasSubstr("expected a number of views from 1 to 1000000"),
                    [&] { static_cast<void>(viewsOf(wrong, {})); });
    CameraSettings base;
    base.position = glm::dvec3{1, 0, 0};
    expectError(Error::Kind::Usage,
                HasSubstr("--views: expected no --camera-position, --camera-direction, --camera-index or "
                          "--view beside 'turntable:4'"),
                [&] { static_cast<void>(viewsOf("turntable:4", base)); });
}

}  // namespace
}  // namespace inkedge::camera
