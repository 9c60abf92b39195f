#include "cli/checks.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/nearest_name.h"

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

CLI::Validator oneOf(std::vector<std::string> names) {
    return {[names = std::move(names)](const std::string& text) {
                if (std::ranges::find(names, text) != names.end()) return std::string{};
                const std::vector<std::string_view> views{names.begin(), names.end()};
                return fmt::format("expected one of {}, found '{}'{}", fmt::join(names, ", "), text,
                                   base::suggestion(text, views));
            },
            ""};
}

}  // namespace inkedge::cli
