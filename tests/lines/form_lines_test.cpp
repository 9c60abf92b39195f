#include "lines/find/form_lines.h"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>

#include "lines/views.h"
#include "mesh/curved_shapes.h"
#include "mesh/shapes.h"

namespace inkedge::lines {
namespace {

using testing::IsEmpty;
using testing::Not;

Settings drawing(LineTypes types) {
    Settings settings;
    settings.picture.size = {400, 400};
    settings.picture.lines = types;
    settings.lines.coincident = CoincidentLines::Keep;
    return settings;
}

// Of gentle forms, too.
Settings drawingGentle(LineTypes types) {
    Settings settings = drawing(types);
    settings.lines.form.suggestiveThreshold = settings.lines.form.ridgeThreshold =
        settings.lines.form.apparentThreshold = 0.01;
    return settings;
}

// Every line of the definition, of a surface as smooth as it is.
Settings drawingAll(LineTypes types) {
    Settings settings = drawing(types);
    settings.lines.form = {
        .featureSize = 0.5, .suggestiveThreshold = 0.0, .ridgeThreshold = 0.0, .apparentThreshold = 0.0};
    return settings;
}

std::vector<Line> found(const Mesh& mesh, const Camera& camera, const Settings& settings) {
    const Scene scene = scenes::sceneOf(mesh);
    const LineTypes drawn = settings.picture.lines;
    return views::thoseOf(ObjectLines{scene}.find(camera, settings).lines,
                          [&](const Line& line) { return drawn.contains(line.type); });
}

template <class Visit>
void forEachPoint(const std::vector<Line>& lines, Visit visit) {
    for (const Line& line : lines)
        for (const LinePoint& p : line.points) visit(p.position);
}

double distanceTo(const std::vector<Line>& lines, glm::dvec3 position) {
    double nearest = std::numeric_limits<double>::infinity();
    forEachPoint(lines, [&](glm::dvec3 p) { nearest = std::min(nearest, glm::distance(p, position)); });
    return nearest;
}

double longestEdge(const Mesh& mesh) {
    double longest = 0.0;
    for (std::size_t t = 0; t < mesh.indices.size(); t += 3)
        for (std::size_t k = 0; k < 3; ++k)
            longest =
                std::max(longest, static_cast<double>(glm::distance(mesh.positions[mesh.indices[t + k]],
                                                                    mesh.positions[mesh.indices[t + (k + 1) % 3]])));
    return longest;
}

const std::array cameras{views::perspective({1.5, 2.0, 5.0}), views::orthographic({3.0, 1.0, 4.0}, 4.0)};

TEST(FormLines, areNotOnSpheresCylindersAndPlanes) {
    Mesh tube = mesh::prism(64, 2.0);
    const std::array<Mesh, 5> shapes{scenes::sphere(1.0, 64), curved::ellipsoid(glm::dvec3{1.0}, 40), tube,
                                     scenes::quad({-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}),
                                     curved::sheet(20, [](double, double) { return 0.0; })};
    for (const Mesh& mesh : shapes)
        for (const Camera& camera : cameras)
            EXPECT_THAT(found(mesh, camera, drawing(formLineTypes)), IsEmpty()) << mesh.name;
}

// The curvature of a torus along each of its principal directions is the same all along: both families of its lines of
// curvature are circles, as on every cyclide of Dupin.
TEST(FormLines, ofATorusAreNeitherRidgesNorValleys) {
    const Mesh torus = views::torus(1.0, 0.4, 96, 48);
    for (const Camera& camera : cameras)
        EXPECT_THAT(found(torus, camera, drawing(LineType::Ridge | LineType::Valley)), IsEmpty());
}

// The radial curvature of the torus around the y axis at an angle around the axis and one around the tube.
struct TorusAt {
    static constexpr double ring = 1.0;
    static constexpr double tube = 0.4;
    glm::dvec3 toEye;  // orthographic, unit

