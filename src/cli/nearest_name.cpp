#include "cli/nearest_name.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace inkedge::cli {
namespace {

std::size_t distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);  // from all of a so far to each start of b
    std::iota(row.begin(), row.end(), 0U);
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t exchanged = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({exchanged, row[j] + 1, row[j + 1] + 1});
        }
    }
    return row.back();
}

}  // namespace

std::string nearestName(std::string_view text, std::span<const std::string> names) {
    constexpr std::size_t longest = 100;
    if (text.size() > longest) return {};
    std::string nearest;
    std::size_t smallest = std::max<std::size_t>(text.size() / 4, 1);
    for (const std::string& name : names) {
        const std::size_t found = distance(text, name);
        if (found > smallest || (found == smallest && !nearest.empty())) continue;
        smallest = found;
        nearest = name;
    }
    return nearest;
}

}  // namespace inkedge::cli
