// Views on pictures of sizes as people say them: on paper, at a scale, cut to what is drawn, several at one scale.
#include <inkedge/views.h>

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <glm/geometric.hpp>

#include <inkedge/error.h>
#include <inkedge/setting_table.h>

#include "base/expect_error.h"
#include "camera/framed_scenes.h"
#include "scenes.h"

namespace inkedge::camera {
namespace {

using namespace framed_scenes;
using testing::HasSubstr;

// A plate 40 wide, 10 high and 20 deep, off the origin, in millimetres or metres.
Scene plate(LengthUnit unit = LengthUnit::None) {
    Scene::Data data;
    data.meshes.push_back(scenes::box({40, 10, 20}));
    data.instances.push_back({"plate", 0, scenes::translation({100, 7, -30})});
    data.source.unit = unit;
    return Scene{std::move(data)};
}

Settings settingsOf(const std::vector<std::pair<std::string, std::string>>& values) {
    Settings settings;
    for (const auto& [name, text] : values) set(settings, name, text, "test");
    return settings;
}

FramedView frame(const Scene& scene, const std::vector<std::pair<std::string, std::string>>& values) {
    const Settings settings = settingsOf(values);
    const View view{"0", settings.camera};
    return frameViews(scene, {&view, 1}, settings).front();
}

std::vector<FramedView> frame(const Scene& scene, const std::string& views,
                              const std::vector<std::pair<std::string, std::string>>& values) {
    const Settings settings = settingsOf(values);
    return frameViews(scene, viewsOf(views, settings.camera), settings);
}

struct Margins {
    double left = 0.0;
    double right = 0.0;
    double top = 0.0;
    double bottom = 0.0;
};

// Pixels around what is drawn.
Margins marginsOf(const Scene& scene, const FramedView& view) {
    const Size size = view.picture.size;
    const Frame frame = covered(scene, view.camera, size);
    return {0.5 * size.width * (1.0 + frame.low.x), 0.5 * size.width * (1.0 - frame.high.x),
            0.5 * size.height * (1.0 - frame.high.y), 0.5 * size.height * (1.0 + frame.low.y)};
}

// A picture has whole pixels: what is left over lies half on either side.
void expectMargins(const Scene& scene, const FramedView& view, double margin) {
    const Margins found = marginsOf(scene, view);
    for (const double each : {found.left, found.right, found.top, found.bottom}) {
        EXPECT_GE(each, margin - nearlyExact);
        EXPECT_LE(each, margin + 0.5 + nearlyExact);
    }
    EXPECT_NEAR(found.left, found.right, nearlyExact);
    EXPECT_NEAR(found.top, found.bottom, nearlyExact);
}

double pixelsPerUnit(const FramedView& view) { return view.picture.size.height / view.camera.orthographicHeight; }

void expectRefused(const std::vector<std::pair<std::string, std::string>>& values, const std::string& message) {
    expectError(Error::Kind::Usage, HasSubstr(message), [&] { (void)frame(plate(), values); });
}

TEST(FrameViews, areThoseOfFrameCameraWhereNothingElseIsAskedFor) {
    const Scene scene = skewScene();
    for (const std::string views : {"turntable:3", "sphere:4"}) {
        const Settings settings = settingsOf({{"size", "160x90"}});
        const std::vector<View> each = viewsOf(views, settings.camera);
        const std::vector<FramedView> found = frameViews(scene, each, settings);
        for (std::size_t i = 0; i < each.size(); ++i) {
            const Camera expected = frameCamera(scene, each[i].camera, {160, 90});
            EXPECT_EQ(found[i].camera.view, expected.view);
            EXPECT_EQ(found[i].camera.projection({160, 90}), expected.projection({160, 90}));
            EXPECT_EQ(found[i].camera.viewAngle, expected.viewAngle);
            EXPECT_EQ(found[i].picture.size, (Size{160, 90}));
            EXPECT_EQ(found[i].picture.dpi, std::nullopt);
        }
    }
}

TEST(FrameViews, takeASizeOnPaperAtTheResolution) {
    const FramedView inMillimetres = frame(plate(), {{"size", "90x60mm"}, {"dpi", "300"}});
    EXPECT_EQ(inMillimetres.picture.size, (Size{1063, 709}));
    EXPECT_EQ(inMillimetres.picture.dpi, 300.0);
    const FramedView plain = frame(plate(), {{"size", "2in"}, {"view", "front"}});
    EXPECT_EQ(plain.picture.size.width, 192) << "96 pixels an inch";
    EXPECT_EQ(plain.picture.dpi, 96.0) << "which a file of it tells";
    EXPECT_EQ(frame(plate(), {{"dpi", "120"}, {"size", "30x20"}}).picture.dpi, 120.0);
}

TEST(FrameViews, takeTheHeightFromWhatIsDrawn) {
    const FramedView front = frame(plate(), {{"size", "1000"}, {"view", "front"}});
    EXPECT_EQ(front.picture.size.width, 1000);
    EXPECT_NEAR(front.picture.size.height, 920 / 4 + 80, 1) << "10 high and 40 wide, with equal margins";
    const Margins margins = marginsOf(plate(), front);
    for (const double each : {margins.left, margins.right, margins.top, margins.bottom}) EXPECT_NEAR(each, 40.0, 0.51);

    const FramedView tall = frame(plate(), {{"size", "100"}, {"view", "right"}, {"up", "+Y"}});
    EXPECT_NEAR(tall.picture.size.height, 92 / 2 + 8, 1);
    for (const Margins& each : {marginsOf(skewScene(), frame(skewScene(), {{"size", "200"}}))}) {  // in perspective
        EXPECT_NEAR(each.left, each.top, 0.51);
        EXPECT_NEAR(each.right, each.bottom, 0.51);
    }
}

TEST(FrameViews, cropToWhatIsDrawnInEveryProjection) {
    for (const std::string view : {"front", "iso", "top"}) {
        const FramedView cropped = frame(plate(), {{"size", "300x200"}, {"view", view}, {"crop", "20"}});
        expectMargins(plate(), cropped, 20.0 + 0.75);  // and half the lines' width
        EXPECT_TRUE(cropped.picture.size.width == 300 || cropped.picture.size.height == 200) << "as large as it may be";
    }
    for (const std::string height : {"20x300", "300x20", "128x128"}) {
        const FramedView cropped = frame(skewScene(), {{"size", height}, {"crop", "2"}, {"line-width", "1"}});
        expectMargins(skewScene(), cropped, 2.5);
        EXPECT_FALSE(cropped.camera.orthographic());
    }
    const FramedView wide = frame(skewScene(), {{"size", "500"}, {"crop", "5mm"}, {"dpi", "254"}});
    EXPECT_EQ(wide.picture.size.width, 500);
    expectMargins(skewScene(), wide, 50.75);
}

TEST(FrameViews, cropKeepsAnEyeWhereItStands) {
    const std::vector<std::pair<std::string, std::string>> eye{
        {"camera-position", "3,6,25"}, {"camera-focal-point", "0,1,0"}, {"size", "300x200"}};
    const FramedView whole = frame(skewScene(), eye);
    auto withCrop = eye;
    withCrop.emplace_back("crop", "0");
    const FramedView cropped = frame(skewScene(), withCrop);
    EXPECT_EQ(cropped.camera.view, whole.camera.view);
    EXPECT_NE(cropped.camera.axis, glm::dvec2{0.0}) << "the model is not in the middle of the whole picture";
    EXPECT_NEAR(cropped.camera.focalLength(cropped.picture.size), whole.camera.focalLength({300, 200}), nearlyExact);
    const Frame all = covered(skewScene(), whole.camera, {300, 200});
    ASSERT_LT(std::max({-all.low.x, -all.low.y, all.high.x, all.high.y}), 1.0)
        << "the test needs it within the picture";
    expectMargins(skewScene(), cropped, 0.75);
    // What the eye sees moves as a whole.
    glm::dvec2 moved{};
    for (const glm::dvec3& p : scenes::drawnVertices(skewScene())) {
        const glm::dvec2 by =
            scenes::pixel(whole.camera, {300, 200}, p) - scenes::pixel(cropped.camera, cropped.picture.size, p);
        if (moved == glm::dvec2{}) moved = by;
        EXPECT_NEAR(glm::length(by - moved), 0.0, nearlyExact);
    }
}

TEST(FrameViews, cropLeavesOutWhatLiesBeyondThePictureOrBehindTheEye) {
    // Within the plate, near its left end, looking right: parts of it lie behind the eye.
    const FramedView within = frame(
        plate(), {{"camera-position", "82,7,-30"}, {"camera-direction", "1,0,0"}, {"size", "80x60"}, {"crop", "0"}});
    EXPECT_EQ(within.picture.size, (Size{80 + 2, 60 + 2})) << "its sides are cut by the picture's edges, 0.75 beyond";
    const FramedView nothing = frame(
        plate(), {{"camera-position", "0,0,99"}, {"camera-direction", "0,0,1"}, {"size", "80x60"}, {"crop", "0"}});
    EXPECT_EQ(nothing.picture.size, (Size{80, 60})) << "nothing is drawn";
}

TEST(FrameViews, haveTheScaleThatIsAskedFor) {
    for (const auto& [unit, millimetres] :
         {std::pair{LengthUnit::Metre, 1000.0}, {LengthUnit::Millimetre, 1.0}, {LengthUnit::None, 1.0}}) {
        const std::string scale = unit == LengthUnit::Metre ? "1:500" : "1:2";
        const double factor = unit == LengthUnit::Metre ? 1.0 / 500.0 : 0.5;
        for (const std::string view : {"front", "top", "iso"}) {
            const FramedView found = frame(plate(unit), {{"scale", scale}, {"view", view}, {"dpi", "254"}});
            EXPECT_NEAR(pixelsPerUnit(found), factor * millimetres * 10.0, 1e-9);  // 10 pixels a mm
            const Margins margins = marginsOf(plate(unit), found);
            EXPECT_GT(std::min({margins.left, margins.top, margins.right, margins.bottom}), 1.0)
                << "all of it is there";
        }
    }
    const FramedView cropped = frame(plate(), {{"scale", "1:2"}, {"view", "front"}, {"dpi", "254"}, {"crop", "1mm"}});
    EXPECT_EQ(cropped.picture.size, (Size{200 + 22, 50 + 22})) << "10 pixels of margin, and half a line, rounded up";
    const FramedView sized = frame(plate(), {{"scale", "2:1"}, {"view", "front"}, {"size", "100x50mm"}});
    EXPECT_EQ(sized.picture.size, (Size{378, 189}));
    EXPECT_NEAR(pixelsPerUnit(sized), 2.0 * 96.0 / 25.4, 1e-9);
}

TEST(FrameViews, fillAPageAtAScale) {
    const FramedView page = frame(plate(), {{"scale", "2:1"}, {"view", "top"}, {"page-size", "A5-landscape"}});
    EXPECT_EQ(page.picture.size, (Size{794, 559}));
    expectRefused({{"scale", "10:1"}, {"view", "top"}, {"page-size", "A5"}},
                  "--scale: expected what is drawn, 400 x 200 mm at this scale, to fit into a picture of 147.9 x "
                  "210.1 mm, found it larger");
    expectRefused({{"size", "90x60mm"}, {"page-size", "80mmx60mm"}},
                  "--page-size: expected a page that holds the picture, 89.96 x 60.06 mm, found 80 x 60 mm");
}

TEST(FrameViews, togetherHaveOneScaleAndOneMiddle) {
    const glm::dvec3 middle{100, 7, -30};
    for (const std::string list : {"front,top,right", "front,back,left,right,top,bottom,iso,dimetric,turntable:3"}) {
        const std::vector<FramedView> views = frame(plate(), list, {{"size", "200x150"}});
        double widest = 0.0;
        for (const FramedView& view : views) {
            ASSERT_TRUE(view.camera.orthographic());
            EXPECT_EQ(view.picture.size, (Size{200, 150}));
            EXPECT_NEAR(view.camera.orthographicHeight, views.front().camera.orthographicHeight, nearlyExact);
            const glm::dvec2 pixel = scenes::pixel(view.camera, {200, 150}, middle);
            EXPECT_NEAR(pixel.x, 100.0, nearlyExact);
            EXPECT_NEAR(pixel.y, 75.0, nearlyExact);
            const Frame all = covered(plate(), view.camera, {200, 150});
            widest = std::max({widest, -all.low.x, -all.low.y, all.high.x, all.high.y});
            expectVerticesBetweenNearAndFar(plate(), view.camera);
        }
        EXPECT_NEAR(widest, frameShare, nearlyExact) << "the largest fills the frame";
    }
    // Front and top stand above each other, front and right beside each other.
    const std::vector<FramedView> views = frame(plate(), "front,top,right", {{"size", "300"}, {"crop", "10"}});
    const Margins front = marginsOf(plate(), views[0]);
    EXPECT_NEAR(front.left, marginsOf(plate(), views[1]).left, nearlyExact);
    EXPECT_NEAR(front.top, marginsOf(plate(), views[2]).top, nearlyExact);
    for (const FramedView& view : views) EXPECT_EQ(view.picture.size, views.front().picture.size);
}

TEST(FrameViews, togetherOrEachAsTheSettingSays) {
    const auto heights = [&](const std::string& list, const std::string& framing) {
        std::vector<double> all;
        for (const FramedView& view : frame(plate(), list, {{"framing", framing}, {"camera-orthographic", "0"}}))
            all.push_back(view.camera.orthographicHeight);
        return all;
    };
    EXPECT_NE(heights("front,right", "each")[0], heights("front,right", "each")[1]);
    EXPECT_EQ(heights("front,right", "auto")[0], heights("front,right", "auto")[1]);
    EXPECT_EQ(heights("turntable:3", "together")[0], heights("turntable:3", "together")[1]);
    EXPECT_NE(heights("turntable:3", "auto")[0], heights("turntable:3", "auto")[1]);
    // In perspective from one distance.
    for (const FramedView& view : frame(plate(), "turntable:5", {{"framing", "together"}, {"size", "90x90"}})) {
        EXPECT_NEAR(depthOf(view.camera, {100, 7, -30}),
                    depthOf(frame(plate(), "turntable:5", {{"framing", "together"}, {"size", "90x90"}})[0].camera,
                            {100, 7, -30}),
                    nearlyExact);
        const Frame all = covered(plate(), view.camera, {90, 90});
        EXPECT_LE(std::max({-all.low.x, -all.low.y, all.high.x, all.high.y}), frameShare + nearlyExact);
    }
}

TEST(FrameViews, refuseWhatCannotBe) {
    expectRefused({{"scale", "1:2"}, {"camera-view-angle", "30"}}, "--scale: expected it without --camera-view-angle");
    expectRefused({{"scale", "1:2"}, {"camera-orthographic", "30"}}, "--scale: expected it without the height of");
    expectRefused({{"scale", "1:2"}, {"camera-zoom-factor", "2"}}, "--scale: expected it without --camera-zoom-factor");
    expectRefused({{"scale", "1:2"}, {"camera-index", "0"}}, "--scale: expected it without --camera-index");
    expectRefused({{"scale", "100:1"}, {"size", "90mm"}, {"view", "front"}},
                  "--scale: expected what is drawn, 4000 x ");
    expectRefused({{"size", "40x30"}, {"crop", "20"}}, "--crop: expected room between two margins in 40 pixels, found");
    expectRefused({{"size", "99999mm"}}, "--size: expected at most 32768 pixels along each side, found 99999 mm at 96");
    expectRefused({{"scale", "10000:1"}, {"view", "front"}}, "--size: expected a picture of at most 32768 pixels");
}

}  // namespace
}  // namespace inkedge::camera
