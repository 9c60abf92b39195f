#include "base/message.h"

#include <algorithm>

#include <fmt/format.h>

namespace inkedge::base {

void refuse(const std::string& message) { throw Error{Error::Kind::Input, message}; }

std::string printable(std::string_view text) {
    std::string line{text};
    std::ranges::replace_if(
        line, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }, '?');
    return line;
}

std::string quote(std::string_view text) {
    constexpr std::size_t longest = 80;
    if (text.size() <= longest) return fmt::format("'{}'", printable(text));
    std::size_t end = longest;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80) --end;  // not inside a UTF-8 sequence
    return fmt::format("'{}...'", printable(text.substr(0, end)));
}

std::string label(std::string_view kind, std::size_t index, std::string_view name) {
    return name.empty() ? fmt::format("{} {}", kind, index) : fmt::format("{} {} {}", kind, index, quote(name));
}

}  // namespace inkedge::base
