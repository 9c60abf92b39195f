// What a used-up or lost context becomes. The function tables are copies in which OpenGL says so.
#include "gl/errors.h"

#include <gmock/gmock.h>

#include "base/expect_error.h"
#include "gl/gl_test.h"
#include "gl/shared_object.h"
#include "gl/stage_clock.h"
#include "gl/upload.h"
#include "scenes.h"

namespace inkedge::gl {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StrEq;

INKEDGE_ON_EACH_BACKEND(GlErrors);

Api outOfMemory(Api api) {
    api.GetError = [] { return static_cast<GLenum>(GL_OUT_OF_MEMORY); };
    return api;
}

template <GLenum status>
Api reset(Api api) {
    api.GetGraphicsResetStatus = [] { return status; };
    return api;
}

TEST_P(GlErrors, areNoneWhenAllIsWell) {
    const Current current{context()};
    EXPECT_NO_THROW(checkErrors(context().api(), "nothing", "do nothing"));
}

TEST_P(GlErrors, nameAnErrorAndForgetIt) {
    const Current current{context()};
    context().api().Enable(0xFFFFU);
    expectError(Error::Kind::Runtime,
                StrEq("a test: expected no OpenGL error, found 0x500; update the graphics driver "
                      "or use another --backend"),
                [&] { checkErrors(context().api(), "a test", "do less"); });
    EXPECT_NO_THROW(checkErrors(context().api(), "a test", "do less"));
}

TEST_P(GlErrors, sayWhatDidNotFitIntoGraphicsMemory) {
    const Current current{context()};
    const Api api = outOfMemory(context().api());
    expectError(Error::Kind::Runtime,
                StrEq("expected graphics memory for a picture of 4 x 3 pixels, found too little; ask for a smaller "
                      "--size or --tile-size"),
                [&] {
                    TexturePool pool{api};
                    (void)pool.acquire({4, 3}, GL_R8);
                });
    expectError(Error::Kind::Runtime,
                StrEq("expected graphics memory for a scene of 12 triangles, found too little; draw a smaller model "
                      "or use --backend osmesa"),
                [&] { const UploadedScene upload(api, scenes::sceneOf(scenes::cube())); });
    expectError(Error::Kind::Runtime,
                StrEq("expected graphics memory for the stage lines, found too little; ask for a smaller --size or "
                      "--supersampling"),
                [&] {
                    std::vector<StageTime> times;
                    StageClock{api, times}.finish("lines");
                });
}

TEST_P(GlErrors, sayThatTheContextIsLostAndWhy) {
    const Current current{context()};
    const auto expectLoss = [](const Api& api, const std::string& why) {
        expectError(
            Error::Kind::Runtime,
            AllOf(HasSubstr("the stage lines: expected the OpenGL context to last, found it lost: "), HasSubstr(why)),
            [&] {
                std::vector<StageTime> times;
                StageClock{api, times}.finish("lines");
            });
    };
    const Api& api = context().api();
    expectLoss(reset<GL_GUILTY_CONTEXT_RESET>(api), "because of this work; give it less to do at once");
    expectLoss(reset<GL_INNOCENT_CONTEXT_RESET>(api), "because of another program's work; render again");
    expectLoss(reset<GL_UNKNOWN_CONTEXT_RESET>(api), "was reset; render again");
    Api lost = api;
    lost.GetError = [] { return static_cast<GLenum>(GL_CONTEXT_LOST); };
    expectLoss(lost, "was reset; render again");
}

// llvmpipe's largest texture has more bytes than it gives to one.
TEST_P(GlErrors, areSurvivedByThePoolOfTextures) {
    if (!renderer().backend().software) GTEST_SKIP() << "a graphics card may have the memory";
    const Current current{context()};
    GLint maxSide = 0;
    context().api().GetIntegerv(GL_MAX_TEXTURE_SIZE, &maxSide);
    expectError(Error::Kind::Runtime, HasSubstr("expected graphics memory for a picture of "), [&] {
        (void)gpu().textures.acquire({maxSide, maxSide}, GL_RGBA32F);
    });
    EXPECT_NO_THROW((void)gpu().textures.acquire({32, 32}, GL_RGBA32F));
}

// What the current context's display can do; nothing where EGL is missing or another library made the context.
std::string eglExtensions() {
    void* const library = openSharedObject({"libEGL.so.1"});
    void* (*currentDisplay)() = nullptr;
    const char* (*queryString)(void* display, int name) = nullptr;
    if (library == nullptr || !resolve(library, "eglGetCurrentDisplay", currentDisplay) ||
        !resolve(library, "eglQueryString", queryString)) {
        return {};
    }
    constexpr int extensions = 0x3055;  // EGL_EXTENSIONS
    void* const display = currentDisplay();
    const char* const text = display == nullptr ? nullptr : queryString(display, extensions);
    return text == nullptr ? "" : text;
}

TEST_P(GlErrors, ofAResetAreAskedForWhereTheDriverReportsIt) {
    const Current current{context()};
    if (eglExtensions().find("EGL_EXT_create_context_robustness") == std::string::npos) {
        GTEST_SKIP() << gl_test::backendName(GetParam()) << " does not report resets here";
    }
    GLint strategy = 0;
    context().api().GetIntegerv(GL_RESET_NOTIFICATION_STRATEGY, &strategy);
    EXPECT_EQ(strategy, GL_LOSE_CONTEXT_ON_RESET);
}

}  // namespace
}  // namespace inkedge::gl
