#include "cli/checks.h"

#include <charconv>
#include <cmath>
#include <optional>
#include <string>

#include <fmt/format.h>

namespace inkedge::cli {
namespace {

std::optional<double> number(const std::string& text) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || std::isnan(value)) return std::nullopt;
    return value;
}

std::string refusal(const std::string& low, double high, const std::string& text) {
    const std::string range = high == unlimited ? low : fmt::format("{} to {}", low, high);
    return fmt::format("expected a number {}, found '{}'", range, text);
}

}  // namespace

CLI::Validator numberFrom(double low, double high) {
    return {[low, high](const std::string& text) {
                const auto value = number(text);
                if (value && *value >= low && *value <= high) return std::string{};
                return refusal(fmt::format("from {}", low), high, text);
            },
            ""};
}

CLI::Validator numberOver(double low, double high) {
    return {[low, high](const std::string& text) {
                const auto value = number(text);
                if (value && *value > low && *value <= high) return std::string{};
                return refusal(fmt::format("over {}", low), high, text);
            },
            ""};
}

}  // namespace inkedge::cli
