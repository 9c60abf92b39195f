// A render that is asked to stop: it does so at whatever point, and the renderer goes on to draw as before.
#include <algorithm>
#include <atomic>
#include <functional>
#include <optional>
#include <stop_token>
#include <thread>

#include <inkedge/load_scene.h>

#include "base/expect_error.h"
#include "base/stop.h"
#include "gl/gl_test.h"
#include "scenes.h"

namespace inkedge::render {
namespace {

constexpr auto stopped = Error::Kind::Stopped;
const auto anyText = testing::HasSubstr("found a request to stop");

Scene asset(const std::string& name) { return loadScene(INKEDGE_SOURCE_DIR "/assets/" + name + ".glb"); }

Settings settingsOf(Style style, LinesFrom from) {
    Settings settings;
    settings.picture.size = {300, 260};
    settings.picture.tileSize = PictureSettings::minTileSize;
    settings.style.style = style;
    settings.lines.from = from;
    return settings;
}

// Stops at the n-th look, for every n up to 16 and further and further apart from there on, until the work comes to its
// end.
/// @return how often the whole work looks
int stopEverywhere(const std::function<void()>& work) {
    for (int n = 1;; n += n < 16 ? 1 : n / 4) {
        std::atomic<int> looks = 0;
        const base::StopScope scope{[&] { return ++looks >= n; }};
        try {
            work();
            return looks;
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), stopped) << error.what();
            if (error.kind() != stopped) return looks;
        }
    }
}

class Stopping : public gl_test::OnEachBackend {
protected:
    const Scene scene_ = asset("gear");
    const Camera camera_ = frameCamera(scene_, {}, {300, 260});
};
INSTANTIATE_TEST_SUITE_P(Backends, Stopping, testing::Values(Backend::Egl, Backend::Osmesa), gl_test::nameOfInstance);

TEST_P(Stopping, beforeTheWork) {
    std::stop_source source;
    source.request_stop();
    for (const LinesFrom from : {LinesFrom::Image, LinesFrom::Object}) {
        const Settings settings = settingsOf(Style::Ink, from);
        expectError(stopped, anyText, [&] { (void)renderer().render(scene_, camera_, settings, source.get_token()); });
        expectError(stopped, anyText, [&] { (void)renderer().lines(scene_, camera_, settings, source.get_token()); });
    }
}

TEST_P(Stopping, changesNothingUnlessAskedFor) {
    const Settings settings = settingsOf(Style::Ink, LinesFrom::Image);
    const std::stop_source source;
    EXPECT_EQ(renderer().render(scene_, camera_, settings, source.get_token()).picture.pixels(),
              renderer().render(scene_, camera_, settings).picture.pixels());
}

TEST_P(Stopping, ofAPictureAtAnyLookLeavesTheRendererAsItWas) {
    for (const Style style : {Style::Ink, Style::Hatch, Style::Sumi, Style::Pencil}) {
        Settings settings = settingsOf(style, LinesFrom::Image);
        settings.maps = {Map::Depth, Map::Normal, Map::Types, Map::Ids};
        const Maps expected = renderer().render(scene_, camera_, settings);
        const int looks = stopEverywhere([&] { (void)renderer().render(scene_, camera_, settings); });
        EXPECT_GT(looks, 4 * 4) << "four tiles of several stages";
        const Maps found = renderer().render(scene_, camera_, settings);
        EXPECT_EQ(found.picture, expected.picture);
        EXPECT_EQ(found.types, expected.types);
        EXPECT_EQ(found.ids, expected.ids);
    }
}

TEST_P(Stopping, ofAFunctionsEdgesAtAnyLook) {
    Settings settings = settingsOf(Style::Ink, LinesFrom::Image);
    settings.detector.functions = {surfaceFunction("volume")};
    const Maps expected = renderer().render(scene_, camera_, settings);
    (void)stopEverywhere([&] { (void)renderer().render(scene_, camera_, settings); });
    EXPECT_EQ(renderer().render(scene_, camera_, settings).picture.pixels(), expected.picture.pixels());
}

TEST_P(Stopping, ofLinesFromImageAtAnyLook) {
    const Settings settings = settingsOf(Style::Ink, LinesFrom::Image);
    const std::size_t expected = renderer().lines(scene_, camera_, settings).lines.size();
    EXPECT_GT(expected, 10U);
    (void)stopEverywhere([&] { (void)renderer().lines(scene_, camera_, settings); });
    EXPECT_EQ(renderer().lines(scene_, camera_, settings).lines.size(), expected);
}

TEST_P(Stopping, ofAFirstCallWhichMakesTheContext) {
    std::optional<Renderer> fresh;
    const Settings settings = settingsOf(Style::Ink, LinesFrom::Image);
    (void)stopEverywhere([&] {
        fresh.emplace(BackendSettings{GetParam(), {}}, ContextTime::WhenNeeded);
        (void)fresh->render(scene_, camera_, settings);
    });
    EXPECT_EQ(fresh->render(scene_, camera_, settings).picture.pixels(),
              renderer().render(scene_, camera_, settings).picture.pixels());
}

TEST_P(Stopping, fromAnotherThread) {
    const Settings settings = settingsOf(Style::Ink, LinesFrom::Image);
    const Maps expected = renderer().render(scene_, camera_, settings);
    std::stop_source source;
    std::atomic<bool> started = false;
    const std::jthread stopper{[&] {
        while (!started) std::this_thread::yield();
        source.request_stop();
    }};
    expectError(stopped, anyText, [&] {
        for (;;) {
            started = true;
            (void)renderer().render(scene_, camera_, settings, source.get_token());
        }
    });
    EXPECT_EQ(renderer().render(scene_, camera_, settings).picture.pixels(), expected.picture.pixels());
}

TEST(StoppingObjectLines, atAnyLookLeavesWhatIsPreparedAsItWas) {
    const Scene scene = asset("gear");
    const Camera camera = frameCamera(scene, {}, {300, 260});
    Settings settings = settingsOf(Style::Ink, LinesFrom::Object);
    settings.lines.hidden = HiddenLines::Dashed;
    Renderer renderer{{}, ContextTime::WhenNeeded};
    try {
        (void)renderer.lines(scene, camera, settings);
    } catch (const Error& error) {
        GTEST_SKIP() << error.what();
    }
    const auto count = [](const Lines& lines) {
        std::size_t points = 0;
        for (const Line& line : lines.lines) points += line.points.size();
        return points;
    };
    const std::size_t expected = count(renderer.lines(scene, camera, settings));
    EXPECT_GT(expected, 10U);
    const Scene fresh = asset("gear");
    const int looks = stopEverywhere([&] { (void)renderer.lines(fresh, camera, settings); });
    EXPECT_GT(looks, 100) << "every few rays";
    EXPECT_EQ(count(renderer.lines(fresh, camera, settings)), expected);
}

}  // namespace
}  // namespace inkedge::render
