#include "lines/object_lines.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numbers>
#include <set>

#include <gmock/gmock.h>
#include <glm/trigonometric.hpp>

#include "lines/views.h"

namespace inkedge::lines {
namespace {

using namespace scenes;
using namespace views;
using testing::Each;
using testing::SizeIs;

// How many pieces of a line each edge between two corners of box() is, seen and hidden; nothing else may be drawn.
struct EdgeCounts {
    std::map<std::pair<int, int>, LineType> seen;
    std::map<std::pair<int, int>, LineType> hidden;
};

EdgeCounts edgesOfBox(const std::vector<Line>& lines, glm::dvec3 sides, const Camera& camera, Size size) {
    constexpr double exact = 1e-9;  // pixels and units: doubles all the way, box corners are floats without rounding
    EdgeCounts counts;
    const auto cornerOf = [&](const LinePoint& p) {
        int corner = 0;
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_NEAR(std::abs(p.position[axis]), 0.5 * sides[axis], exact);
            corner |= p.position[axis] > 0.0 ? 1 << axis : 0;
        }
        EXPECT_LT(glm::distance(p.pixel, pixel(camera, size, p.position)), exact);
        return corner;
    };
    for (const Line& line : lines) {
        forEachPiece(line, [&](const LinePoint& p, const LinePoint& q) {
            const auto [low, high] = std::minmax({cornerOf(p), cornerOf(q)});
            const int difference = low ^ high;
            EXPECT_TRUE(difference == 1 || difference == 2 || difference == 4) << low << " to " << high;
            auto& those = line.visible ? counts.seen : counts.hidden;
            EXPECT_TRUE(those.emplace(std::pair{low, high}, line.type).second)
                << "drawn twice: " << low << " to " << high;
        });
    }
    return counts;
}

long countOf(const std::map<std::pair<int, int>, LineType>& edges, LineType type) {
    return std::ranges::count(edges, type, [](const auto& edge) { return edge.second; });
}

TEST(ObjectLines, OfACubeAreItsNineSeenEdgesFromCornerToCorner) {
    const Scene scene = sceneOf(cube(2.0));
    for (const Camera& camera : {perspective({5, 4, 7}), orthographic({5, 4, 7}, 5.0), perspective({-2, -3, 2.5})}) {
        for (const HiddenLines hidden : {HiddenLines::None, HiddenLines::Dashed}) {
            const LineOptions options{.hidden = hidden};
            const auto edges = edgesOfBox(linesOf(scene, camera, options), glm::dvec3{2.0}, camera, options.size);
            EXPECT_EQ(countOf(edges.seen, LineType::Outline), 6);
            EXPECT_EQ(countOf(edges.seen, LineType::Crease), 3);
            EXPECT_EQ(edges.seen.size(), 9U);
            EXPECT_EQ(edges.hidden.size(), hidden == HiddenLines::None ? 0U : 3U);
            EXPECT_EQ(countOf(edges.hidden, LineType::Crease), static_cast<long>(edges.hidden.size()));
        }
    }
}

TEST(ObjectLines, OfACubeSeenFaceOnAreOneSquare) {
    const Scene scene = sceneOf(cube(2.0));
    for (const Camera& camera : {perspective({0, 0, 7}), orthographic({0, 0, 7}, 5.0)}) {
        const auto lines = linesOf(scene, camera);
        ASSERT_THAT(lines, SizeIs(1));
        EXPECT_TRUE(lines[0].closed);
        EXPECT_EQ(lines[0].type, LineType::Outline);
        EXPECT_THAT(lines[0].points, SizeIs(4));
        const double side =
            camera.orthographic() ? 2.0 * 300.0 / 5.0 : 2.0 * 150.0 / std::tan(glm::radians(17.5)) / 6.0;
        EXPECT_NEAR(length(lines), 4.0 * side, 1e-9);
    }
}

TEST(ObjectLines, HaveNoneAlongTrianglesThatRoundingFoldsOver) {
    Mesh sheet;  // the second triangle's third corner lies past its first side
    for (const glm::dvec3 p : {glm::dvec3{0, 0, 0}, {1, 0, 0}, {0.5, -1e-4, 0}, {0.5, -0.5, 0}, {0.5, 0.5, 0}})
        sheet.positions.emplace_back(p);
    sheet.indices = {0, 3, 1, 0, 1, 2, 0, 2, 4, 2, 1, 4};
    for (const glm::dvec3 eye : {glm::dvec3{0, 0, 5}, {1, 2, 4}, {0.5, -3, -2}}) {
        double around = 0.0;
        for (const Line& line : linesOf(sceneOf(sheet), orthographic(eye, 5.0))) {
            forEachPiece(line, [&](const LinePoint& p, const LinePoint& q) {
                EXPECT_FALSE(std::abs(p.position.y) < 0.01 && std::abs(q.position.y) < 0.01) << "along the fold";
                around += glm::distance(p.position, q.position);
            });
        }
        EXPECT_NEAR(around, 4.0 * std::sqrt(0.5), 1e-3);
    }
}

TEST(ObjectLines, OfACubeKnowWhatTheyLieOn) {
    const Scene scene = sceneOf({{cube(1.0), glm::dmat4{1.0}}, {cube(1.0), translation({3, 0, 0})}});
    const auto lines = linesOf(scene, perspective({6, 4, 7}, {1.5, 0, 0}));
    std::set<std::uint32_t> objects;
    for (const Line& line : lines) {
        objects.insert(line.object);
        for (const LinePoint& p : line.points) EXPECT_EQ(line.object, p.position.x < 1.5 ? 1U : 2U);
    }
    EXPECT_EQ(objects, (std::set<std::uint32_t>{1, 2}));
}

// Distances of all points from the picture's middle.
std::pair<double, double> radii(const Line& line, Size size) {
    std::pair range{std::numeric_limits<double>::max(), 0.0};
    for (const LinePoint& p : line.points) {
        const double r = glm::distance(p.pixel, glm::dvec2{0.5 * size.width, 0.5 * size.height});
        range = {std::min(range.first, r), std::max(range.second, r)};
    }
    return range;
}

TEST(ObjectLines, OfASphereAreTheCircleWhereItTurnsAway) {
    // The cone around a unit sphere from d away opens by asin(1 / d): a circle of radius f / sqrt(d^2 - 1).
    const LineOptions options{.size = {600, 600}};
    const double d = 5.0;
    const double f = 300.0 / std::tan(glm::radians(17.5));
    double before = 0.0;
    for (const std::uint32_t segments : {24U, 48U, 96U}) {
        const Scene scene = sceneOf(sphere(1.0, segments));
        for (const bool parallel : {false, true}) {
            const Camera camera = parallel ? orthographic(d * glm::normalize(glm::dvec3{1, 2, 3}), 4.0)
                                           : perspective(d * glm::normalize(glm::dvec3{1, 2, 3}));
            const double expected = parallel ? 150.0 : f / std::sqrt(d * d - 1.0);
            const double facet = 2.0 * std::numbers::pi / segments;  // angle that an edge covers
            for (const Contour contour : bothContours) {
                LineOptions own = options;
                own.contour = contour;
                const auto lines = linesOf(scene, camera, own);
                ASSERT_THAT(lines, SizeIs(1)) << segments;
                EXPECT_TRUE(lines[0].closed);
                EXPECT_EQ(lines[0].type, LineType::Outline);
                const auto [smallest, largest] = radii(lines[0], options.size);
                // The mesh's corners lie on the sphere, so inside the circle, by less than a facet's diagonal falls
                // short of its tangent. Points between corners lie under the sphere by a quarter of that at most.
                EXPECT_LE(largest, expected * (1.0 + 1e-6));  // corners are floats
                EXPECT_GE(smallest, expected * (1.0 - facet * facet)) << segments;
                if (contour != Contour::Smooth || parallel) continue;
                const double error = expected - smallest;
                if (before > 0.0) {
                    EXPECT_NEAR(before / error, 4.0, 1.0) << "falls as the edge squared, to " << segments;
                }
                before = error;
            }
        }
    }
}

TEST(ObjectLines, OfASphereByItsEdgesRunAlongItsEdges) {
    const Mesh mesh = sphere(1.0, 24);
    std::set<std::array<float, 3>> corners;
    for (const glm::vec3& p : mesh.positions) corners.insert({p.x + 0.0F, p.y + 0.0F, p.z + 0.0F});
    const Scene scene = sceneOf(mesh);
    const auto lines = linesOf(scene, perspective({3, 2, 4}), {.contour = Contour::Mesh});
    ASSERT_THAT(lines, SizeIs(1));
    const double longest = 2.0 * std::sin(std::numbers::pi / 24.0) * std::sqrt(2.0);
    forEachPiece(lines[0], [&](const LinePoint& p, const LinePoint& q) {
        EXPECT_LT(glm::distance(p.position, q.position), longest + 1e-6);
        double nearest = 1.0;
        for (const glm::vec3& corner : mesh.positions)
            nearest = std::min(nearest, glm::distance(glm::dvec3{corner}, p.position));
        EXPECT_LT(nearest, 1e-6);
    });
}

// The torus's contour in parallel views along (-cos e, -sin e, 0): n . d = 0 at tan v = -cos u cos e / sin e.
struct TorusContour {
    double ring = 2.0;
    double tube = 0.8;
    double elevation;

