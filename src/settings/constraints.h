#pragma once

#include <string>

#include <inkedge/setting_table.h>

/// Constraints in words.
namespace inkedge::settings {

/// "a number from 0.5 to 32": what follows "expected" in messages.
[[nodiscard]] std::string expectation(const Number&);
[[nodiscard]] std::string expectation(const Count&);
/// "one of sobel, farid"
[[nodiscard]] std::string expectation(std::span<const std::string_view> names);

/// "0.5 to 32": what the manual says.
[[nodiscard]] std::string rangeOf(const Number&);
[[nodiscard]] std::string rangeOf(const Count&);
[[nodiscard]] std::string rangeOf(const Choice&);
[[nodiscard]] std::string rangeOf(const List&);
[[nodiscard]] std::string rangeOf(const Custom&);

/// "PX", "auto|egl": what stands for the value after a flag in the help.
[[nodiscard]] std::string formOf(const Number&);
[[nodiscard]] std::string formOf(const Count&);
[[nodiscard]] std::string formOf(const Choice&);
[[nodiscard]] std::string formOf(const List&);
[[nodiscard]] std::string formOf(const Custom&);

}  // namespace inkedge::settings
