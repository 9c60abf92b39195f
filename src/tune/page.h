#pragma once

#include <string_view>

namespace inkedge::tune {

/// The page: src/tune/page.html with the styles and scripts that it names in it, embedded by the build.
extern const std::string_view pageText;

}  // namespace inkedge::tune
