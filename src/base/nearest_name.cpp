#include "base/nearest_name.h"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace inkedge::base {
namespace {

// Damerau's distance, no part exchanged twice (optimal string alignment).
std::size_t distance(std::string_view a, std::string_view b) {
    const auto zeros = std::vector<std::size_t>(b.size() + 1);
    std::vector<std::size_t> twoAbove = zeros;
    std::vector<std::size_t> above = zeros;
    std::vector<std::size_t> row = zeros;  // from all of a so far to each start of b
    std::iota(row.begin(), row.end(), 0U);
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::swap(twoAbove, above);
        std::swap(above, row);
        row[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            row[j + 1] = std::min({above[j] + (a[i] == b[j] ? 0 : 1), row[j] + 1, above[j + 1] + 1});
            if (i > 0 && j > 0 && a[i] == b[j - 1] && a[i - 1] == b[j])
                row[j + 1] = std::min(row[j + 1], twoAbove[j - 1] + 1);
        }
    }
    return row.back();
}

}  // namespace

std::string nearestName(std::string_view text, std::span<const std::string_view> names) {
    constexpr std::size_t longest = 100;
    if (text.size() < 2 || text.size() > longest) return {};
    std::string nearest;
    std::size_t smallest = std::max<std::size_t>(text.size() / 4, 1);
    for (const std::string_view name : names) {
        const std::size_t found = distance(text, name);
        if (found > smallest || (found == smallest && !nearest.empty())) continue;
        smallest = found;
        nearest = name;
    }
    return nearest;
}

std::string suggestion(std::string_view text, std::span<const std::string_view> names) {
    const std::string nearest = nearestName(text, names);
    return nearest.empty() ? nearest : "; is it " + nearest + "?";
}

}  // namespace inkedge::base
