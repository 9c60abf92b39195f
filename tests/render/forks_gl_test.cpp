#include <sys/wait.h>
#include <unistd.h>

#include <functional>
#include <optional>

#include <gmock/gmock.h>

#include <inkedge/renderer.h>

#include "gl/gl_test.h"
#include "scenes.h"

namespace inkedge::render {
namespace {

constexpr unsigned int patience = 60;  // seconds until a fork that waits for its driver counts as hanging

/// @return  what waitpid() says of a fork that runs a function, and ends with its result
int forked(const std::function<int()>& work) {
    const pid_t child = ::fork();
    if (child == 0) {
        ::alarm(patience);
        ::_exit(work());
    }
    int status = -1;
    ::waitpid(child, &status, 0);
    return status;
}

Maps draw(Renderer& renderer) {
    const Scene scene = scenes::sceneOf(scenes::cube());
    RenderSettings settings;
    settings.picture.size = {32, 32};
    return renderer.render(scene, frameCamera(scene, {}, settings.picture.size), settings);
}

int refused(const std::function<void()>& work) {
    try {
        work();
    } catch (const Error& error) {
        const std::string_view text = error.what();
        return error.kind() == Error::Kind::Runtime && text.find("found a fork of one") != text.npos ? 0 : 2;
    }
    return 1;
}

INKEDGE_ON_EACH_BACKEND(Forks);

TEST_P(Forks, ofAProcessThatHasDrawnAreRefusedAndEnd) {
    const BackendSettings backend{GetParam(), {}};
    std::optional<Renderer> renderer{backend};
    (void)draw(*renderer);
    EXPECT_EQ(forked([&] { return refused([&] { (void)draw(*renderer); }); }), 0);
    EXPECT_EQ(forked([&] { return refused([&] { const Renderer another{backend}; }); }), 0);
    EXPECT_EQ(forked([&] {
                  renderer.reset();
                  return 0;
              }),
              0);
    EXPECT_FALSE(draw(*renderer).picture.empty()) << "the process itself draws on";
}

}  // namespace
}  // namespace inkedge::render
