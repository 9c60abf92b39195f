#include "mesh/heat_smoothing.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/parallel.h"

namespace inkedge::mesh {
namespace {

constexpr double remainder = 0.01;   // of what smoothing has to change, that may be left
constexpr double maxRadius = 0.999;  // slivers come nearer to 1, and are left less smooth
constexpr int maxSteps = 64;

}  // namespace

HeatSmoothing::HeatSmoothing(const std::vector<Edge>& edges, const std::vector<double>& areas, double variance)
    : begins_(areas.size() + 1, 0), own_(areas.size(), 1.0F) {
    const double time = 0.5 * variance;
    std::vector<double> sums(areas.size(), 0.0);
    for (const Edge& edge : edges) {
        for (const std::uint32_t p : {edge.a, edge.b}) {
            ++begins_[p + 1];
            sums[p] += time * edge.conductance;
        }
    }
    for (std::size_t p = 0; p < areas.size(); ++p) begins_[p + 1] += begins_[p];
    neighbours_.resize(begins_.back());
    std::vector<std::uint32_t> next{begins_.begin(), begins_.end() - 1};
    std::vector<float> shares(areas.size(), 0.0F);
    for (std::size_t p = 0; p < areas.size(); ++p) {
        if (sums[p] + areas[p] <= 0.0) continue;
        shares[p] = static_cast<float>(sums[p] / (sums[p] + areas[p]));
        own_[p] = 1.0F - shares[p];
    }
    for (const Edge& edge : edges) {
        for (const auto& [from, to] : {std::pair{edge.a, edge.b}, std::pair{edge.b, edge.a}}) {
            const double all = sums[from] + areas[from];
            const double weight = all > 0.0 ? time * edge.conductance / all : 0.0;
            neighbours_[next[from]++] = {to, static_cast<float>(weight)};
        }
    }
    if (shares.empty()) return;
    const auto high = shares.begin() + static_cast<std::ptrdiff_t>(0.95 * static_cast<double>(shares.size()));
    std::nth_element(shares.begin(), high, shares.end());
    radius_ = std::min(static_cast<double>(*high), maxRadius);
}

// Chebyshev's acceleration of Jacobi's iteration: Golub and Varga 1961.
template <std::size_t n>
void HeatSmoothing::smooth(std::vector<std::array<float, n>>& values) const {
    const double root = std::sqrt(1.0 - radius_ * radius_);
    const double rate = radius_ > 0.0 ? (1.0 - root) / radius_ : 0.0;
    const int steps =
        rate > 0.0 ? std::clamp(static_cast<int>(std::ceil(std::log(0.5 * remainder) / std::log(rate))), 1, maxSteps)
                   : 1;
    const std::vector<std::array<float, n>> input = values;
    std::vector<std::array<float, n>> before = values;
    std::vector<std::array<float, n>> after(values.size());
    double omega = 1.0;
    for (int step = 0; step < steps; ++step) {
        if (step == 1) omega = 2.0 / (2.0 - radius_ * radius_);
        if (step > 1) omega = 1.0 / (1.0 - 0.25 * radius_ * radius_ * omega);
        const auto relax = static_cast<float>(omega);
        base::inRanges(values.size(), [&](std::size_t begin, std::size_t end) {
            for (std::size_t p = begin; p < end; ++p) {
                std::array<float, n> sum{};
                for (std::size_t k = 0; k < n; ++k) sum[k] = own_[p] * input[p][k];
                for (std::uint32_t i = begins_[p]; i < begins_[p + 1]; ++i) {
                    const std::array<float, n>& other = values[neighbours_[i].point];
                    for (std::size_t k = 0; k < n; ++k) sum[k] += neighbours_[i].weight * other[k];
                }
                for (std::size_t k = 0; k < n; ++k) after[p][k] = relax * (sum[k] - before[p][k]) + before[p][k];
            }
        });
        std::swap(before, values);  // the last but one
        std::swap(values, after);
    }
}

template void HeatSmoothing::smooth(std::vector<std::array<float, 3>>&) const;
template void HeatSmoothing::smooth(std::vector<std::array<float, 6>>&) const;
template void HeatSmoothing::smooth(std::vector<std::array<float, 10>>&) const;

}  // namespace inkedge::mesh
