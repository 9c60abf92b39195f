#pragma once

#include <string_view>

#include "gl/api.h"

namespace inkedge::gl {

/// Throws if an OpenGL call since the last check has failed.
/// @param work    what the calls were for, "a picture of 4 x 4 pixels": messages name it
/// @param remedy  how to use less memory, "ask for a smaller --size or --tile-size"
/// @throws Error  (Kind::Runtime) if the context is lost, the graphics memory is used up or OpenGL has another error
void checkErrors(const Api&, std::string_view work, std::string_view remedy);

}  // namespace inkedge::gl
