#include "base/message.h"

#include <fmt/format.h>

namespace inkedge::base {

void refuse(const std::string& message) { throw Error{Error::Kind::Input, message}; }

void refuseUse(const std::string& message) { throw Error{Error::Kind::Usage, message}; }

namespace {

std::string escapeOf(char c) {
    switch (c) {
        case '\n':
            return "\\n";
        case '\r':
            return "\\r";
        case '\t':
            return "\\t";
        default:
            return fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
    }
}

// The code point of a control character or line separator of Unicode that a text of UTF-8 starts with; 0: another.
unsigned unicodeControlAt(std::string_view text) {
    const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
    if (byte(0) == 0xc2 && byte(1) >= 0x80 && byte(1) < 0xa0) return byte(1);
    const bool separates = byte(0) == 0xe2 && byte(1) == 0x80 && (byte(2) == 0xa8 || byte(2) == 0xa9);
    return separates ? 0x2000U + (byte(2) & 0x3fU) : 0;
}

}  // namespace

std::string printable(std::string_view text) {
    std::string line;
    line.reserve(text.size());
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto c = static_cast<unsigned char>(text[i]);
        const unsigned wide = c < 0x80 ? 0 : unicodeControlAt(text.substr(i));
        if (wide != 0) {
            line += fmt::format("\\u{:04x}", wide);
            i += wide < 0x100 ? 1 : 2;
        } else if (c < 0x20 || c == 0x7f) {
            line += escapeOf(text[i]);
        } else {
            line += text[i];
        }
    }
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
