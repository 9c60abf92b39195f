#pragma once

#include <charconv>
#include <optional>
#include <string_view>

namespace inkedge::load {

inline constexpr std::string_view blanks = " \t\r\n\v\f";

/// Less the blanks that it starts with.
[[nodiscard]] inline std::string_view trimmed(std::string_view text) noexcept {
    const std::size_t start = text.find_first_not_of(blanks);
    return start == std::string_view::npos ? std::string_view{} : text.substr(start);
}

/// The first word, taken off the text; empty if there is none.
[[nodiscard]] inline std::string_view takeWord(std::string_view& text) noexcept {
    text = trimmed(text);
    const std::string_view word = text.substr(0, text.find_first_of(blanks));
    text.remove_prefix(word.size());
    return word;
}

/// The number that a text is, if it is one and nothing else.
template <class Number>
[[nodiscard]] std::optional<Number> toNumber(std::string_view text) noexcept {
    if (text.starts_with('+')) text.remove_prefix(1);
    Number number{};
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (failure != std::errc{} || end != text.data() + text.size()) return {};
    return number;
}

}  // namespace inkedge::load
