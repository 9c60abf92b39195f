#include "mesh/cut_out.h"

#include <cmath>
#include <memory>
#include <random>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include <inkedge/error.h>
#include <inkedge/scene.h>

#include "mesh/clip_polygon.h"
#include "mesh/polygon_triangles.h"
#include "mesh/topology.h"
#include "mesh/twice_area.h"

namespace inkedge::mesh {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

std::uint64_t cells = CutOut::maxCells;  // for all tests together

constexpr std::array repeat{TextureWrap::Repeat, TextureWrap::Repeat};
constexpr std::array clamped{TextureWrap::Clamp, TextureWrap::Clamp};

// Opaque where inside(x, y) of texel centres, in texels.
template <class Inside>
std::shared_ptr<const Image<std::uint8_t>> mapOf(int size, Inside&& inside) {
    Image<std::uint8_t> map{{size, size}, 1};
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) map.at(x, y) = inside(x + 0.5, y + 0.5) ? 255 : 0;
    return std::make_shared<const Image<std::uint8_t>>(std::move(map));
}

// A sheet of n x n squares over texture coordinates 0..1, its vertices shaken so that edges run in all directions.
struct Sheet {
    std::vector<glm::dvec2> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;

    explicit Sheet(std::uint32_t n) {
        std::mt19937 random{7};
        std::uniform_real_distribution<double> shake{-0.3 / n, 0.3 / n};
        for (std::uint32_t y = 0; y <= n; ++y) {
            for (std::uint32_t x = 0; x <= n; ++x) {
                const bool rim = x == 0 || y == 0 || x == n || y == n;
                const glm::dvec2 moved{shake(random), shake(random)};
                vertices.push_back(glm::dvec2{x, y} / static_cast<double>(n) + (rim ? glm::dvec2{0.0} : moved));
            }
        }
        for (std::uint32_t y = 0; y < n; ++y) {
            for (std::uint32_t x = 0; x < n; ++x) {
                const std::uint32_t a = y * (n + 1) + x;
                triangles.push_back({a, a + 1, a + n + 1});
                triangles.push_back({a + n + 1, a + 1, a + n + 2});
            }
        }
    }

    using Corners = std::array<glm::dvec2, 3>;

    // What a cut-out leaves, in texture space.
    [[nodiscard]] Mesh cut(CutOut& cutOut) const {
        return cut([&](const Corners& corners) { return cutOut.cut(corners); });
    }
    // The same with a factor that is a function of the uv.
    template <class Factor>
    [[nodiscard]] Mesh cut(CutOut& cutOut, Factor&& factor) const {
        return cut([&](const Corners& corners) {
            return cutOut.cut(corners, {factor(corners[0]), factor(corners[1]), factor(corners[2])});
        });
    }

private:
    template <class Cut>
    [[nodiscard]] Mesh cut(Cut&& piecesOf) const {
        Mesh mesh;
        for (const auto& t : triangles) {
            const Corners corners{vertices[t[0]], vertices[t[1]], vertices[t[2]]};
            for (const TrianglePiece& piece : piecesOf(corners)) {
                for (const glm::dvec3& w : piece) {
                    const glm::dvec2 p = w.x * corners[0] + w.y * corners[1] + w.z * corners[2];
                    mesh.indices.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
                    mesh.positions.emplace_back(p, 0.0);
                }
            }
        }
        return mesh;
    }
};

double signedArea(const Mesh& mesh, std::size_t first) {
    const glm::dvec3 a{mesh.positions[first]};
    return 0.5 * glm::cross(glm::dvec3{mesh.positions[first + 1]} - a, glm::dvec3{mesh.positions[first + 2]} - a).z;
}

double signedArea(const Mesh& mesh) {
    double area = 0.0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) area += signedArea(mesh, i);
    return area;
}

// Of triangles that lie the wrong way round, over others.
double turnedArea(const Mesh& mesh) {
    double area = 0.0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) area += std::max(-signedArea(mesh, i), 0.0);
    return area;
}

// The length of the mesh's borders within the sheet: an outline, if no gap is left between pieces.
double innerBorder(const Mesh& mesh) {
    const MeshTopology topology = buildTopology(mesh);
    double length = 0.0;
    for (std::uint32_t h = 0; h < topology.twins.size(); ++h) {
        if (isHalfEdge(topology.twins[h])) continue;
        const glm::vec3 a = mesh.positions[mesh.indices[h]];
        const glm::vec3 b = mesh.positions[mesh.indices[nextHalfEdge(h)]];
        const auto onRim = [&](int axis) {
            constexpr float rounding = 1e-6F;
            const float border = std::round(a[axis]);
            return std::abs(a[axis] - border) < rounding && std::abs(b[axis] - border) < rounding;
        };
        if (!onRim(0) && !onRim(1)) length += static_cast<double>(glm::distance(a, b));
    }
    return length;
}