    [[nodiscard]] static glm::dvec3 normal(double u, double v) {
        return std::cos(v) * glm::dvec3{std::cos(u), 0.0, std::sin(u)} + glm::dvec3{0.0, std::sin(v), 0.0};
    }
    [[nodiscard]] static glm::dvec3 position(double u, double v) {
        return ring * glm::dvec3{std::cos(u), 0.0, std::sin(u)} + tube * normal(u, v);
    }
    [[nodiscard]] double cosine(double u, double v) const { return glm::dot(normal(u, v), toEye); }
    [[nodiscard]] double radial(double u, double v) const {
        const double around = glm::dot(glm::dvec3{-std::sin(u), 0.0, std::cos(u)}, toEye);
        const glm::dvec3 across =
            -std::sin(v) * glm::dvec3{std::cos(u), 0.0, std::sin(u)} + glm::dvec3{0.0, std::cos(v), 0.0};
        const double along = glm::dot(across, toEye);
        const double kRing = std::cos(v) / (ring + tube * std::cos(v));
        return (kRing * around * around + along * along / tube) / (around * around + along * along);
    }
};

TEST(FormLines, ofATorusAreSuggestiveWhereItsRadialCurvatureIsZero) {
    const Mesh mesh = views::torus(TorusAt::ring, TorusAt::tube, 192, 96);
    const Camera camera = views::orthographic({0.0, 3.0, 5.0}, 4.0);
    const TorusAt torus{glm::normalize(glm::dvec3{0.0, 3.0, 5.0})};
    Settings settings = drawingAll(LineType::Suggestive);
    settings.lines.hidden = HiddenLines::Solid;
    const std::vector<Line> lines = found(mesh, camera, settings);
    ASSERT_THAT(lines, Not(IsEmpty()));
    // What is linear in faces is off by the square of an edge's length times a second derivative, which is of the size
    // of 1 / tube^3.
    const double edge = longestEdge(mesh);
    const double off = edge * edge / std::pow(TorusAt::tube, 3.0);
    forEachPoint(lines, [&](glm::dvec3 p) {
        const double u = std::atan2(p.z, p.x);
        const double v = std::atan2(p.y, std::hypot(p.x, p.z) - TorusAt::ring);
        EXPECT_NEAR(torus.radial(u, v), 0.0, off) << u << ' ' << v;
    });
    // And each of the curve's points has one near it: sign changes across the tube, from above to below towards the
    // eye, where the surface is seen at an angle that such contours are drawn at.
    constexpr int steps = 720;
    int count = 0;
    for (int i = 0; i < steps; ++i) {
        for (int j = 0; j < steps; ++j) {
            const double u = 2.0 * std::numbers::pi * i / steps;
            const double v = 2.0 * std::numbers::pi * j / steps;
            const double next = v + 2.0 * std::numbers::pi / steps;
            if ((torus.radial(u, v) > 0.0) == (torus.radial(u, next) > 0.0)) continue;
            const double cosine = torus.cosine(u, v);
            // Towards the eye: along w, the projection of the way to the eye.
            const glm::dvec3 p = TorusAt::position(u, v);
            const glm::dvec3 w = torus.toEye - cosine * TorusAt::normal(u, v);
            const glm::dvec3 ahead = p + 1e-3 * glm::normalize(w);
            const double growth = torus.radial(std::atan2(ahead.z, ahead.x),
                                               std::atan2(ahead.y, std::hypot(ahead.x, ahead.z) - TorusAt::ring)) -
                                  torus.radial(u, v);
            if (cosine < 0.05 || cosine > 0.8 || growth < 1e-3 * 0.2) continue;
            ++count;
            EXPECT_LT(distanceTo(lines, p), 2.0 * edge) << u << ' ' << v;
        }
    }
    EXPECT_GT(count, 50);
}

// Three planes of symmetry. Across the one in which the two longer axes lie the greater curvature is the greatest; of
// the others one is where it is the smallest, and across the third runs the smaller curvature. All bulges: no valleys,
// and no contours that are nearly there.
TEST(FormLines, ofAnEllipsoidAreARidgeAroundItsTwoLongerAxes) {
    const glm::dvec3 axes{1.5, 1.0, 0.7};
    const Mesh mesh = curved::ellipsoid(axes, 48);
    const double edge = longestEdge(mesh);
    for (const Camera& camera : cameras) {
        Settings settings = drawing(LineType::Ridge);
        settings.lines.form.ridgeThreshold = 0.02;
        settings.lines.hidden = HiddenLines::Solid;
        const std::vector<Line> ridges = found(mesh, camera, settings);
        // The derivative is 0 there, and known to within a share of its change over an edge.
        forEachPoint(ridges, [&](glm::dvec3 p) { EXPECT_NEAR(p.z, 0.0, edge); });
        for (int i = 0; i < 360; ++i) {
            const double angle = 2.0 * std::numbers::pi * i / 360;
            EXPECT_LT(distanceTo(ridges, {axes.x * std::cos(angle), axes.y * std::sin(angle), 0.0}), 2.0 * edge) << i;
        }
        EXPECT_THAT(found(mesh, camera, drawing(LineType::Valley | LineType::Suggestive)), IsEmpty());
    }
}

// Seen along its longest axis a, over the shortest one c the curvature that is seen has a maximum in the middle if
// a^2 > 1.5 c^2: there 1 / cos of the angle to the view grows slower than the curvature falls.
TEST(FormLines, ofAnEllipsoidSeenAlongAnAxisAreAnApparentRidge) {
    const Camera camera = views::orthographic({5.0, 0.0, 0.0}, 3.0);
    const Mesh sharp = curved::ellipsoid({1.5, 1.0, 0.7}, 48);
    Settings settings = drawing(LineType::Apparent);
    settings.lines.form.apparentThreshold = 0.02;
    const std::vector<Line> lines = found(sharp, camera, settings);
    EXPECT_LT(distanceTo(lines, {1.5, 0.0, 0.0}), 2.0 * longestEdge(sharp));
    // Towards the contour the derivative's error grows with the square of 1 / cosine: this is the half before it.
    forEachPoint(lines, [&](glm::dvec3 p) {
        if (p.x > 1.2) {
            EXPECT_NEAR(p.z, 0.0, longestEdge(sharp));
        }
    });
    EXPECT_THAT(found(curved::ellipsoid({1.0, 0.95, 0.9}, 48), camera, drawing(LineType::Apparent)), IsEmpty());
}

// A fold along y: z = height exp(-x^2 / width), which bulges at x = 0, and is hollow the most where its curvature is
// the smallest, to both sides.
struct Fold {
    static constexpr double height = 0.15;
    static constexpr double width = 0.08;
    [[nodiscard]] static double at(double x) { return height * std::exp(-x * x / width); }
    [[nodiscard]] static double curvature(double x) {
        const double slope = -2.0 * x / width * at(x);
        const double bend = (4.0 * x * x / (width * width) - 2.0 / width) * at(x);
        return -bend / std::pow(1.0 + slope * slope, 1.5);
    }
    [[nodiscard]] static double hollow() {
        double best = 0.0;
        for (double x = 0.0; x < 1.0; x += 1e-4)
            if (curvature(x) < curvature(best)) best = x;
        return best;
    }
};

TEST(FormLines, ofAFoldAreARidgeAndAValleyToEachSide) {
    const Mesh mesh = curved::sheet(80, [](double x, double) { return Fold::at(x); });
    const Camera camera = views::orthographic({0.0, -1.0, 5.0}, 3.0);
    const double edge = longestEdge(mesh);
    const std::vector<Line> ridges = found(mesh, camera, drawingGentle(LineType::Ridge));
    forEachPoint(ridges, [&](glm::dvec3 p) { EXPECT_NEAR(p.x, 0.0, edge); });
    for (double y = -0.9; y < 0.95; y += 0.1) EXPECT_LT(distanceTo(ridges, {0.0, y, Fold::at(0.0)}), edge) << y;
    const std::vector<Line> valleys = found(mesh, camera, drawingGentle(LineType::Valley));
    const double hollow = Fold::hollow();
    forEachPoint(valleys, [&](glm::dvec3 p) { EXPECT_NEAR(std::abs(p.x), hollow, edge); });
    for (double y = -0.9; y < 0.95; y += 0.1) {
        EXPECT_LT(distanceTo(valleys, {hollow, y, Fold::at(hollow)}), edge + 0.02) << y;
        EXPECT_LT(distanceTo(valleys, {-hollow, y, Fold::at(hollow)}), edge + 0.02) << y;
    }
}

double dent(double x, double y) { return -0.3 * std::exp(-(x * x + y * y) / 0.1); }

// From high above no part of the dent is hidden: no contour. A suggestive one runs along its near edge all the same,
// where the radial curvature is 0.
TEST(FormLines, ofADentAreSuggestiveWhereItsContourWillBe) {
    const Mesh mesh = curved::sheet(100, dent);
    const glm::dvec3 eye{0.0, -4.0, 4.0};
    const Camera camera = views::orthographic(eye, 3.0);
    const std::vector<Line> contours = found(mesh, camera, drawing(LineType::Occlusion));
    EXPECT_THAT(contours, IsEmpty());
    Settings settings = drawing(LineType::Suggestive);
    settings.lines.form.suggestiveThreshold = 0.03;
    const std::vector<Line> lines = found(mesh, camera, settings);
    ASSERT_THAT(lines, Not(IsEmpty()));
    // Half of the near edge, which is a half circle about as wide as the dent.
    EXPECT_GT(views::length(lines), 0.5 * std::numbers::pi * 0.22 * 400.0 / 3.0);
    const double edge = longestEdge(mesh);
    forEachPoint(lines, [&](glm::dvec3 p) {
        const double z = dent(p.x, p.y);
        const glm::dvec3 gradient{20.0 * p.x * z, 20.0 * p.y * z, 1.0};  // of z - dent(x, y)
        glm::dmat3 hessian{0.0};
        hessian[0][0] = (20.0 - 400.0 * p.x * p.x) * z;
        hessian[1][1] = (20.0 - 400.0 * p.y * p.y) * z;
        hessian[0][1] = hessian[1][0] = -400.0 * p.x * p.y * z;
        const glm::dmat3 tensor = curved::tensorOf(gradient, hessian);
        const glm::dvec3 n = glm::normalize(gradient);
        const glm::dvec3 v = glm::normalize(eye);
        const glm::dvec3 w = glm::normalize(v - glm::dot(v, n) * n);
        // The feature size, over which it is smoothed, is under an edge's length; over that the curvature changes by
        // up to a share of the largest curvature, 6.
        EXPECT_NEAR(glm::dot(w, tensor * w), 0.0, 6.0 * edge / 0.22);
    });
    forEachPoint(lines, [](glm::dvec3 p) { EXPECT_LT(p.z, -0.003) << "beyond a hundredth of its depth"; });
}

TEST(FormLines, areTheSameAtEveryScale) {
    Mesh mesh = curved::sheet(80, dent);
    const auto lengthAt = [&](double scale, LineType type) {
        Mesh scaled = mesh;
        for (glm::vec3& p : scaled.positions) p *= static_cast<float>(scale);
        Camera camera = views::orthographic(scale * glm::dvec3{0.0, -4.0, 4.0}, 3.0 * scale);
        camera.near *= scale;
        camera.far *= scale;
        return views::length(found(scaled, camera, drawingGentle(type)));
    };
    for (const LineType type : formLineTypes) {
        const double length = lengthAt(1.0, type);
        EXPECT_GT(length, 0.0) << name(type);
        // Powers of two, for where the sheet is all but flat the rounding of positions decides how far weak lines go.
        for (const double scale : {0x1p-10, 0x1p10})
            EXPECT_NEAR(lengthAt(scale, type), length, 1e-3 * length) << name(type) << ' ' << scale;
    }
}

TEST(FormLines, leaveOtherLinesAsTheyAre) {
    const Mesh mesh = curved::sheet(40, dent);
    const Camera camera = views::orthographic({0.0, -4.0, 1.5}, 3.0);
    const std::vector<Line> without = found(mesh, camera, drawing(standardLineTypes));
    const std::vector<Line> with = views::thoseOf(found(mesh, camera, drawing(allLineTypes)), [](const Line& line) {
        return standardLineTypes.contains(line.type);
    });
    ASSERT_EQ(with.size(), without.size());
    for (std::size_t i = 0; i < with.size(); ++i) {
        EXPECT_EQ(with[i].type, without[i].type);
        ASSERT_EQ(with[i].points.size(), without[i].points.size());
        EXPECT_EQ(with[i].points.front().pixel, without[i].points.front().pixel);
    }
}

TEST(FormLines, areStrongerWhereASurfaceBendsMore) {
    const Mesh mesh = curved::sheet(80, [](double x, double y) { return (0.6 + 0.4 * y) * Fold::at(x); });
    Settings settings = drawing(LineType::Ridge);
    settings.lines.form.ridgeThreshold = 0.03;
    double strongest[2]{};
    for (const Line& line : found(mesh, views::orthographic({0.0, -1.0, 5.0}, 3.0), settings)) {
        for (const LinePoint& p : line.points) {
            EXPECT_GE(p.strength, 0.0);
            EXPECT_LE(p.strength, 1.0);
            double& at = strongest[p.position.y > 0.0 ? 1 : 0];
            at = std::max(at, p.strength);
        }
    }
    EXPECT_GT(strongest[1], strongest[0]);
    EXPECT_GT(strongest[0], 0.0);
}

TEST(FormLines, ofASheetSeenFromBehindAreThoseOfTheSheetTurnedOver) {
    const Mesh mesh = curved::sheet(80, [](double x, double) { return Fold::at(x); });
    const auto lengthOf = [&](double z, LineType type) {
        return views::length(found(mesh, views::orthographic({0.0, -1.0, z}, 3.0), drawingGentle(type)));
    };
    EXPECT_GT(lengthOf(5.0, LineType::Ridge), 200.0);
    EXPECT_NEAR(lengthOf(-5.0, LineType::Valley), lengthOf(5.0, LineType::Ridge), 5.0);
    EXPECT_NEAR(lengthOf(-5.0, LineType::Ridge), lengthOf(5.0, LineType::Valley), 5.0);
}

}  // namespace
}  // namespace inkedge::lines
