// Implicit surfaces whose every point is known.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <glm/geometric.hpp>

#include <inkedge/load_scene.h>

#include "base/expect_error.h"

namespace inkedge::implicit {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

const std::string ball = "bounds -1.2 -1.2 -1.2 1.2 1.2 1.2\nf = x^2 + y^2 + z^2 - 1\n";
const std::string torus = "bounds -1.5 -1.5 -0.5 1.5 1.5 0.5\nf = (sqrt(x^2 + y^2) - 1)^2\n    + z^2 - 0.09\n";
const std::string blend =
    "bounds -2 -1.2 -1.2 2 1.2 1.2\nf = 0.35 - exp(-2*((x-0.7)^2+y^2+z^2)) - exp(-2*((x+0.7)^2+y^2+z^2))\n";
const std::string gyroid = "bounds -3 -3 -3 3 3 3\nf = sin(x)*cos(y) + sin(y)*cos(z) + sin(z)*cos(x)\n";

LoadSettings quick() {
    LoadSettings settings;
    settings.tolerance = 0.5;
    return settings;
}

Scene sceneOf(const std::string& text, const LoadSettings& settings = quick()) {
    const std::vector<std::uint8_t> bytes{text.begin(), text.end()};
    return loadScene(bytes, "form.implicit", settings);
}

glm::dvec3 position(const Mesh& mesh, std::uint32_t vertex) { return glm::dvec3{mesh.positions[vertex]} + mesh.origin; }

// How many triangles each edge has, by the positions of its ends.
using Point = std::array<float, 3>;
std::map<std::pair<Point, Point>, int> edgesOf(const Mesh& mesh) {
    std::map<std::pair<Point, Point>, int> edges;
    const auto at = [&](std::size_t corner) {
        const glm::vec3& p = mesh.positions[mesh.indices[corner]];
        return Point{p.x, p.y, p.z};
    };
    for (std::size_t c = 0; c < mesh.indices.size(); ++c) ++edges[std::minmax(at(c), at(c / 3 * 3 + (c + 1) % 3))];
    return edges;
}

// How many edges have so many triangles.
std::map<int, int> trianglesOfEdges(const Mesh& mesh) {
    std::map<int, int> counts;
    for (const auto& [edge, count] : edgesOf(mesh)) ++counts[count];
    return counts;
}

struct Known {
    std::string text;
    double (*field)(glm::dvec3);       // a distance from the surface, near it
    glm::dvec3 (*normal)(glm::dvec3);  // over there
    int characteristic;                // of Euler: vertices less edges and faces
};

const std::vector<Known> known{
    {ball, [](glm::dvec3 p) { return glm::length(p) - 1.0; }, [](glm::dvec3 p) { return glm::normalize(p); }, 2},
    {torus, [](glm::dvec3 p) { return std::hypot(std::hypot(p.x, p.y) - 1.0, p.z) - 0.3; },
     [](glm::dvec3 p) {
         const glm::dvec3 middle = glm::normalize(glm::dvec3{p.x, p.y, 0.0});
         return glm::normalize(p - middle);
     },
     0}};

TEST(LoadImplicit, liesOnTheSurfaceWithItsNormals) {
    for (const Known& surface : known) {
        const Scene scene = sceneOf(surface.text);
        const Mesh& mesh = scene.meshes()[0];
        ASSERT_GT(mesh.positions.size(), 1000U);
        for (std::uint32_t i = 0; i < mesh.positions.size(); ++i) {
            const glm::dvec3 p = position(mesh, i);
            ASSERT_NEAR(surface.field(p), 0.0, 1e-6);  // floats
            ASSERT_GT(glm::dot(surface.normal(p), glm::dvec3{mesh.normals[i]}), 1.0 - 1e-7);
        }
    }
}

TEST(LoadImplicit, isClosedAndOfTheRightGenus) {
    for (const Known& surface : known) {
        const Scene scene = sceneOf(surface.text);
        const Mesh& mesh = scene.meshes()[0];
        const std::map<int, int> edges = trianglesOfEdges(mesh);
        ASSERT_EQ(edges.size(), 1U) << "every edge is of as many triangles";
        EXPECT_EQ(edges.begin()->first, 2);
        std::vector<std::array<float, 3>> points;
        for (const glm::vec3& p : mesh.positions) points.push_back({p.x, p.y, p.z});
        std::ranges::sort(points);
        points.erase(std::unique(points.begin(), points.end()), points.end());
        const int faces = static_cast<int>(mesh.indices.size() / 3);
        EXPECT_EQ(static_cast<int>(points.size()) - edges.begin()->second + faces, surface.characteristic);
        for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
            const std::array p{position(mesh, mesh.indices[t]), position(mesh, mesh.indices[t + 1]),
                               position(mesh, mesh.indices[t + 2])};
            const glm::dvec3 normal = glm::cross(p[1] - p[0], p[2] - p[0]);
            ASSERT_GT(glm::dot(normal, surface.normal((p[0] + p[1] + p[2]) / 3.0)), 0.0) << "no triangle is turned";
        }
    }
    EXPECT_EQ(trianglesOfEdges(sceneOf(blend).meshes()[0]).size(), 1U);
}

