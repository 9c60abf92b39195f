#include "mesh/simplify_loop.h"

#include <algorithm>
#include <cstddef>

#include <glm/geometric.hpp>

#include "curves/simplify.h"

namespace inkedge::mesh {
namespace {

std::size_t farthestFrom(const Polygon& loop, std::size_t from) {
    std::size_t farthest = from;
    for (std::size_t i = 0; i < loop.size(); ++i)
        if (glm::distance(loop[i], loop[from]) > glm::distance(loop[farthest], loop[from])) farthest = i;
    return farthest;
}

}  // namespace

Polygon simplified(const Polygon& loop, const std::vector<bool>& fixed, double tolerance) {
    const std::size_t n = loop.size();
    std::vector<std::size_t> stays;
    for (std::size_t i = 0; i < n; ++i)
        if (fixed[i]) stays.push_back(i);
    if (stays.empty()) stays.push_back(0);
    if (stays.size() == 1) stays.push_back(farthestFrom(loop, stays[0]));
    std::ranges::sort(stays);
    Polygon twice = loop;  // the last part goes over the loop's start
    twice.insert(twice.end(), loop.begin(), loop.end());
    std::vector<bool> kept(2 * n, false);
    for (std::size_t i = 0; i < stays.size(); ++i) {
        kept[stays[i]] = true;
        curves::keepBetween(twice, stays[i], i + 1 < stays.size() ? stays[i + 1] : stays[0] + n, tolerance, kept);
    }
    Polygon result;
    for (std::size_t i = 0; i < n; ++i)
        if (kept[i] || kept[n + i]) result.push_back(loop[i]);
    return result;
}

}  // namespace inkedge::mesh
