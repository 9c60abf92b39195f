#include "gl/errors.h"

#include <fmt/format.h>

#include <inkedge/error.h>

namespace inkedge::gl {
namespace {

const char* describeReset(GLenum status) {
    switch (status) {
        case GL_GUILTY_CONTEXT_RESET:
            return "the graphics processor was reset because of this work; give it less to do at once or use another "
                   "--backend";
        case GL_INNOCENT_CONTEXT_RESET:
            return "the graphics processor was reset because of another program's work; render again with a new "
                   "context";
        default:
            return "the graphics processor was reset; render again with a new context";
    }
}

}  // namespace

void checkErrors(const Api& api, std::string_view work, std::string_view remedy) {
    const GLenum error = api.GetError();
    const GLenum reset = api.GetGraphicsResetStatus();
    if (reset != GL_NO_ERROR || error == GL_CONTEXT_LOST) {
        throw Error{Error::Kind::Runtime, fmt::format("{}: expected the OpenGL context to last, found it lost: {}",
                                                      work, describeReset(reset))};
    }
    if (error == GL_OUT_OF_MEMORY) {
        throw Error{Error::Kind::Runtime,
                    fmt::format("expected graphics memory for {}, found too little; {}", work, remedy)};
    }
    if (error != GL_NO_ERROR) {
        throw Error{Error::Kind::Runtime,
                    fmt::format("{}: expected no OpenGL error, found {:#x}; update the graphics driver or use another "
                                "--backend",
                                work, error)};
    }
}

}  // namespace inkedge::gl
