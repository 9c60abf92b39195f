#pragma once

#include <span>
#include <string>
#include <string_view>

#include <inkedge/export.h>

namespace inkedge::base {

/// The one of some names that was meant by a text with a slip or two; empty: none is like it. What differs is counted
/// in characters left out, added, changed or exchanged with the next one (Damerau's distance), at most a quarter of the
/// text's, or one. The command calls it in the shared library.
[[nodiscard]] INKEDGE_API std::string nearestName(std::string_view text, std::span<const std::string_view> names);

/// "; is it sobel?", to be added to a message that refuses a text; empty: none of the names is like it.
[[nodiscard]] INKEDGE_API std::string suggestion(std::string_view text, std::span<const std::string_view> names);

}  // namespace inkedge::base
