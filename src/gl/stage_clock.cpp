#include "gl/stage_clock.h"

#include <fmt/format.h>

#include <inkedge/error.h>

namespace inkedge::gl {

void StageClock::finish(const char* stage) {
    api_.Finish();
    if (const GLenum error = api_.GetError(); error != GL_NO_ERROR) {
        throw Error{
            Error::Kind::Runtime,
            error == GL_OUT_OF_MEMORY
                ? fmt::format("{}: expected enough graphics memory, found too little; ask for a smaller --size", stage)
                : fmt::format("{}: expected no OpenGL error, found {:#x}", stage, error)};
    }
    const auto now = std::chrono::steady_clock::now();
    times_.push_back({stage, std::chrono::duration<double, std::milli>(now - begin_).count()});
    begin_ = now;
}

}  // namespace inkedge::gl
