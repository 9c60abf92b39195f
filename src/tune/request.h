#pragma once

#include <cstdint>
#include <string>

#include <inkedge/settings.h>

#include "tune/latest_wins.h"
#include "tune/studio.h"

namespace inkedge::tune {

/// What the page asks for.
struct Request {
    std::string tab;           ///< a name that a tab gives itself
    std::uint64_t number = 0;  ///< counts what the tab asks for
    Settings settings = {};
    Work work = Work::Picture;
    Detail detail = Detail::Full;
    std::string output = "drawing.png";  ///< a file: drawing. and what is written in one go
    int x = 0;                           ///< the pixel under the pointer
    int y = 0;
};

/// A request from the text that the page sends, as JSON.
/// @throws Error  (Kind::Input) if it is no such JSON, (Kind::Usage) if a setting or a name of a file is not taken: the
///                message begins with the flag
[[nodiscard]] Request requestOf(const std::string& body);

}  // namespace inkedge::tune
