#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include <inkedge/error.h>
#include <inkedge/export.h>

namespace inkedge::base {

/// @throws Error  (Kind::Input) always, with this message
[[noreturn]] void refuse(const std::string& message);

/// @throws Error  (Kind::Usage) always, with this message
[[noreturn]] void refuseUse(const std::string& message);

/// Text from outside as one line: control characters, those of Unicode and its line separators among them, become
/// escapes: "\n", "\x1b", "\u2028". What is printable already stays as it is. The command calls it in the shared
/// library; other programs are not offered it.
[[nodiscard]] INKEDGE_API std::string printable(std::string_view text);

/// Text from outside for a message: printable, between quotes, cut after about 80 bytes.
[[nodiscard]] std::string quote(std::string_view text);

/// "node 3 'wheel'", or "node 3" without a name.
[[nodiscard]] std::string label(std::string_view kind, std::size_t index, std::string_view name = {});

/// Runs an action. If it throws an Error, that is thrown on with "where: " before its message.
template <class Action>
auto within(const std::string& where, Action&& action) -> decltype(action()) {
    try {
        return action();
    } catch (const Error& error) {
        throw Error{error.kind(), where + ": " + error.what()};
    }
}

}  // namespace inkedge::base
