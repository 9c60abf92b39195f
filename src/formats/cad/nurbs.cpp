#include "formats/cad/nurbs.h"

#include <algorithm>
#include <cmath>

#include <glm/vec3.hpp>

namespace inkedge::cad {
namespace {

constexpr std::size_t maxDegree = 25;  // of OpenCASCADE

using Row = std::array<double, maxDegree + 1>;  // of a degree's functions, set up to the degree: seldom over 5

// The functions of a degree that are not zero at a parameter, and their first two derivatives.
struct Basis {
    std::size_t first;  // the first pole's number
    std::array<Row, 3> values;
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

// Calls add(j, right, left) for each function of degree p - 1, with the knots between which it is not zero.
template <class Add>
void eachFunction(const std::vector<double>& knots, std::size_t span, std::size_t p, Add&& add) {
    for (std::size_t j = 0; j < p; ++j) add(j, knots[span + j + 1], knots[span + j + 1 - p]);
}

// The functions of degree p, from those of degree p - 1.
void raise(double t, const std::vector<double>& knots, std::size_t span, std::size_t p, const Row& lower, Row& row) {
    std::fill_n(row.begin(), p + 1, 0.0);
    eachFunction(knots, span, p, [&](std::size_t j, double right, double left) {
        const double share = right > left ? lower[j] / (right - left) : 0.0;
        row[j] += (right - t) * share;
        row[j + 1] += (t - left) * share;
    });
}

// The derivatives of functions of degree p, from those of degree p - 1.
void derive(const std::vector<double>& knots, std::size_t span, std::size_t p, const Row& lower, Row& row) {
    std::fill_n(row.begin(), p + 1, 0.0);
    eachFunction(knots, span, p, [&](std::size_t j, double right, double left) {
        const double slope = right > left ? static_cast<double>(p) * lower[j] / (right - left) : 0.0;
        row[j] -= slope;
        row[j + 1] += slope;
    });
}

// By the recursion of Cox and de Boor; a derivative of degree p is p times a difference of functions of degree p - 1.
void setBasis(Basis& basis, double t, const std::vector<double>& knots, std::size_t degree, double period) {
    t = reduced(t, knots, degree, period);
    const std::size_t span = spanOf(t, knots, degree);
    std::array<Row, 3> rows;  // that of degree p, from function span - p on, at p % 3
    rows[0][0] = 1.0;
    for (std::size_t p = 1; p <= degree; ++p) raise(t, knots, span, p, rows[(p - 1) % 3], rows[p % 3]);
    basis.first = span - degree;
    std::copy_n(rows[degree % 3].begin(), degree + 1, basis.values[0].begin());
    for (std::size_t d = 1; d < basis.values.size(); ++d) std::fill_n(basis.values[d].begin(), degree + 1, 0.0);
    if (degree >= 1) derive(knots, span, degree, rows[(degree - 1) % 3], basis.values[1]);
    if (degree < 2) return;
    Row once;
    derive(knots, span, degree - 1, rows[(degree - 2) % 3], once);
    derive(knots, span, degree, once, basis.values[2]);
}

// Of x = A / w, by the quotient rule.
glm::dvec3 quotient(glm::dvec4 a) { return glm::dvec3{a} / a.w; }

}  // namespace

CurvePoint nurbsAt(const CurveData& curve, double t) {
    Basis basis;
    setBasis(basis, t, curve.knots, curve.degree, curve.period);
    std::array<glm::dvec4, 3> a{};
    for (std::size_t d = 0; d < a.size(); ++d)
        for (std::size_t i = 0; i <= curve.degree; ++i) a[d] += basis.values[d][i] * curve.poles[basis.first + i];
    const glm::dvec3 x = quotient(a[0]);
    const glm::dvec3 first = (glm::dvec3{a[1]} - a[1].w * x) / a[0].w;
    const glm::dvec3 second = (glm::dvec3{a[2]} - 2.0 * a[1].w * first - a[2].w * x) / a[0].w;
    return {x, first, second};
}

mesh::SurfaceDerivatives nurbsAt(const SurfaceData& surface, glm::dvec2 uv) {
    Basis u;
    Basis v;
    setBasis(u, uv.x, surface.knotsU, surface.degreeU, surface.periodU);
    setBasis(v, uv.y, surface.knotsV, surface.degreeV, surface.periodV);
    const std::size_t columns = surface.knotsV.size() - surface.degreeV - 1;
    glm::dvec4 a{0.0}, au{0.0}, av{0.0}, auu{0.0}, auv{0.0}, avv{0.0};
    for (std::size_t i = 0; i <= surface.degreeU; ++i) {
        const glm::dvec4* const poles = &surface.poles[(u.first + i) * columns + v.first];
        std::array<glm::dvec4, 3> row{};  // and its derivatives by v
        for (std::size_t j = 0; j <= surface.degreeV; ++j)
            for (std::size_t d = 0; d < row.size(); ++d) row[d] += v.values[d][j] * poles[j];
        a += u.values[0][i] * row[0];
        au += u.values[1][i] * row[0];
        auu += u.values[2][i] * row[0];
        av += u.values[0][i] * row[1];
        auv += u.values[1][i] * row[1];
        avv += u.values[0][i] * row[2];
    }
    mesh::SurfaceDerivatives p;
    p.position = quotient(a);
    p.du = (glm::dvec3{au} - au.w * p.position) / a.w;
    p.dv = (glm::dvec3{av} - av.w * p.position) / a.w;
    p.duu = (glm::dvec3{auu} - 2.0 * au.w * p.du - auu.w * p.position) / a.w;
    p.duv = (glm::dvec3{auv} - au.w * p.dv - av.w * p.du - auv.w * p.position) / a.w;
    p.dvv = (glm::dvec3{avv} - 2.0 * av.w * p.dv - avv.w * p.position) / a.w;
    return p;
}

}  // namespace inkedge::cad
