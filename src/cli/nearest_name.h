#pragma once

#include <span>
#include <string>
#include <string_view>

namespace inkedge::cli {

/// The one of some names that was meant by a text with a slip or two; empty: none is like it. What differs is counted
/// in characters left out, added or exchanged (Levenshtein's distance), at most a quarter of the text's, or one.
[[nodiscard]] std::string nearestName(std::string_view text, std::span<const std::string> names);

}  // namespace inkedge::cli
