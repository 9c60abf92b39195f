#include "mesh/heat_smoothing.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/parallel.h"

namespace inkedge::mesh {
namespace {

// A polynomial of Chebyshev's kind: of a sum of waves, it multiplies one that evens out at a rate r by P(-r variance /
// 2), where P(z) = T_s(w0 + w1 z) / T_s(w0) and P'(0) = 1. Up to a range of -z it is no more than the remainder, and
// stable.
struct Polynomial {
    static constexpr double growth = 5.3;  // of T_s(w0) = cosh(growth): waves that are fast leave a share of 1 / 100

    int degree = 1;
    [[nodiscard]] double at(int j) const { return std::cosh(growth * j / degree); }  // T_j(w0)
    [[nodiscard]] double slope() const {                                             // w1
        return std::sinh(growth / degree) / (degree * std::tanh(growth));
    }
    [[nodiscard]] double range() const { return (at(1) + 1.0) / slope(); }
};

}  // namespace

HeatSmoothing::HeatSmoothing(const std::vector<Edge>& edges, const std::vector<double>& areas)
    : begins_(areas.size() + 1, 0) {
    std::vector<double> sums(areas.size(), 0.0);
    for (const Edge& edge : edges) {
        for (const std::uint32_t p : {edge.a, edge.b}) {
            ++begins_[p + 1];
            sums[p] += edge.conductance;
        }
    }
    std::vector<double> rates;
    for (std::size_t p = 0; p < areas.size(); ++p) {
        begins_[p + 1] += begins_[p];
        if (sums[p] > 0.0 && areas[p] > 0.0) rates.push_back(sums[p] / areas[p]);
    }
    if (rates.empty()) {
        begins_.assign(areas.size() + 1, 0);
        return;
    }
    // Points of tiny slivers would need many more sweeps than all others; they are as slow as the fastest of these.
    const auto high = rates.begin() + static_cast<std::ptrdiff_t>(0.95 * static_cast<double>(rates.size()));
    std::nth_element(rates.begin(), high, rates.end());
    maxRate_ = 2.0 * *high;
    neighbours_.resize(begins_.back());
    std::vector<std::uint32_t> next{begins_.begin(), begins_.end() - 1};
    for (const Edge& edge : edges) {
        for (const auto& [from, to] : {std::pair{edge.a, edge.b}, std::pair{edge.b, edge.a}}) {
            const double area = std::max(areas[from], sums[from] / *high);
            neighbours_[next[from]++] = {to, static_cast<float>(edge.conductance / area)};
        }
    }
}

template <std::size_t n>
void HeatSmoothing::smooth(std::vector<std::array<float, n>>& values, double variance) const {
    const double time = 0.5 * variance;
    Polynomial polynomial;
    while (polynomial.range() < time * maxRate_) ++polynomial.degree;
    const auto w0 = static_cast<float>(polynomial.at(1));
    const auto w1 = static_cast<float>(polynomial.slope() * time);
    std::vector<std::array<float, n>> before(values.size());
    std::vector<std::array<float, n>> after(values.size());
    for (int j = 0; j < polynomial.degree; ++j) {
        const auto factor = static_cast<float>((j == 0 ? 1.0 : 2.0) * polynomial.at(j) / polynomial.at(j + 1));
        const auto back = static_cast<float>(j == 0 ? 0.0 : polynomial.at(j - 1) / polynomial.at(j + 1));
        base::inRanges(values.size(), [&](std::size_t begin, std::size_t end) {
            for (std::size_t p = begin; p < end; ++p) {
                const std::array<float, n>& own = values[p];
                std::array<float, n> flow{};
                for (std::uint32_t i = begins_[p]; i < begins_[p + 1]; ++i) {
                    const auto& [point, rate] = neighbours_[i];
                    for (std::size_t k = 0; k < n; ++k) flow[k] += rate * (values[point][k] - own[k]);
                }
                for (std::size_t k = 0; k < n; ++k)
                    after[p][k] = factor * (w0 * own[k] + w1 * flow[k]) - back * before[p][k];
            }
        });
        std::swap(before, values);  // the last but one
        std::swap(values, after);
    }
}

template void HeatSmoothing::smooth(std::vector<std::array<float, 3>>&, double) const;
template void HeatSmoothing::smooth(std::vector<std::array<float, 6>>&, double) const;
template void HeatSmoothing::smooth(std::vector<std::array<float, 10>>&, double) const;

}  // namespace inkedge::mesh
