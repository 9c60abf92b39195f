#include "lines/find/view_curvature.h"

#include <cmath>

#include <gtest/gtest.h>

#include "mesh/curved_shapes.h"

namespace inkedge::lines {
namespace {

const curved::EllipsoidAt ellipsoid{{1.5, 1.0, 0.7}};

glm::dvec3 onEllipsoid(glm::dvec3 p) { return p / glm::length(p / ellipsoid.axes); }

// The exact form of the ellipsoid, lengths in its unit.
mesh::PointForm formAt(glm::dvec3 p) {
    const glm::dvec3 n = ellipsoid.normal(p);
    const glm::dvec3 u = glm::normalize(glm::cross(n, glm::dvec3{0.3, 0.5, 0.8}));
    const glm::dvec3 v = glm::cross(n, u);
    const glm::dmat3 s = ellipsoid.tensor(p);
    const double angle = 0.5 * std::atan2(2.0 * glm::dot(u, s * v), glm::dot(u, s * u) - glm::dot(v, s * v));
    const glm::dvec3 first = std::cos(angle) * u + std::sin(angle) * v;
    const glm::dvec3 second = glm::cross(n, first);
    const auto growth = [&](glm::dvec3 along, glm::dvec3 x, glm::dvec3 y) {
        return static_cast<float>(ellipsoid.derivative(p, along, x, y));
    };
    mesh::PointForm form;
    form.normal = glm::vec3{n};
    form.first = glm::vec3{first};
    form.curvatures = {static_cast<float>(glm::dot(first, s * first)),
                       static_cast<float>(glm::dot(second, s * second))};
    form.derivative = {growth(first, first, first), growth(first, first, second), growth(first, second, second),
                       growth(second, second, second)};
    return form;
}

// Points all over the ellipsoid that an eye sees well, not quite at its planes of symmetry.
template <class Visit>
void forEachSeen(glm::dvec3 eye, bool orthographic, Visit visit) {
    for (double a = 0.1; a < 6.3; a += 0.37) {
        for (double b = -1.4; b < 1.5; b += 0.31) {
            const glm::dvec3 p = onEllipsoid({std::cos(a) * std::cos(b), std::sin(a) * std::cos(b), std::sin(b)});
            const glm::dvec3 toEye = orthographic ? eye : eye - p;
            const double cosine = glm::dot(ellipsoid.normal(p), glm::normalize(toEye));
            if (cosine > 0.25 && cosine < 0.97) visit(p, toEye);
        }
    }
}

constexpr double step = 1e-3;
constexpr double rounding = 2e-3;  // of floats over the step, and of the step's square

TEST(RadialCurvature, isThatOfTheTensorAlongTheView) {
    int count = 0;
    forEachSeen({3.0, 2.0, 2.5}, false, [&](glm::dvec3 p, glm::dvec3 toEye) {
        const RadialCurvature radial = radialCurvature(formAt(p), toEye);
        const glm::dvec3 n = ellipsoid.normal(p);
        const glm::dvec3 v = glm::normalize(toEye);
        const glm::dvec3 w = glm::normalize(v - glm::dot(v, n) * n);
        EXPECT_NEAR(radial.cosine, glm::dot(n, v), 1e-6);
        EXPECT_NEAR(radial.curvature, glm::dot(w, ellipsoid.tensor(p) * w), 1e-5);
        EXPECT_NEAR(radial.torsion, glm::dot(glm::cross(n, w), ellipsoid.tensor(p) * w), 1e-5);
        EXPECT_NEAR(radial.derivative, ellipsoid.derivative(p, w, w, w), 1e-4);
        ++count;
    });
    EXPECT_GT(count, 20);
}

// By differences over a step in its own direction, which is a step / length in the picture.
TEST(ApparentCurvature, growsAsDifferencesShow) {
    for (const bool orthographic : {true, false}) {
        int count = 0;
        const glm::dvec3 eye{3.0, 2.0, 2.5};
        forEachSeen(eye, orthographic, [&](glm::dvec3 p, glm::dvec3 toEye) {
            const ApparentCurvature seen = apparentCurvature(formAt(p), toEye, orthographic);
            const auto at = [&](double way) {
                const glm::dvec3 q = onEllipsoid(p + way * seen.direction);
                return apparentCurvature(formAt(q), orthographic ? eye : eye - q, orthographic).curvature;
            };
            // What is `step` long on the surface is this much shorter in the picture.
            const double sine = glm::dot(seen.direction, glm::normalize(toEye));
            const double shorter = std::sqrt(1.0 - sine * sine);
            EXPECT_NEAR(seen.derivative * shorter, (at(step) - at(-step)) / (2.0 * step), rounding * 10.0)
                << p.x << ' ' << p.y << ' ' << p.z << (orthographic ? " orthographic" : " perspective");
            ++count;
        });
        EXPECT_GT(count, 20);
    }
}

TEST(ApparentCurvature, ofASphereIsItsCurvatureOverTheCosine) {
    mesh::PointForm form;
    form.normal = {0, 0, 1};
    form.first = {1, 0, 0};
    form.curvatures = {2.0F, 2.0F};
    const ApparentCurvature seen = apparentCurvature(form, {0.6, 0.0, 0.8}, true);
    EXPECT_NEAR(seen.cosine, 0.8, 1e-6);
    EXPECT_NEAR(seen.curvature, 2.0 / 0.8, 1e-6);
    EXPECT_NEAR(std::abs(seen.direction.x), 1.0, 1e-6);
    // Seen from behind it is the same.
    EXPECT_NEAR(apparentCurvature(form, {0.6, 0.0, -0.8}, true).curvature, 2.0 / 0.8, 1e-6);
    EXPECT_NEAR(apparentCurvature(form, {0.6, 0.0, -0.8}, true).derivative *
                    apparentCurvature(form, {0.6, 0.0, -0.8}, true).direction.x,
                -seen.derivative * seen.direction.x, 1e-6);
}

}  // namespace
}  // namespace inkedge::lines