// Between texels that are there or not the outline runs in eight directions, so that it is longer than the shape's by
// up to 1 / cos(22.5 degrees) - 1. A crack would add its two sides.
constexpr double staircase = 0.0824;

TEST(CutOutTest, ADiscIsCutOutOfASheetWithoutAGap) {
    constexpr int size = 300;  // several cells of the lattice, which it is no multiple of
    constexpr double radius = 0.4;
    CutOut cutOut{mapOf(size, [](double x, double y) { return std::hypot(x / size - 0.5, y / size - 0.5) < radius; }),
                  clamped, 127.5, cells};
    const Mesh mesh = Sheet{9}.cut(cutOut);
    // Half a texel all along: as good as if texels were only opaque or not.
    const double circumference = 2.0 * M_PI * radius;
    EXPECT_NEAR(signedArea(mesh), M_PI * radius * radius, circumference * 0.5 / size);
    EXPECT_NEAR(innerBorder(mesh), circumference, staircase * circumference);
}

TEST(CutOutTest, HolesAreLeftOpen) {
    constexpr int size = 200;
    const auto isHole = [](double x, double y) {
        for (const glm::dvec2 centre :
             {glm::dvec2{60, 60}, glm::dvec2{60, 140}, glm::dvec2{140, 70}, glm::dvec2{130, 150}})
            if (glm::distance(glm::dvec2{x, y}, centre) < 25.0) return true;
        return false;
    };
    CutOut cutOut{mapOf(size, [&](double x, double y) { return !isHole(x, y); }), clamped, 127.5, cells};
    for (const std::uint32_t n : {1U, 5U}) {
        const Mesh mesh = Sheet{n}.cut(cutOut);
        const double r = 25.0 / size;
        EXPECT_NEAR(signedArea(mesh), 1.0 - 4.0 * M_PI * r * r, 4.0 * 2.0 * M_PI * r * 0.5 / size);
        EXPECT_NEAR(innerBorder(mesh), 4.0 * 2.0 * M_PI * r, staircase * 4.0 * 2.0 * M_PI * r);
    }
}

TEST(CutOutTest, MirroredTrianglesKeepTheirWinding) {
    CutOut cutOut{mapOf(64, [](double x, double) { return x < 32.0; }), clamped, 127.5, cells};
    const std::array corners{glm::dvec2{0, 0}, glm::dvec2{0, 1}, glm::dvec2{1, 0}};
    double area = 0.0;
    for (const TrianglePiece& piece : cutOut.cut(corners)) {
        std::array<glm::dvec2, 3> p;
        for (std::size_t i = 0; i < 3; ++i)
            p[i] = piece[i].x * corners[0] + piece[i].y * corners[1] + piece[i].z * corners[2];
        const double part = (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[1].y - p[0].y) * (p[2].x - p[0].x);
        EXPECT_LE(part, 1e-12);
        area += 0.5 * part;
    }
    EXPECT_NEAR(area, -(0.5 - 0.125), 1e-9);  // the outline runs through the texture's middle
}

TEST(CutOutTest, WhatLiesWhollyInOrOutStaysOrGoes) {
    CutOut all{mapOf(16, [](double, double) { return true; }), repeat, 127.5, cells};
    CutOut none{mapOf(16, [](double, double) { return false; }), repeat, 127.5, cells};
    const Sheet sheet{3};
    EXPECT_NEAR(signedArea(sheet.cut(all)), 1.0, 1e-6);  // positions are floats
    EXPECT_THAT(sheet.cut(none).indices, IsEmpty());
}

TEST(CutOutTest, RepeatedPicturesRepeatTheOutline) {
    constexpr int size = 40;
    CutOut cutOut{mapOf(size, [](double x, double y) { return std::hypot(x - 20, y - 20) < 12; }), repeat, 127.5,
                  cells};
    const std::array<glm::dvec2, 3> below{glm::dvec2{0, 0}, glm::dvec2{4, 0}, glm::dvec2{0, 4}};
    double share = 0.0;
    for (const TrianglePiece& piece : cutOut.cut(below))
        share += std::abs(glm::determinant(glm::dmat3{piece[0], piece[1], piece[2]}));
    EXPECT_NEAR(share, M_PI * 12 * 12 / (size * size), 0.02);
}

TEST(CutOutTest, TrianglesWithoutAreaInThePictureAreJudgedByOnePoint) {
    CutOut cutOut{mapOf(8, [](double x, double) { return x < 4; }), clamped, 127.5, cells};
    EXPECT_THAT(cutOut.cut({glm::dvec2{0.1, 0.5}, glm::dvec2{0.1, 0.5}, glm::dvec2{0.1, 0.5}}), SizeIs(1));
    EXPECT_THAT(cutOut.cut({glm::dvec2{0.9, 0.5}, glm::dvec2{0.9, 0.5}, glm::dvec2{0.9, 0.5}}), IsEmpty());
}

