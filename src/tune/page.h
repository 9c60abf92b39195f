#pragma once

#include <string_view>

namespace inkedge::tune {

/// The page, src/tune/page.html, embedded by the build.
extern const std::string_view pageText;

}  // namespace inkedge::tune
