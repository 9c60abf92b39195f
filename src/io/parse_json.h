#pragma once

#include <cstddef>
#include <functional>
#include <string_view>

#include <nlohmann/json.hpp>

namespace inkedge::io {

using ParsedJson = nlohmann::json;

/// A list among the values of a JSON object that is too long to be held as JSON.
struct LongList {
    std::string_view key;
    /// Called with each of its elements as it ends, and with what of the whole stands before the list.
    std::function<void(const ParsedJson& element, const ParsedJson& before)> take;
};

struct JsonLimits {
    std::size_t depth;   ///< of lists and objects in each other
    std::size_t values;  ///< of one element of the long list, and of all that stands outside of it
};

/// Parses JSON whose author is not known. The long list itself is empty in what is returned.
/// @throws Error  (Kind::Input) if it is no JSON, is over the limits, has a key twice in an object or a number that no
///                double holds, or if take() throws it
[[nodiscard]] ParsedJson parseJson(std::string_view text, const LongList&, JsonLimits);

}  // namespace inkedge::io