TEST(CutOutTest, RefusesWhatWouldTakeTooLong) {
    CutOut cutOut{mapOf(128, [](double x, double) { return x < 64; }), repeat, 127.5, cells};
    EXPECT_THROW(static_cast<void>(cutOut.cut({glm::dvec2{0, 0}, glm::dvec2{1000, 0}, glm::dvec2{0, 1000}})), Error);
    EXPECT_THROW(static_cast<void>(cutOut.cut({glm::dvec2{NAN, 0}, glm::dvec2{1, 0}, glm::dvec2{0, 1}})), Error);
}

// Noise has more outline than anything drawn. Its polygons touch themselves in many points, where a few of their
// triangles may overlap: under a hundredth of the area.
TEST(CutOutTest, NoiseIsCut) {
    std::mt19937 random{3};
    CutOut cutOut{mapOf(96, [&](double, double) { return random() % 2 == 0; }), clamped, 127.5, cells};
    const Mesh whole = Sheet{1}.cut(cutOut);
    const Mesh parts = Sheet{4}.cut(cutOut);
    EXPECT_NEAR(signedArea(parts), signedArea(whole), 1e-4);
    EXPECT_LE(turnedArea(whole), 0.01 * signedArea(whole));
    EXPECT_LE(turnedArea(parts), 0.01 * signedArea(parts));
}

TEST(CutOutTest, CellsAreBoundedForAllCutOutsTogether) {
    std::uint64_t few = 12;  // four about the picture's corner for each of three
    const std::array corners{glm::dvec2{0, 0}, glm::dvec2{0.1, 0}, glm::dvec2{0, 0.1}};
    const auto map = mapOf(1024, [](double x, double) { return x < 20; });
    for (int i = 0; i < 3; ++i) EXPECT_NO_THROW(static_cast<void>((CutOut{map, repeat, 127.5 + i, few}.cut(corners))));
    CutOut one{map, repeat, 127.5, few};
    EXPECT_THROW(static_cast<void>(one.cut(corners)), Error);
}

// The part of a long outline beside a small triangle gives the same pieces as the whole.
TEST(CutOutTest, OfALongOutlineOnlyWhatLiesBesideATriangleIsCutAlong) {
    std::mt19937 random{5};
    const std::vector<Polygon> outline = untangled(std::vector<Polygon>{[&] {
        Polygon star;
        std::uniform_real_distribution<double> radius{20.0, 60.0};
        for (int i = 0; i < 2000; ++i) {
            const double angle = 2.0 * M_PI * i / 2000;
            star.push_back(glm::dvec2{64.0} + radius(random) * glm::dvec2{std::cos(angle), std::sin(angle)});
        }
        return star;
    }()});
    std::uniform_real_distribution<double> at{10.0, 118.0};
    for (int i = 0; i < 50; ++i) {
        const glm::dvec2 corner{at(random), at(random)};
        const Polygon small{corner, corner + glm::dvec2{9, 1}, corner + glm::dvec2{2, 8}};
        const std::vector<Polygon> near = beside(small, outline);
        std::size_t corners = 0;
        for (const Polygon& loop : near) corners += loop.size();
        EXPECT_LT(corners, 1500U);
        const auto areaWithin = [&](std::span<const Polygon> area) {
            double sum = 0.0;
            for (const PolygonTriangle& t : trianglesWithin(small, area)) sum += 0.5 * twiceArea(t[0], t[1], t[2]);
            return sum;
        };
        // Where edges meet the tessellator moves them by rounding, and so more where more of them meet.
        EXPECT_NEAR(areaWithin(near), areaWithin(outline), 1e-4) << i;
    }
}

TEST(CutOutTest, LongOutlinesAreCutWithoutAGap) {
    const auto lace = mapOf(240, [](double x, double y) {
        return std::abs(std::hypot(std::fmod(x, 12.0) - 6.0, std::fmod(y, 12.0) - 6.0) - 3.5) > 1.0;
    });
    CutOut cutOut{lace, clamped, 127.5, cells};
    const Mesh whole = Sheet{2}.cut(cutOut);
    const Mesh parts = Sheet{24}.cut(cutOut);
    EXPECT_NEAR(signedArea(parts), signedArea(whole), 1e-4);
    // The tessellator's rounding leaves cracks here and there, as it does along whole outlines: 1.5 % more border.
    EXPECT_NEAR(innerBorder(parts), innerBorder(whole), 0.02 * innerBorder(whole));
}

// ---- factors that change from corner to corner

