#include "formats/implicit/zeros.h"

#include <algorithm>
#include <cstddef>
#include <span>

#include <glm/common.hpp>

#include "base/parallel.h"

namespace inkedge::implicit {
namespace {

constexpr std::size_t batch = 4096;  // positions that a thread evaluates at once

// Of an edge.
struct Search {
    double low = 0.0;  // shares of the edge, between which the zero lies
    double high = 1.0;
    double atLow = 0.0;
    double atHigh = 0.0;
    int side = 0;  // of the last step
    double share = 0.0;
};

glm::dvec3 guess(Search& s, const Edge& edge) {
    if (s.low < s.high) {
        s.share = (s.atHigh * s.low - s.atLow * s.high) / (s.atHigh - s.atLow);
        if (!(s.share > s.low && s.share < s.high)) s.share = 0.5 * (s.low + s.high);
    }
    return glm::mix(edge.first, edge.second, s.share);
}

// False: it is found.
bool narrow(Search& s, double value) {
    constexpr double exact = 1e-13;
    if (s.low == s.high) return false;
    if (value == 0.0) {
        s.low = s.high = s.share;
    } else if (value < 0.0) {
        s.low = s.share;
        s.atLow = value;
        if (s.side < 0) s.atHigh *= 0.5;
        s.side = -1;
    } else {
        s.high = s.share;
        s.atHigh = value;
        if (s.side > 0) s.atLow *= 0.5;
        s.side = 1;
    }
    return s.high - s.low > exact;
}

}  // namespace

std::vector<double> valuesAt(const ScalarField& field, const std::vector<glm::dvec3>& at) {
    std::vector<double> values(at.size());
    base::onEach((at.size() + batch - 1) / batch, [&](std::size_t i) {
        const std::size_t begin = i * batch;
        const std::size_t count = std::min(batch, at.size() - begin);
        field.evaluate(std::span{at}.subspan(begin, count), std::span{values}.subspan(begin, count));
    });
    return values;
}

std::vector<glm::dvec3> zerosOn(const ScalarField& field, const std::vector<Edge>& edges) {
    constexpr int steps = 24;
    std::vector<glm::dvec3> ends;
    for (const auto& [under, over] : edges) ends.insert(ends.end(), {under, over});
    const std::vector<double> atEnds = valuesAt(field, ends);
    std::vector<Search> searches(edges.size());
    for (std::size_t i = 0; i < edges.size(); ++i) {
        searches[i].atLow = atEnds[2 * i];
        searches[i].atHigh = atEnds[2 * i + 1];
        if (edges[i].first == edges[i].second) searches[i].low = searches[i].high;
    }
    std::vector<glm::dvec3> zeros(edges.size());
    for (int step = 0; step < steps; ++step) {
        for (std::size_t i = 0; i < edges.size(); ++i) zeros[i] = guess(searches[i], edges[i]);
        const std::vector<double> values = valuesAt(field, zeros);
        bool goesOn = false;
        for (std::size_t i = 0; i < edges.size(); ++i) goesOn = narrow(searches[i], values[i]) || goesOn;
        if (!goesOn) break;
    }
    return zeros;
}

}  // namespace inkedge::implicit