TEST(LoadImplicit, straysFromTheSurfaceByAsMuchAsIsAllowed) {
    for (const Known& surface : known) {
        for (const double tolerance : {0.1, 1.0}) {
            LoadSettings settings;
            settings.tolerance = tolerance;
            settings.pictures.picture.size = {500, 500};
            const Scene scene = sceneOf(surface.text, settings);
            const Mesh& mesh = scene.meshes()[0];
            double farthest = 0.0;
            for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
                const glm::dvec3 middle = (position(mesh, mesh.indices[t]) + position(mesh, mesh.indices[t + 1]) +
                                           position(mesh, mesh.indices[t + 2])) /
                                          3.0;
                farthest = std::max(farthest, std::abs(surface.field(middle)));
            }
            // The picture shows no more than the model's size, which is over 2, in its 500 pixels.
            EXPECT_LT(farthest, tolerance * 2.0 * scene.bounds().radius / 500.0);
        }
    }
}

TEST(LoadImplicit, endsAtItsBounds) {
    const Scene scene = sceneOf(gyroid);
    std::size_t borders = 0;
    for (const auto& [edge, count] : edgesOf(scene.meshes()[0])) {
        ASSERT_LE(count, 2);
        if (count == 2) continue;
        ++borders;
        const auto isOnBounds = [](const Point& p) {
            return std::ranges::any_of(p, [](float v) { return std::abs(std::abs(v) - 3.0F) < 1e-5F; });
        };
        EXPECT_TRUE(isOnBounds(edge.first) && isOnBounds(edge.second));
    }
    EXPECT_GT(borders, 100U);
}

TEST(LoadImplicit, hasTheUnitAndTheNameOfItsFile) {
    const Scene scene =
        sceneOf("\xef\xbb\xbf# a ball\r\n\r\nbounds -2 -2 -2 2 2 2  # round\r\nunit in\r\nf=x*x+y*y+z*z-1");
    EXPECT_EQ(scene.source().unit, LengthUnit::Inch);
    EXPECT_EQ(scene.source().format, "implicit surface");
    EXPECT_EQ(scene.up(), glm::dvec3(0, 0, 1));
    EXPECT_EQ(scene.instances()[0].name, "form");
    EXPECT_EQ(sceneOf(ball).source().unit, LengthUnit::None);
}

TEST(LoadImplicit, refusesWhatIsNoneInOneLine) {
    const std::string bounds = "bounds -1 -1 -1 1 1 1\n";
    const std::vector<std::pair<std::string, std::string>> faults{
        {"# nothing\n", "expected a line of bounds, as in 'bounds -1 -1 -1 1 1 1', found none"},
        {bounds, "expected a line of f, as in 'f = x^2 + y^2 + z^2 - 1', found none"},
        {"f = x\n", "expected a line of bounds"},
        {bounds + "g = x\n", "expected bounds, unit or f =, each once, found 'g = x' in line 2"},
        {bounds + "f = x\nf = y\n", "expected bounds, unit or f =, each once, found 'f = y' in line 3"},
        {bounds + bounds + "f = x\n", "expected bounds once"},
        {"bounds 1 2 3\nf = x\n", "expected six numbers under 1e30 after bounds, found '' in line 1"},
        {"bounds 0 0 0 1 1 nan\nf = x\n", "expected six numbers under 1e30 after bounds, found 'nan' in line 1"},
        {"bounds 0 0 0 1 0 1\nf = x\n", "found '0 and 0' in line 1"},
        {bounds + "unit ell\nf = x\n", "unit in line 2: expected one of"},
        {bounds + "f = x +\n", "expected an expression of x, y and z, found"},
        {bounds + "f = w\n", "expected an expression of x, y and z, found"},
        {bounds + "f = x, y\n", "expected one value of f, found 2"},
        {bounds + "f = x + 5\n", "expected f = 0 somewhere within the bounds, found it over 0 everywhere"},
        {bounds + "f = x - 5\n", "expected f = 0 somewhere within the bounds, found it under 0 everywhere"},
        {bounds + "f = ln(x)\n", "expected finite values of f within the bounds, found"},
        {bounds + "f = x + " + std::string(20'000, '('),
         "expected an expression of at most 10000 characters, found more"}};
    for (const auto& fault : faults)
        expectError(Error::Kind::Input, AllOf(StartsWith("form.implicit: "), HasSubstr(fault.second)),
                    [&] { sceneOf(fault.first); });
    LoadSettings settings;
    settings.limits.vertices = 100;
    expectError(Error::Kind::Input,
                HasSubstr("expected at most 100 vertices and indices, found more; raise max-vertices"),
                [&] { sceneOf(ball, settings); });
}

TEST(LoadImplicit, comesToAnEnd) {
    const std::string bounds = "bounds -1 -1 -1 1 1 1\n";
    // It passes through every part of the bounds: what would be made is refused before it is.
    expectError(Error::Kind::Input, HasSubstr("vertices and indices, found more; raise max-vertices"),
                [&] { sceneOf(bounds + "f = sin(1e9*x*y + 3e9*z)\n"); });
    LoadSettings settings;
    settings.limits.readingTime = 0.01;
    std::string slow = "x";
    for (int i = 0; i < 1000; ++i) slow = slow + (i % 80 == 0 ? "\n " : "") + "+sin(y)";
    expectError(Error::Kind::Input,
                HasSubstr("expected triangles of the surface within 0.01 s, found it still at work"),
                [&] { sceneOf(bounds + "f = " + slow + "\n", settings); });
}

}  // namespace
}  // namespace inkedge::implicit