double one(glm::dvec2) { return 1.0; }
double falling(glm::dvec2 uv) { return 1.0 - 0.5 * uv.x; }

TEST(CutOutTest, FactorsOfOneCutTheSameDiscWithoutAGap) {
    constexpr int size = 300;
    constexpr double radius = 0.4;
    CutOut cutOut{mapOf(size, [](double x, double y) { return std::hypot(x / size - 0.5, y / size - 0.5) < radius; }),
                  clamped, 127.5, cells};
    constexpr double circumference = 2.0 * M_PI * radius;
    for (const std::uint32_t n : {1U, 2U, 9U}) {
        const Mesh mesh = Sheet{n}.cut(cutOut, one);
        EXPECT_NEAR(signedArea(mesh), M_PI * radius * radius, circumference * 0.5 / size) << n;
        EXPECT_NEAR(innerBorder(mesh), circumference, staircase * circumference) << n;
        EXPECT_LE(turnedArea(mesh), 1e-6) << n;  // positions are floats
    }
}

// A cone of opacity that is 1 in the middle, times a factor that falls towards the right.
TEST(CutOutTest, ChangingFactorsMoveTheOutlineWithoutAGap) {
    constexpr int size = 256;
    Image<std::uint8_t> cone{{size, size}, 1};
    const auto opacity = [](double x, double y) { return std::max(0.0, 1.0 - 2.0 * std::hypot(x - 0.5, y - 0.5)); };
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            cone.at(x, y) = static_cast<std::uint8_t>(std::lround(255.0 * opacity((x + 0.5) / size, (y + 0.5) / size)));
    CutOut cutOut{std::make_shared<const Image<std::uint8_t>>(cone), clamped, 0.3 * 255.0, cells};
    constexpr int fine = 1000;
    int inside = 0;
    for (int y = 0; y < fine; ++y)
        for (int x = 0; x < fine; ++x) {
            const glm::dvec2 uv{(x + 0.5) / fine, (y + 0.5) / fine};
            inside += opacity(uv.x, uv.y) * falling(uv) >= 0.3 ? 1 : 0;
        }
    const double area = static_cast<double>(inside) / (fine * fine);
    const double around = innerBorder(Sheet{1}.cut(cutOut, falling));
    EXPECT_NEAR(around, 2.0 * std::sqrt(M_PI * area), 0.03 * around);  // nearly a circle
    for (const std::uint32_t n : {1U, 3U, 12U}) {
        const Mesh mesh = Sheet{n}.cut(cutOut, falling);
        EXPECT_NEAR(signedArea(mesh), area, around * 0.5 / size) << n;
        EXPECT_NEAR(innerBorder(mesh), around, 0.02 * around) << n;  // a crack would add its two sides
    }
}

TEST(CutOutTest, NoiseIsCutWhereFactorsChange) {
    std::mt19937 random{3};
    CutOut cutOut{mapOf(96, [&](double, double) { return random() % 2 == 0; }), clamped, 80.0, cells};
    const Mesh whole = Sheet{1}.cut(cutOut, falling);
    const Mesh parts = Sheet{4}.cut(cutOut, falling);
    EXPECT_NEAR(signedArea(parts), signedArea(whole), 0.02 * signedArea(whole));  // other steps within each
    EXPECT_LE(turnedArea(whole), 0.01 * signedArea(whole));
    EXPECT_LE(turnedArea(parts), 0.01 * signedArea(parts));
}

TEST(CutOutTest, FactorsAreCutWhereThePictureHasNoArea) {
    CutOut cutOut{mapOf(8, [](double, double) { return true; }), clamped, 127.5, cells};
    const glm::dvec2 uv{0.5, 0.5};
    double share = 0.0;
    for (const TrianglePiece& piece : cutOut.cut({uv, uv, uv}, {1.0, 1.0, 0.0}))
        share += glm::determinant(glm::dmat3{piece[0], piece[1], piece[2]});
    EXPECT_NEAR(share, 0.75, 1e-12);
}

TEST(CutOutTest, RefusesWhatWouldTakeTooLongWhereFactorsChange) {
    CutOut cutOut{mapOf(128, [](double x, double) { return x < 64; }), repeat, 127.5, cells};
    const glm::dvec3 factors{1.0, 0.5, 1.0};
    EXPECT_THROW(static_cast<void>(cutOut.cut({glm::dvec2{0, 0}, glm::dvec2{100, 0}, glm::dvec2{0, 1}}, factors)),
                 Error);
    EXPECT_THROW(static_cast<void>(cutOut.cut({glm::dvec2{NAN, 0}, glm::dvec2{1, 0}, glm::dvec2{0, 1}}, factors)),
                 Error);
}

}  // namespace
}  // namespace inkedge::mesh
