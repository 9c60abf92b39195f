#include "sheet/scales.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace inkedge::sheet {
namespace {

constexpr int decades = 12;  // from a nanometre as a metre to a metre as a nanometre, and more

std::vector<double> makeScales() {
    std::vector<double> scales;
    for (int decade = 0; decade <= decades; ++decade) {
        for (const double step : {1.0, 2.0, 5.0}) {
            const double times = step * std::pow(10.0, decade);
            scales.push_back(times);
            if (times > 1.0) scales.push_back(1.0 / times);
        }
    }
    std::ranges::sort(scales, std::greater<>{});
    return scales;
}

}  // namespace

const std::vector<double>& standardScales() {
    static const std::vector<double> scales = makeScales();
    return scales;
}

}  // namespace inkedge::sheet
