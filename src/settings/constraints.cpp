#include "settings/constraints.h"

#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace inkedge::settings {
namespace {

// A limit from here on only keeps numbers from overflowing: the manual does not mention it.
constexpr double farLimit = 1e6;

constexpr std::string_view degrees = "DEG";

}  // namespace

std::string expectation(const Number& number) {
    const auto& [min, max, unit, open, zeroToo] = number;
    if (std::isinf(min) && std::isinf(max)) return "a number";
    if (open && std::isinf(max)) return fmt::format("a number over {}", min);
    if (open) return fmt::format("{} over {} and under {}", unit == degrees ? "degrees" : "a number", min, max);
    return fmt::format("{}a number from {} to {}", zeroToo ? "0 or " : "", min, max);
}

std::string expectation(const Count& count) {
    const auto& [min, max, unit, last, suffixes, choices] = count;
    if (!choices.empty())
        return fmt::format("{} or {}", fmt::join(choices.first(choices.size() - 1), ", "), choices.back());
    if (max == static_cast<std::uint64_t>(std::numeric_limits<int>::max()))
        return fmt::format("a whole number from {}", min);
    return fmt::format("a whole number from {} to {}{}", min, max, suffixes ? ", k, M or G after it if wished" : "");
}

std::string expectation(std::span<const std::string_view> names) {
    return fmt::format("{}{}", names.size() > 1 ? "one of " : "", fmt::join(names, ", "));
}

std::string rangeOf(const Number& number) {
    const auto& [min, max, unit, open, zeroToo] = number;
    if (std::isinf(min) && std::isinf(max)) return unit == degrees ? "any angle" : "any number";
    if (open && std::isinf(max)) return fmt::format("over {}", min);
    if (open) return fmt::format("over {}, under {}", min, max);
    if (max >= farLimit) return fmt::format("{} or more", zeroToo ? 0.0 : min);
    return fmt::format("{}{} to {}", zeroToo ? "0, or " : "", min, max);
}

std::string rangeOf(const Count& count) {
    if (!count.choices.empty()) return "one of these";
    if (!count.last.empty()) return fmt::format("{} to {}", count.min, count.last);
    return fmt::format("{} to {}{}", count.min, count.max, count.suffixes ? "; k, M, G may follow" : "");
}

std::string rangeOf(const Choice&) { return "one of these"; }
std::string rangeOf(const List& list) { return fmt::format("{}", fmt::join(list.names, ", ")); }
std::string rangeOf(const Custom& custom) { return custom.range(); }

std::string formOf(const Number& number) { return std::string{number.unit}; }

std::string formOf(const Count& count) {
    return count.choices.empty() ? std::string{count.unit} : fmt::format("{}", fmt::join(count.choices, "|"));
}

std::string formOf(const Choice& choice) { return fmt::format("{}", fmt::join(choice.names, "|")); }
std::string formOf(const List& list) { return fmt::format("{},...", list.unit); }
std::string formOf(const Custom& custom) { return std::string{custom.form}; }

}  // namespace inkedge::settings