    [[nodiscard]] double v(double u, bool outer) const {
        const double one = std::atan(-std::cos(u) * std::cos(elevation) / std::sin(elevation));
        return outer ? one : one + std::numbers::pi;
    }
    [[nodiscard]] glm::dvec3 normal(double u, bool outer) const {
        const double w = v(u, outer);
        return {std::cos(w) * std::cos(u), std::sin(w), std::cos(w) * std::sin(u)};
    }
    [[nodiscard]] glm::dvec3 point(double u, bool outer) const {
        return ring * glm::dvec3{std::cos(u), 0, std::sin(u)} + tube * normal(u, outer);
    }
    // Along the contour, across the view in the picture: zero at cusps.
    [[nodiscard]] double across(double u, bool outer) const {
        const glm::dvec3 step = point(u + 1e-5, outer) - point(u - 1e-5, outer);
        return glm::dot(step, glm::cross(normal(u, outer), glm::dvec3{std::cos(elevation), std::sin(elevation), 0})) /
               2e-5;
    }
    [[nodiscard]] std::vector<glm::dvec3> cusps() const {
        std::vector<glm::dvec3> found;
        for (const bool outer : {false, true}) {
            constexpr int steps = 1000;
            for (int i = 0; i < steps; ++i) {
                double low = 2.0 * std::numbers::pi * (i + 0.5) / steps;
                double high = 2.0 * std::numbers::pi * (i + 1.5) / steps;
                if ((across(low, outer) > 0.0) == (across(high, outer) > 0.0)) continue;
                for (int k = 0; k < 50; ++k) {
                    const double middle = 0.5 * (low + high);
                    ((across(middle, outer) > 0.0) == (across(low, outer) > 0.0) ? low : high) = middle;
                }
                found.push_back(point(low, outer));
            }
        }
        return found;
    }
};

TEST(ObjectLines, OfATorusEndAtItsCusps) {
    const TorusContour contour{.elevation = glm::radians(30.0)};
    const auto cusps = contour.cusps();
    ASSERT_THAT(cusps, SizeIs(4));
    const Camera camera =
        orthographic(10.0 * glm::dvec3{std::cos(contour.elevation), std::sin(contour.elevation), 0}, 6.5);
    const Scene scene = sceneOf(torus(contour.ring, contour.tube, 360, 180));
    const LineOptions options{.size = {600, 600}, .contour = Contour::Smooth};
    const auto lines = linesOf(scene, camera, options);
    const auto outline = thoseOf(lines, [](const Line& line) { return line.closed; });
    ASSERT_THAT(outline, SizeIs(1));
    EXPECT_EQ(outline[0].type, LineType::Outline);
    // Of the hole: its near rim, from cusp to cusp, and the far one, from where it comes up behind that: by symmetry at
    // half the picture's height. Each is an outline where the background is seen through the hole, else an occlusion.
    std::vector<glm::dvec2> expected;
    for (const glm::dvec3& cusp : cusps)
        if (const glm::dvec2 at = pixel(camera, options.size, cusp); at.y < 300.0) expected.push_back(at);
    for (double u = 0.0; u < 4.0 * std::numbers::pi; u += 1e-3) {
        const bool outer = u < 2.0 * std::numbers::pi;
        const glm::dvec2 p = pixel(camera, options.size, contour.point(u, outer));
        const glm::dvec2 q = pixel(camera, options.size, contour.point(u + 1e-3, outer));
        const glm::dvec2 middle = 0.5 * (p + q);
        if ((p.y < 300.0) != (q.y < 300.0) && std::abs(middle.x - 300.0) < 100.0) expected.push_back(middle);
    }
    ASSERT_GE(expected.size(), 4U);  // two curves pass through each of the last two
    std::vector<glm::dvec2> ends;
    for (const Line& line : lines)
        if (!line.closed) ends.insert(ends.end(), {line.points.front().pixel, line.points.back().pixel});
    EXPECT_LE(ends.size(), 12U);
    for (const glm::dvec2& cusp : expected) {
        const auto apart = [&](glm::dvec2 end) { return glm::distance(end, cusp); };
        EXPECT_LT(apart(*std::ranges::min_element(ends, {}, apart)), 1.0) << cusp.x << ", " << cusp.y;
    }
}

// Where the picture of p..q crosses that of r..s, as a share of p..q's; none: -1.
double crossing(glm::dvec2 p, glm::dvec2 q, glm::dvec2 r, glm::dvec2 s) {
    const auto cross = [](glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; };
    const double area = cross(q - p, s - r);
    const double u = cross(r - p, s - r) / area;
    const double v = cross(r - p, q - p) / area;
    return u > 0.0 && u < 1.0 && v >= 0.0 && v <= 1.0 ? u : -1.0;
}

TEST(ObjectLines, EndExactlyWhereABoxStandsBefore) {
    const Scene scene = sceneOf({{box({8, 1, 1}), translation({0, 0, -3})}, {box({1, 4, 1}), glm::dmat4{1.0}}});
    const Camera camera = perspective({1.5, 2, 9});
    const LineOptions options{};
    const auto at = [&](glm::dvec3 p) { return pixel(camera, options.size, p); };
    const auto bars = thoseOf(linesOf(scene, camera, options), [](const Line& line) { return line.object == 1; });
    int ends = 0;
    for (const glm::dvec2 edge : {glm::dvec2{0.5, -2.5}, {-0.5, -2.5}, {0.5, -3.5}}) {  // y, z of the bar's seen edges
        const glm::dvec2 p = at({-4, edge.x, edge.y});
        const glm::dvec2 q = at({4, edge.x, edge.y});
        std::vector<double> shares;
        for (const glm::dvec2 upright : {glm::dvec2{-0.5, 0.5}, {0.5, 0.5}, {0.5, -0.5}, {-0.5, -0.5}}) {
            const double u = crossing(p, q, at({upright.x, -2, upright.y}), at({upright.x, 2, upright.y}));
            if (u > 0.0) shares.push_back(u);
        }
        ASSERT_THAT(shares, SizeIs(4));
        for (const double share : {std::ranges::min(shares), std::ranges::max(shares)}) {
            for (const Line& line : bars)
                for (const LinePoint& end : {line.points.front(), line.points.back()})
                    ends += glm::distance(end.pixel, p + share * (q - p)) < 1e-6 ? 1 : 0;
        }
    }
    EXPECT_EQ(ends, 6);
    for (const Line& line : bars) EXPECT_EQ(line.closed, false);
}

TEST(ObjectLines, OfABoxThroughASphereAreAnArcOfTheirCircle) {
    // The top, y = 1/2, cuts the unit sphere in a circle of radius sqrt(3) / 2. A point p of a unit sphere faces an eye
    // E if p . E > 1: here where cos(a) > (1 - y_E / 2) / (r z_E).
    const Scene scene = sceneOf({{sphere(1.0, 128), glm::dmat4{1.0}}, {box({6, 1, 6}), glm::dmat4{1.0}}});
    const glm::dvec3 eye{0, 3, 6};
    const Camera camera = perspective(eye, {0, 0, 0}, 50.0);
    const double r = std::sqrt(0.75);
    const double half = std::acos((1.0 - 0.5 * eye.y) / (r * eye.z));
    const auto lines = linesOf(scene, camera, {.hidden = HiddenLines::Solid});
    double seen = 0.0;
    double hidden = 0.0;
    for (const Line& line : thoseOf(lines, LineType::Intersection)) {
        forEachPiece(line, [&](const LinePoint& p, const LinePoint& q) {
            EXPECT_NEAR(std::abs(p.position.y), 0.5, 1e-6);
            EXPECT_NEAR(std::hypot(p.position.x, p.position.z), r, 7e-4);  // 1 - cos(pi / 128), steeper by 1 / r; twice
            if (p.position.y > 0.0) (line.visible ? seen : hidden) += glm::distance(p.position, q.position);
            if (p.position.y < 0.0) {
                EXPECT_FALSE(line.visible) << "below the box";
            }
        });
    }
    // The sphere's facets turn away up to half of one, 1.4 degrees, off.
    EXPECT_NEAR(seen, 2.0 * half * r, 2.0 * r * std::numbers::pi / 128.0);
    EXPECT_NEAR(seen + hidden, 2.0 * std::numbers::pi * r, 2.0 * std::numbers::pi * 7e-4);
}

TEST(ObjectLines, OfSmoothContoursEndWhereTheyRunIntoAnotherPart) {
    // Coarse: a smooth contour may lie behind its own faces by as much as one is long, but not within another sphere.
    const glm::dvec3 apart{1.1, 0.2, 0.1};
    const Scene scene = sceneOf({{sphere(1.0, 16), glm::dmat4{1.0}}, {sphere(0.8, 16), translation(apart)}});
    for (const Camera& camera : {perspective({0.3, 0.4, 7}), orthographic({-1, 2, 6}, 4.0)}) {
        const auto lines = thoseOf(linesOf(scene, camera, {.contour = Contour::Smooth}),
                                   [](const Line& line) { return line.type != LineType::Intersection; });
        EXPECT_GT(length(lines), 300.0);
        for (const Line& line : lines) {
            const glm::dvec3 centre = line.object == 1 ? apart : glm::dvec3{0.0};
            const double inscribed = (line.object == 1 ? 0.8 : 1.0) * std::cos(std::numbers::pi / 16.0);
            forEachPiece(line, [&](const LinePoint& p, const LinePoint& q) {
                for (const double s : {0.0, 0.5, 1.0})  // in pieces of facets' sizes
                    EXPECT_GT(glm::distance(glm::mix(p.position, q.position, s), centre), inscribed * inscribed)
                        << "of " << line.object;
            });
        }
    }
}

TEST(ObjectLines, OfAnOpenSheetAreOutlinesBeforeNothingAndBoundariesBeforeSomething) {
    const Camera camera = perspective({4, 10, 6});
    const auto alone = linesOf(sceneOf(sheet(2.0, 3)), camera);
    ASSERT_THAT(alone, SizeIs(1));
    EXPECT_EQ(alone[0].type, LineType::Outline);
    EXPECT_TRUE(alone[0].closed);
    const auto both =
        linesOf(sceneOf({{sheet(2.0, 3), glm::dmat4{1.0}}, {sheet(6.0, 2), translation({0, -1, 0})}}), camera);
    ASSERT_THAT(both, SizeIs(2));
    for (const Line& line : both) {
        EXPECT_TRUE(line.closed);
        EXPECT_EQ(line.type, line.object == 1 ? LineType::Boundary : LineType::Outline);
    }
    // Half over it: hidden where the large one is nearer, an outline beyond it.
    const auto across =
        linesOf(sceneOf({{sheet(2.0, 3), glm::dmat4{1.0}}, {sheet(6.0, 2), translation({3, -1, 0})}}), camera);
    EXPECT_THAT(thoseOf(across, [](const Line& line) { return line.object == 1 && line.type == LineType::Outline; }),
                SizeIs(1));
    EXPECT_THAT(thoseOf(across, [](const Line& line) { return line.object == 1 && line.type == LineType::Boundary; }),
                SizeIs(1));
}

// Pixels around a polygon.
double perimeter(const Camera& camera, Size size, const std::vector<glm::dvec3>& corners) {
    double sum = 0.0;
    for (std::size_t i = 0; i < corners.size(); ++i)
        sum += glm::distance(pixel(camera, size, corners[i]), pixel(camera, size, corners[(i + 1) % corners.size()]));
    return sum;
}

TEST(ObjectLines, AreNoneAtSeams) {
    const Camera camera = perspective({1, 5, 3});
    const LineOptions options{};
    const double expected = perimeter(camera, options.size, {{-2, 0, -1}, {-2, 0, 1}, {2, 0, 1}, {2, 0, -1}});
    const Mesh left = quad({-2, 0, -1}, {-2, 0, 1}, {0, 0, 1}, {0, 0, -1});
    const Mesh right = quad({0, 0, -1}, {0, 0, 1}, {2, 0, 1}, {2, 0, -1});
    const Mesh rightNear = quad({0, 0, -1}, {0, 0, 0.3}, {2, 0, 0.3}, {2, 0, -1});
    const Mesh rightFar = quad({0, 0, 0.3}, {0, 0, 1}, {2, 0, 1}, {2, 0, 0.3});
    const glm::dmat4 there{1.0};
    Mesh one = left;  // with a corner on an edge's middle
    for (const Mesh& part : {rightNear, rightFar}) {
        for (const std::uint32_t i : part.indices)
            one.indices.push_back(static_cast<std::uint32_t>(one.positions.size()) + i);
        one.positions.insert(one.positions.end(), part.positions.begin(), part.positions.end());
    }
    const std::map<const char*, Scene> scenes{
        {"two meshes", sceneOf({{left, there}, {right, there}})},
        {"three meshes that meet in a T", sceneOf({{left, there}, {rightNear, there}, {rightFar, there}})},
        {"one mesh with a T", sceneOf(one)}};
    for (const auto& [name, scene] : scenes) {
        const auto lines = linesOf(scene, camera, options);
        EXPECT_NEAR(length(lines), expected, 0.1) << name;
        for (const Line& line : lines) EXPECT_EQ(line.type, LineType::Outline) << name;
    }
}

TEST(ObjectLines, OfABoxOnATableAreItsEdgesWithoutSpray) {
    const LineOptions options{};
    for (const std::uint32_t cells : {1U, 5U}) {
        for (const double off : {0.0, 3e-7, -3e-7}) {  // of a rounding
            const Scene scene =
                sceneOf({{sheet(8.0, cells), glm::dmat4{1.0}},
                         {box({1, 1, 1}), translation({0.1, 0.5 + off, 0.2}) * rotation(20, {0, 1, 0})}});
            for (const Camera& camera : {perspective({5, 4, 9}), orthographic({-5, 2, 4}, 10.0)}) {
                const auto lines = linesOf(scene, camera, options);
                const auto onBox = thoseOf(lines, [](const Line& line) { return line.object == 2; });
                double edges = 0.0;  // the box's: all with the nearest three faces
                const glm::dmat4 transform = scene.instances()[1].transform;
                const glm::dvec3 back{glm::inverse(transform) * (glm::inverse(camera.view) * glm::dvec4{0, 0, 0, 1})};
                for (int i = 0; i < 8; ++i) {
                    for (const int axis : {0, 1, 2}) {
                        if ((i >> axis & 1) != 0) continue;
                        int hiddenSides = 0;  // of the two faces at the edge
                        glm::dvec3 p{0.0};
                        for (const int other : {0, 1, 2}) p[other] = (i >> other & 1) != 0 ? 0.5 : -0.5;
                        for (const int other : {0, 1, 2})
                            if (other != axis && (p[other] > 0.0) != (back[other] > 0.0)) ++hiddenSides;
                        if (hiddenSides == 2) continue;
                        glm::dvec3 q = p;
                        q[axis] = 0.5;
                        edges += glm::distance(pixel(camera, options.size, transform * glm::dvec4{p, 1}),
                                               pixel(camera, options.size, transform * glm::dvec4{q, 1}));
                    }
                }
                EXPECT_NEAR(length(onBox), edges, 1.0) << cells << " cells, off by " << off;
                EXPECT_LE(onBox.size(), 9U);
                const auto onTable = thoseOf(lines, [](const Line& line) { return line.object == 1; });
                EXPECT_THAT(onTable, SizeIs(1)) << cells << " cells, off by " << off;
            }
        }
    }
}

}  // namespace
}  // namespace inkedge::lines
