#pragma once

#include <string>

namespace inkedge::settings {

/// A value of JSON as the text that set() takes: what is no text as JSON writes it, lists with commas between.
template <class Json>
[[nodiscard]] std::string textOfJson(const Json& value) {
    if (value.is_string()) return value.template get<std::string>();
    if (!value.is_array()) return value.dump();
    std::string text;
    for (const Json& item : value) text += (text.empty() ? "" : ",") + item.dump();
    return text;
}

}  // namespace inkedge::settings
