#pragma once

#include <charconv>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace inkedge::formats {

[[nodiscard]] constexpr bool isBlank(char c) noexcept { return c == ' ' || (c >= '\t' && c <= '\r'); }

/// A text without the byte-order mark of UTF-8 that it may start with.
[[nodiscard]] inline std::string_view withoutByteOrderMark(std::string_view text) noexcept {
    constexpr std::string_view mark = "\xef\xbb\xbf";
    return text.substr(text.starts_with(mark) ? mark.size() : 0);
}

/// Whether a text says by its byte-order mark that it is in UTF-16, which no format is.
[[nodiscard]] inline bool isUtf16(std::string_view text) noexcept {
    return text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff");
}

/// A text without the blanks at its start.
[[nodiscard]] inline std::string_view trimmed(std::string_view text) noexcept {
    std::size_t start = 0;
    while (start < text.size() && isBlank(text[start])) ++start;
    return text.substr(start);
}

/// The first word of a text, which is removed from it; empty if there is none.
[[nodiscard]] inline std::string_view takeWord(std::string_view& text) noexcept {
    text = trimmed(text);
    std::size_t end = 0;
    while (end < text.size() && !isBlank(text[end])) ++end;
    const std::string_view word = text.substr(0, end);
    text.remove_prefix(end);
    return word;
}

/// "1 mesh", "2 meshes".
/// @param several  the plural; empty: the word with an s
[[nodiscard]] inline std::string counted(std::uint64_t count, std::string_view word, std::string_view several = {}) {
    std::string text = std::to_string(count) + ' ';
    if (count == 1 || several.empty()) text += word;
    if (count != 1) text += several.empty() ? "s" : several;
    return text;
}

/// The number that a whole text stands for; none if it is no number.
template <class Number>
[[nodiscard]] std::optional<Number> toNumber(std::string_view text) noexcept {
    if (text.starts_with('+')) text.remove_prefix(1);
    Number number{};
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (failure != std::errc{} || end != text.data() + text.size()) return {};
    return number;
}

}  // namespace inkedge::formats
