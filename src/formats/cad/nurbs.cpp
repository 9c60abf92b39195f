#include "formats/cad/nurbs.h"

#include <algorithm>
#include <cmath>

#include <glm/vec3.hpp>

namespace inkedge::cad {
namespace {

constexpr std::size_t maxDegree = 25;  // of OpenCASCADE

// The functions of a degree that are not zero at a parameter, and their first two derivatives.
struct Basis {
    std::size_t first = 0;  // the first pole's number
    std::array<std::array<double, maxDegree + 1>, 3> values{};
};

double reduced(double t, const std::vector<double>& knots, std::size_t degree, double period) {
    if (!(period > 0.0)) return t;
    const double low = knots[degree];
    return t - period * std::floor((t - low) / period);
}

// The number of the last knot before t that begins a piece.
std::size_t spanOf(double t, const std::vector<double>& knots, std::size_t degree) {
    const auto end = knots.end() - static_cast<std::ptrdiff_t>(degree) - 1;
    const auto begin = knots.begin() + static_cast<std::ptrdiff_t>(degree);
    auto after = std::upper_bound(begin, end, t);
    if (after == begin) after = std::upper_bound(begin, end, *begin);
    if (after == end) after = std::lower_bound(begin, end, *end);
    return static_cast<std::size_t>(after - knots.begin()) - 1;
}

// By the recursion of Cox and de Boor; a derivative of degree p is p times a difference of functions of degree p - 1.
Basis basisAt(double t, const std::vector<double>& knots, std::size_t degree, double period) {
    t = reduced(t, knots, degree, period);
    const std::size_t span = spanOf(t, knots, degree);
    using Row = std::array<double, maxDegree + 1>;
    Row row{1.0};               // of degree p, from function span - p on
    std::array<Row, 3> last{};  // of the last three degrees, the highest first
    last[0] = row;
    for (std::size_t p = 1; p <= degree; ++p) {
        Row next{};
        for (std::size_t j = 0; j < p; ++j) {
            const double right = knots[span + j + 1];
            const double left = knots[span + j + 1 - p];
            const double share = right > left ? row[j] / (right - left) : 0.0;
            next[j] += (right - t) * share;
            next[j + 1] += (t - left) * share;
        }
        row = next;
        last = {row, last[0], last[1]};
    }
    // The derivatives of functions of degree p, from those of degree p - 1.
    const auto derived = [&](const Row& lower, std::size_t p) {
        Row result{};
        for (std::size_t j = 0; j < p; ++j) {
            const double right = knots[span + j + 1];
            const double left = knots[span + j + 1 - p];
            const double slope = right > left ? static_cast<double>(p) * lower[j] / (right - left) : 0.0;
            result[j] -= slope;
            result[j + 1] += slope;
        }
        return result;
    };
    Basis basis;
    basis.first = span - degree;
    basis.values[0] = last[0];
    if (degree >= 1) basis.values[1] = derived(last[1], degree);
    if (degree >= 2) basis.values[2] = derived(derived(last[2], degree - 1), degree);
    return basis;
}

// Of x = A / w, by the quotient rule.
glm::dvec3 quotient(glm::dvec4 a) { return glm::dvec3{a} / a.w; }

}  // namespace

CurvePoint nurbsAt(const CurveData& curve, double t) {
    const Basis basis = basisAt(t, curve.knots, curve.degree, curve.period);
    std::array<glm::dvec4, 3> a{};
    for (std::size_t d = 0; d < a.size(); ++d)
        for (std::size_t i = 0; i <= curve.degree; ++i) a[d] += basis.values[d][i] * curve.poles[basis.first + i];
    const glm::dvec3 x = quotient(a[0]);
    const glm::dvec3 first = (glm::dvec3{a[1]} - a[1].w * x) / a[0].w;
    const glm::dvec3 second = (glm::dvec3{a[2]} - 2.0 * a[1].w * first - a[2].w * x) / a[0].w;
    return {x, first, second};
}

SurfacePoint nurbsAt(const SurfaceData& surface, glm::dvec2 uv) {
    const Basis u = basisAt(uv.x, surface.knotsU, surface.degreeU, surface.periodU);
    const Basis v = basisAt(uv.y, surface.knotsV, surface.degreeV, surface.periodV);
    const std::size_t columns = surface.knotsV.size() - surface.degreeV - 1;
    const auto sum = [&](std::size_t du, std::size_t dv) {
        glm::dvec4 total{0.0};
        for (std::size_t i = 0; i <= surface.degreeU; ++i) {
            glm::dvec4 row{0.0};
            for (std::size_t j = 0; j <= surface.degreeV; ++j)
                row += v.values[dv][j] * surface.poles[(u.first + i) * columns + v.first + j];
            total += u.values[du][i] * row;
        }
        return total;
    };
    const glm::dvec4 a = sum(0, 0);
    const glm::dvec4 au = sum(1, 0);
    const glm::dvec4 av = sum(0, 1);
    const glm::dvec4 auu = sum(2, 0);
    const glm::dvec4 auv = sum(1, 1);
    const glm::dvec4 avv = sum(0, 2);
    SurfacePoint p;
    p.position = quotient(a);
    p.du = (glm::dvec3{au} - au.w * p.position) / a.w;
    p.dv = (glm::dvec3{av} - av.w * p.position) / a.w;
    p.duu = (glm::dvec3{auu} - 2.0 * au.w * p.du - auu.w * p.position) / a.w;
    p.duv = (glm::dvec3{auv} - au.w * p.dv - av.w * p.du - auv.w * p.position) / a.w;
    p.dvv = (glm::dvec3{avv} - 2.0 * av.w * p.dv - avv.w * p.position) / a.w;
    return p;
}

}  // namespace inkedge::cad
