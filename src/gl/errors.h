#pragma once

#include <string_view>

#include "gl/api.h"

namespace inkedge::gl {

/// Does nothing if all OpenGL calls since the last check went well.
/// @param work    what they were for, "a picture of 4 x 4 pixels": the messages name it
/// @param remedy  what needs less memory, "ask for a smaller --size or --tile-size"
/// @throws Error  (Kind::Runtime) if the context is lost, the graphics memory is used up or OpenGL has another error
void checkErrors(const Api&, std::string_view work, std::string_view remedy);

}  // namespace inkedge::gl
