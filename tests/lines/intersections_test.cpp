#include "lines/find/intersections.h"
#include "lines/views.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <set>

#include <gmock/gmock.h>

#include "scene/prepared.h"
#include "scenes.h"

namespace inkedge::lines {
namespace {

using namespace scenes;
using testing::IsEmpty;

std::vector<IntersectionSegment> intersectionsOf(const Scene& scene) {
    std::vector<MeshEdges> edges;
    for (std::size_t i = 0; i < scene.meshes().size(); ++i)
        edges.push_back(findEdges(scene.meshes()[i], scene::topologyOf(scene, i), scene.creaseAngle()));
    return findIntersections(scene, edges);
}

double totalLength(const std::vector<IntersectionSegment>& segments) {
    double sum = 0.0;
    for (const IntersectionSegment& s : segments) sum += glm::distance(s.ends[0], s.ends[1]);
    return sum;
}

std::map<std::uint32_t, int> endsAtNodes(const std::vector<IntersectionSegment>& segments) {
    std::map<std::uint32_t, int> ends;
    for (const IntersectionSegment& s : segments)
        for (const std::uint32_t node : s.nodes) ++ends[node];
    return ends;
}

Mesh joined(const Mesh& a, const Mesh& b, const glm::dmat4& transformOfB) {
    Mesh mesh = a;
    mesh.normals.clear();
    for (const glm::vec3& p : b.positions) mesh.positions.emplace_back(transformOfB * glm::dvec4{glm::dvec3{p}, 1.0});
    for (const std::uint32_t i : b.indices) mesh.indices.push_back(static_cast<std::uint32_t>(a.positions.size()) + i);
    return mesh;
}

Mesh onePart(const Mesh& a, const Mesh& b, const glm::dmat4& transformOfB) { return joined(a, b, transformOfB); }

// As two instances and as one mesh: what crosses is the same.
std::array<Scene, 2> bothWays(const Mesh& a, const Mesh& b, const glm::dmat4& transformOfB) {
    return {sceneOf({{a, glm::dmat4{1.0}}, {b, transformOfB}}), sceneOf(onePart(a, b, transformOfB))};
}

TEST(Intersections, OfABoxThatSinksIntoATableAreItsFourSides) {
    for (const Scene& scene : bothWays(lines::views::sheet(10.0, 3), box({2, 1, 3}), translation({0.1, 0.2, 0.3}))) {
        const auto segments = intersectionsOf(scene);
        EXPECT_NEAR(totalLength(segments), 10.0, 1e-5);  // positions are floats
        for (const IntersectionSegment& s : segments) {
            EXPECT_LT(s.a, s.b);
            for (const glm::dvec3& end : s.ends) EXPECT_NEAR((end + scene.bounds().centre).y, 0.0, 1e-6);
        }
        for (const auto& [node, ends] : endsAtNodes(segments)) EXPECT_EQ(ends, 2) << "at node " << node;
    }
}

// Two crossing plates, as if a CAD file had them.
TEST(Intersections, OfFacesOfACadFileAreThoseOfFacesThatShareNoEdge) {
    const Mesh plates = joined(box({2, 0.1, 2}), box({2, 0.1, 2}), rotation(90.0, {1, 0, 0}));
    const auto count = static_cast<std::uint32_t>(plates.indices.size() / 3);
    const auto crossings = [&](auto&& faceOf) {
        Mesh mesh = plates;
        mesh.parameters.resize(mesh.positions.size());
        for (std::uint32_t t = 0; t < count; ++t) mesh.faces.push_back(faceOf(t));
        return totalLength(intersectionsOf(sceneOf(mesh)));
    };
    const double all = totalLength(intersectionsOf(sceneOf(plates)));
    EXPECT_GT(all, 4.0);
    EXPECT_DOUBLE_EQ(crossings([&](std::uint32_t t) { return 2 * t < count ? 0U : 1U; }), all);
    EXPECT_EQ(crossings([](std::uint32_t) { return 0U; }), 0.0) << "no face crosses itself";
    EXPECT_DOUBLE_EQ(crossings([](std::uint32_t t) { return t / 2; }), all) << "each side of a plate is a face";
}

TEST(Intersections, OfTwoSpheresAreOneClosedCircle) {
    // Two unit spheres a unit apart meet in a circle of radius sqrt(3) / 2.
    for (const Scene& scene : bothWays(sphere(1.0, 96), sphere(1.0, 80), translation({0.6, 0.7, std::sqrt(0.15)}))) {
        const auto segments = intersectionsOf(scene);
        const double circle = std::numbers::pi * std::sqrt(3.0);
        EXPECT_NEAR(totalLength(segments), circle, 0.005 * circle);  // of facets
        const auto ends = endsAtNodes(segments);
        EXPECT_EQ(ends.size(), segments.size());
        for (const auto& [node, count] : ends) EXPECT_EQ(count, 2) << "at node " << node;
        EXPECT_EQ(ends.rbegin()->first + 1, ends.size()) << "numbers are left out";
    }
}

TEST(Intersections, ShareAPointWhereTheyShareANode) {
    const Scene scene = sceneOf(onePart(sphere(1.0, 64), sphere(1.0, 48), translation({0.6, 0.7, 0.2})));
    std::map<std::uint32_t, glm::dvec3> ends;
    for (const IntersectionSegment& s : intersectionsOf(scene)) {
        for (std::size_t i = 0; i < 2; ++i) {
            const auto [entry, isNew] = ends.emplace(s.nodes[i], s.ends[i]);
            EXPECT_LT(glm::distance(entry->second, s.ends[i]), 1e-5);  // a few weld tolerances
        }
    }
    for (const auto& [node, end] : ends)
        for (const auto& [other, otherEnd] : ends)
            if (node < other) {
                ASSERT_GT(glm::distance(end, otherEnd), 1e-6);
            }
}

TEST(Intersections, NeedMoreThanTouch) {
    const glm::dmat4 turned = rotation(20.0, {0, 1, 0});
    // Stands on the table, however that is cut; off by a rounding either way.
    for (const double off : {0.0, 4e-7, -4e-7}) {
        for (const std::uint32_t cells : {1U, 2U, 7U}) {
            for (const Scene& scene :
                 bothWays(lines::views::sheet(10.0, cells), box({2, 1, 2}), translation({0, 0.5 + off, 0}) * turned))
                EXPECT_THAT(intersectionsOf(scene), IsEmpty()) << cells << " cells, off by " << off;
        }
    }
    const Mesh unit = cube(1.0);
    const auto expectNone = [](const Mesh& a, const Mesh& b, const glm::dmat4& transform, const char* what) {
        for (const Scene& scene : bothWays(a, b, transform)) EXPECT_THAT(intersectionsOf(scene), IsEmpty()) << what;
    };
    expectNone(unit, unit, translation({1, 0, 0}), "side by side");
    expectNone(unit, unit, translation({1, 0.5, 0.25}), "side by side, shifted");
    expectNone(unit, unit, translation({1, 1, 0}), "edge on edge");
    expectNone(unit, unit, translation({1, 1, 1}), "corner on corner");
    expectNone(unit, unit, translation({0.5, 1.0, 0.5}), "corner over the middle");
    expectNone(unit, cube(0.5), translation({0.25, 0.75, 0.0}), "on top, flush with a side");
    expectNone(unit, cube(0.5), translation({0.25, 0.25, 0.25}), "inside, flush with three sides");
    expectNone(lines::views::sheet(2.0, 3), lines::views::sheet(2.0, 2), translation({0.3, 0, 0.2}),
               "layers in one plane");
    expectNone(lines::views::sheet(4.0, 3), lines::views::sheet(2.0, 2),
               rotation(90.0, {1, 0, 0}) * translation({0, 0, -1}), "a wall on a floor");
    expectNone(lines::views::sheet(2.0, 3), lines::views::sheet(2.0, 2), rotation(10.0, {1, 0, 0}),
               "planes nearly the same");
    // The pole, a corner of many faces, and then a tip, touch the table.
    expectNone(lines::views::sheet(4.0, 3), sphere(1.0, 32), translation({0.1, 1, 0.1}), "a sphere on a table");
}

TEST(Intersections, OfWhatIsThereTwiceAreNone) {
    for (const std::uint32_t segments : {8U, 16U, 64U}) {
        const Mesh one = sphere(1.0, segments);
        for (const Scene& scene : bothWays(one, one, glm::dmat4{1.0})) EXPECT_THAT(intersectionsOf(scene), IsEmpty());
    }
    // A face that repeats another takes part once.
    Mesh twice = lines::views::sheet(10.0);
    twice.indices.insert(twice.indices.end(), twice.indices.begin(), twice.indices.end());
    const auto segments = intersectionsOf(sceneOf(onePart(twice, cube(1.0), rotation(10.0, {0, 1, 0}))));
    EXPECT_NEAR(totalLength(segments), 4.0, 1e-5);
}

TEST(Intersections, WhereAnEdgeLiesInAFaceAreOneLineOfTwo) {
    // The sphere's equator is a ring of edges; they lie in the table, and the table's own edges partly on theirs.
    const Mesh ball = sphere(1.0, 16);
    const double ring = 16.0 * 2.0 * std::sin(std::numbers::pi / 16.0);
    for (const std::uint32_t cells : {1U, 2U, 5U}) {
        for (const Scene& scene : bothWays(lines::views::sheet(4.0, cells), ball, glm::dmat4{1.0})) {
            const auto segments = intersectionsOf(scene);
            EXPECT_NEAR(totalLength(segments), ring, 1e-5) << cells;
            for (const auto& [node, ends] : endsAtNodes(segments)) EXPECT_EQ(ends, 2) << cells;
        }
    }
    // A cube's edges are lines themselves.
    for (const Scene& scene :
         bothWays(lines::views::sheet(4.0), cube(1.0), rotation(45.0, {0, 0, 1}) * rotation(90.0, {1, 0, 0})))
        EXPECT_NEAR(totalLength(intersectionsOf(scene)), 2.0 * std::sqrt(2.0), 1e-5);
}

// Corners of a face in the space of the segments' ends.
std::array<glm::dvec3, 3> cornersOf(const Scene& scene, scene::SceneFace face) {
    const Instance& instance = scene.instances()[face.instance];
    const Mesh& mesh = scene.meshes()[instance.mesh];
    std::array<glm::dvec3, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
        const glm::dvec3 position{mesh.positions[mesh.indices[3 * std::size_t{face.triangle} + k]]};
        corners[k] = glm::dvec3{instance.transform * glm::dvec4{mesh.origin + position, 1.0}} - scene.bounds().centre;
    }
    return corners;
}

// Unit normals of an instance's faces that hold a point, but for roundings.
std::vector<glm::dvec3> normalsAt(const Scene& scene, std::uint32_t instance, glm::dvec3 point) {
    constexpr double rounding = 1e-4;  // of positions in floats and of ends that are joined, some weld tolerances
    const std::size_t faces = scene.meshes()[scene.instances()[instance].mesh].indices.size() / 3;
    std::vector<glm::dvec3> normals;
    for (std::uint32_t i = 0; i < faces; ++i) {
        const auto [a, b, c] = cornersOf(scene, {instance, i});
        const glm::dvec3 normal = glm::normalize(glm::cross(b - a, c - a));
        const auto beside = [&](glm::dvec3 from, glm::dvec3 to) {
            return glm::dot(glm::cross(normal, glm::normalize(to - from)), point - from) < -rounding;
        };
        if (std::abs(glm::dot(normal, point - a)) > rounding || beside(a, b) || beside(b, c) || beside(c, a)) continue;
        normals.push_back(normal);
    }
    return normals;
}

bool meetAtASmallAngle(const Scene& scene, glm::dvec3 point) {
    const double limit = std::cos(glm::radians(minIntersectionAngle)) - 1e-4;  // faces that are equal but for roundings
    for (const glm::dvec3& a : normalsAt(scene, 0, point))
        for (const glm::dvec3& b : normalsAt(scene, 1, point))
            if (std::abs(glm::dot(a, b)) >= limit) return true;
    return false;
}

TEST(Intersections, OfSmoothBodiesAtExactDistancesEndOnlyWhereFacesAreNearlyParallel) {
    std::mt19937 random{5};
    const auto pick = [&](const auto& of) { return of[random() % of.size()]; };
    LoadSettings noCreases;
    noCreases.creaseAngle = 180.0F;
    std::size_t segmentsInAll = 0;
    for (int i = 0; i < 300; ++i) {
        const auto body = [&] {
            const std::uint32_t around = pick(std::array{8U, 12U, 16U, 24U});
            return pick(std::array{true, false}) ? sphere(1.0, around) : views::torus(1.0, 0.5, around, 12);
        };
        const std::array steps{-1.0, -0.75, -0.5, -0.25, 0.0, 0.25, 0.5, 0.75, 1.0};
        const glm::dvec3 step{pick(steps), pick(steps), pick(steps)};
        const glm::dvec3 axis{pick(std::array{0, 1}), pick(std::array{0, 1}), 1};
        const glm::dmat4 moved = translation(step) * rotation(pick(std::array{0.0, 30.0, 45.0, 90.0}), axis);
        // A sheet's faces lie exactly where rings of a body's edges do.
        const Mesh other = pick(std::array{true, false}) ? body() : views::sheet(6.0, pick(std::array{1U, 4U, 6U}));
        const Scene scene = sceneOf({{body(), glm::dmat4{1.0}}, {other, moved}}, noCreases);
        const std::vector<IntersectionSegment> segments = intersectionsOf(scene);
        const std::map<std::uint32_t, int> ends = endsAtNodes(segments);
        segmentsInAll += segments.size();
        for (const IntersectionSegment& s : segments)
            for (std::size_t k = 0; k < 2; ++k)
                if (ends.at(s.nodes[k]) % 2 != 0) {
                    EXPECT_TRUE(meetAtASmallAngle(scene, s.ends[k])) << "scene " << i << ", node " << s.nodes[k];
                }
    }
    EXPECT_GT(segmentsInAll, 10000U);
}

TEST(Intersections, KeepToTheirInstances) {
    const Mesh both = onePart(lines::views::sheet(4.0), cube(1.0), rotation(10.0, {0, 1, 0}));
    Scene::Data data;
    data.meshes.push_back(both);
    data.meshes.push_back(both);
    for (std::uint32_t i = 0; i < 4; ++i)
        data.instances.push_back({"copy", i % 2, translation({5.0 * i, 0, 0}) * scaling(glm::dvec3{1.0 + 0.1 * i})});
    const Scene scene{std::move(data)};
    const auto segments = intersectionsOf(scene);
    std::array<double, 4> lengths{};
    std::map<std::uint32_t, std::set<std::uint32_t>> instancesAt;
    for (const IntersectionSegment& s : segments) {
        ASSERT_EQ(s.a.instance, s.b.instance);
        lengths[s.a.instance] += glm::distance(s.ends[0], s.ends[1]);
        for (const std::uint32_t node : s.nodes) instancesAt[node].insert(s.a.instance);
        for (const glm::dvec3& end : s.ends)
            EXPECT_NEAR((end + scene.bounds().centre).x, 5.0 * s.a.instance, 0.8 * (1.0 + 0.1 * s.a.instance));
    }
    for (std::uint32_t i = 0; i < 4; ++i) EXPECT_NEAR(lengths[i], 4.0 * (1.0 + 0.1 * i), 1e-5);
    for (const auto& [node, instances] : instancesAt) EXPECT_EQ(instances.size(), 1U);
    EXPECT_TRUE(std::ranges::is_sorted(segments, {}, [](const IntersectionSegment& s) {
        return std::tuple{s.a.instance, s.b.instance, s.a.triangle, s.b.triangle};
    }));
}

TEST(Intersections, AreFoundBetweenMirroredScaledAndDistortedInstances) {
    for (const glm::dmat4& transform :
         {scaling({-2, 2, 2}), scaling({1, 3, 0.5}), rotation(33, {1, 2, 3}) * scaling(glm::dvec3{1e-3})}) {
        const Scene scene =
            sceneOf({{lines::views::sheet(4.0, 2), transform}, {cube(1.0), transform * rotation(10.0, {0, 1, 0})}});
        const auto segments = intersectionsOf(scene);
        const glm::dmat3 linear{transform};
        double expected = 0.0;
        for (int i = 0; i < 4; ++i) {
            const double angle = glm::radians(10.0 + 90.0 * i);
            expected += glm::length(linear * glm::dvec3{std::cos(angle), 0, std::sin(angle)});
        }
        EXPECT_NEAR(totalLength(segments) / expected, 1.0, 1e-5);
    }
}

TEST(Intersections, AreThoseThatEveryPairOfFacesHas) {
    // Leaves of a bumpy sheet, folded over itself: the tree must not lose any.
    const auto sheet = [](double phase) {
        Mesh mesh = lines::views::sheet(2.0, 40);
        for (glm::vec3& p : mesh.positions)
            p.y = static_cast<float>(0.2 * std::sin(7.0 * double{p.x} + phase) * std::cos(6.0 * double{p.z}));
        return mesh;
    };
    const Mesh one = onePart(sheet(0.0), sheet(1.0), rotation(4.0, {0, 1, 0.2}));
    const auto found = intersectionsOf(sceneOf(one));
    // Face by face, each a mesh of its own, so that there is no tree to pass anything over.
    std::set<std::pair<std::uint32_t, std::uint32_t>> expected;
    const std::uint32_t half = static_cast<std::uint32_t>(one.indices.size() / 6);
    const auto corner = [&](std::uint32_t t, std::uint32_t k) {
        return glm::dvec3{one.positions[one.indices[3 * t + k]]};
    };
    const auto normal = [&](std::uint32_t t) {
        return glm::normalize(glm::cross(corner(t, 1) - corner(t, 0), corner(t, 2) - corner(t, 0)));
    };
    const auto pierces = [&](std::uint32_t t, std::uint32_t of) {  // whether an edge of t goes through the face
        for (std::uint32_t k = 0; k < 3; ++k) {
            const glm::dvec3 p = corner(t, k);
            const glm::dvec3 q = corner(t, (k + 1) % 3);
            const double above = glm::dot(normal(of), p - corner(of, 0));
            const double below = glm::dot(normal(of), q - corner(of, 0));
            if (above * below >= 0.0) continue;
            const glm::dvec3 meeting = p + above / (above - below) * (q - p);
            bool inside = true;
            for (std::uint32_t e = 0; e < 3; ++e) {
                const glm::dvec3 side = corner(of, (e + 1) % 3) - corner(of, e);
                inside = inside && glm::dot(glm::cross(side, meeting - corner(of, e)), normal(of)) > 0.0;
            }
            if (inside) return true;
        }
        return false;
    };
    const double flat = std::cos(glm::radians(minIntersectionAngle));
    for (std::uint32_t t = 0; t < half; ++t) {
        for (std::uint32_t u = half; u < 2 * half; ++u) {
            const double apart = glm::distance(corner(t, 0), corner(u, 0));
            if (apart > 0.25 || std::abs(glm::dot(normal(t), normal(u))) >= flat) continue;  // longer than two edges
            if (pierces(t, u) || pierces(u, t)) expected.insert({t, u});
        }
    }
    std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;
    for (const IntersectionSegment& s : found) pairs.insert({s.a.triangle, s.b.triangle});
    EXPECT_GT(expected.size(), 200U);
    EXPECT_EQ(pairs, expected);
}

}  // namespace
}  // namespace inkedge::lines
