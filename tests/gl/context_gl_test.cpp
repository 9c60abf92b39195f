#include "gl/context.h"

#include <algorithm>
#include <map>
#include <memory>
#include <vector>

#include <dlfcn.h>

#include <gmock/gmock.h>

#include "base/expect_error.h"
#include "gl/framed_pictures.h"
#include "gl/gl_test.h"
#include "scenes.h"

namespace inkedge::gl {
namespace {

using gl_test::classic;
using namespace framed_pictures;
using testing::HasSubstr;
using testing::StrEq;

INKEDGE_ON_EACH_BACKEND(ContextTest);

TEST_P(ContextTest, isCurrentOnlyInItsScope) {
    const Current current{context()};
    GLint name = 0;
    gpu().api.GetIntegerv(GL_MAJOR_VERSION, &name);
    EXPECT_EQ(name, 4);
}

// The current context is known by state that only one context has.
void mark(const Context& context, float value) { context.api().ClearColor(value, 0, 0, 0); }
float marked(const Context& context) {
    GLfloat color[4]{-1.0F};
    context.api().GetFloatv(GL_COLOR_CLEAR_VALUE, color);
    return color[0];
}

TEST_P(ContextTest, givesBackTheContextThatWasCurrentBefore) {
    const auto other = createContext({GetParam(), {}});
    const Current outer{context()};
    mark(context(), 0.25F);
    {
        const Current inner{*other};
        mark(*other, 0.75F);
        EXPECT_EQ(marked(*other), 0.75F);
    }
    EXPECT_EQ(marked(context()), 0.25F);
}

TEST_P(ContextTest, isGivenBackByARenderer) {
    const Scene scene = scenes::sceneOf(scenes::cube());
    const Current outer{context()};
    mark(context(), 0.5F);
    (void)renderFramed(renderer(), scene, {16, 16});
    EXPECT_EQ(marked(context()), 0.5F);
    { const Renderer passing{BackendSettings{GetParam(), {}}}; }
    EXPECT_EQ(marked(context()), 0.5F);
}

TEST_P(ContextTest, worksAgainAfterARendererOfTheOtherBackend) {
    const Backend other = GetParam() == Backend::Egl ? Backend::Osmesa : Backend::Egl;
    gl_test::Equipment* const equipment = gl_test::Backends::instance().equipment(other);
    if (equipment == nullptr) GTEST_SKIP() << "no backend " << gl_test::backendName(other);
    const Scene scene = scenes::sceneOf(scenes::cube());
    {
        const Current current{context()};
        mark(context(), 0.5F);
    }
    (void)renderFramed(equipment->renderer, scene, {16, 16});
    const Current current{context()};
    EXPECT_EQ(marked(context()), 0.5F);
}

TEST_P(ContextTest, isGivenBackWhenARenderFails) {
    const Scene scene = scenes::sceneOf(scenes::cube());
    const Current outer{context()};
    mark(context(), 0.125F);
    EXPECT_THROW((void)renderer().render(scene, frameCamera(scene, {}, {1, 1}), classic({0, 0})), Error);
    EXPECT_EQ(marked(context()), 0.125F);
}

TEST(Backends, drawTheSamePictureAtOnceInOneProcess) {
    gl_test::Equipment* const egl = gl_test::Backends::instance().equipment(Backend::Egl);
    gl_test::Equipment* const osmesa = gl_test::Backends::instance().equipment(Backend::Osmesa);
    if (egl == nullptr || osmesa == nullptr) GTEST_SKIP() << "needs both backends";
    const Scene scene = scenes::sceneOf(scenes::cube());
    for (int i = 0; i < 3; ++i) {
        const Maps a = renderFramed(egl->renderer, scene, {64, 64});
        const Maps b = renderFramed(osmesa->renderer, scene, {64, 64});
        EXPECT_EQ(a.backend.backend, "egl");
        EXPECT_EQ(b.backend.backend, "osmesa");
        const auto differ = differing(a.edges, b.edges);
        EXPECT_LE(differ, 8U) << "a vertex may round to the other side of a pixel's centre";
    }
}

// llvmpipe rasterises for one context of a display at a time.
TEST(Backends, spreadContextsOnTheOnlySoftwareDeviceOverTwoDisplays) {
    void* const library = dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr) GTEST_SKIP() << "no EGL here";
    const auto displayOfCurrent = reinterpret_cast<void* (*)()>(dlsym(library, "eglGetCurrentDisplay"));
    ASSERT_NE(displayOfCurrent, nullptr);
    const auto all = listBackends();
    const auto isDevice = [](const BackendInfo& each) { return each.platform.starts_with("device"); };
    if (std::ranges::count_if(all, isDevice) != 1 || !std::ranges::find_if(all, isDevice)->software)
        GTEST_SKIP() << "needs a software device alone";
    std::map<void*, int> contextsOf;
    std::vector<std::unique_ptr<Context>> contexts;
    for (int i = 0; i < 4; ++i) {
        contexts.push_back(createContext({Backend::Egl, {}}));
        const Current current{*contexts.back()};
        ++contextsOf[displayOfCurrent()];
    }
    EXPECT_EQ(contextsOf.size(), 2U);
}

TEST(Backends, areReportedInTheOrderInWhichAutoTriesThem) {
    const std::vector<BackendReport> reports = probeBackends();
    ASSERT_FALSE(reports.empty());
    EXPECT_EQ(reports.front().info.backend, "egl");
    EXPECT_EQ(reports.back().info.backend, "osmesa");
    for (const BackendReport& report : reports) {
        EXPECT_EQ(report.works(), !report.info.version.empty()) << report.info.platform << ": " << report.failure;
        if (report.works()) continue;
        EXPECT_THAT(report.failure, testing::AllOf(HasSubstr("expected"), HasSubstr("found")));
    }
    const auto works = std::ranges::find_if(reports, &BackendReport::works);
    if (works == reports.end()) GTEST_SKIP() << "no backend works";
    const Renderer renderer;
    EXPECT_EQ(renderer.backend().backend, works->info.backend);
    EXPECT_EQ(renderer.backend().platform, works->info.platform);
}

TEST(Backends, refuseADeviceThatDoesNotExist) {
    const auto reports = probeBackends();
    const auto devices =
        std::ranges::count_if(reports, [](const BackendReport& r) { return r.info.platform.starts_with("device "); });
    if (devices == 0) GTEST_SKIP() << "no EGL device";
    for (const Backend backend : {Backend::Auto, Backend::Egl}) {
        expectError(Error::Kind::Usage,
                    StrEq("--device: expected an EGL device that `inkedge doctor` lists, found 99 among " +
                          std::to_string(devices)),
                    [&] {
                        const Renderer none{BackendSettings{backend, 99}};
                    });
    }
}

TEST(Backends, refuseADeviceForOsmesa) {
    expectError(Error::Kind::Usage, StrEq("--device: expected it with the egl backend only, found it with osmesa"), [] {
        const Renderer none{BackendSettings{Backend::Osmesa, 0}};
    });
}

TEST(Backends, takeTheDeviceAskedFor) {
    for (const BackendReport& report : probeBackends()) {
        if (!report.works() || !report.info.platform.starts_with("device ")) continue;
        const int device = std::stoi(report.info.platform.substr(7));
        const Renderer renderer{BackendSettings{Backend::Egl, device}};
        EXPECT_EQ(renderer.backend().platform, report.info.platform);
        EXPECT_EQ(renderer.backend().renderer, report.info.renderer);
    }
}

}  // namespace
}  // namespace inkedge::gl
