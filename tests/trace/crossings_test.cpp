// Where lines cross the steps between samples, and what they are. Scenes are seen orthographically, a unit to a sample;
// what the samples see is worked out triangle by triangle.
#include "trace/crossings.h"

#include <cmath>

#include <gmock/gmock.h>
#include <glm/geometric.hpp>

#include "raster/plane_pairs.h"
#include "scene/prepared.h"
#include "scenes.h"

namespace inkedge::trace {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr Size size{8, 6};
constexpr double eye = 20.0;  // its z

Camera camera() {
    Camera camera;
    camera.view = scenes::translation({0, 0, -eye});
    camera.orthographicHeight = size.height;
    camera.near = 1.0;
    camera.far = 40.0;
    return camera;
}

// A point of the world, by the samples that it is seen at.
glm::dvec3 at(double x, double y, double z) { return {x - 0.5 * size.width, 0.5 * size.height - y, z}; }

// A sheet over all rows, between two columns.
Mesh sheet(double fromX, double fromZ, double toX, double toZ) {
    return scenes::quad(at(fromX, 7, fromZ), at(toX, 7, toZ), at(toX, -1, toZ), at(fromX, -1, fromZ));
}

void append(Mesh& mesh, const Mesh& part) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), part.positions.begin(), part.positions.end());
    for (const std::uint32_t i : part.indices) mesh.indices.push_back(first + i);
}

// All in one mesh: sheets that share two corners are joined there.
Scene together(const std::vector<Mesh>& parts) {
    Mesh mesh;
    for (const Mesh& part : parts) append(mesh, part);
    return scenes::sceneOf(mesh);
}

// A node each.
Scene apart(const std::vector<Mesh>& parts) {
    std::vector<std::pair<Mesh, glm::dmat4>> instances;
    for (const Mesh& part : parts) instances.emplace_back(part, glm::dmat4{1.0});
    return scenes::sceneOf(instances);
}

// A scene, and what its samples see.
class Seen {
public:
    explicit Seen(Scene scene)
        : scene_{std::move(scene)},
          first_{firstTriangles()},
          triangles_{scene_, first_, camera(), size},
          buffers_{size, {size, 4}, {size, 1}, {size, 1}} {
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) look(x, y);
        mark();
    }

    [[nodiscard]] CrossingRow row(int y) const {
        CrossingRow row{size.width};
        tracer().traceRow(y, row);
        return row;
    }

    // The crossing to the right of a sample of the third row; without types if there is none.
    [[nodiscard]] StepCrossing rightOf(int x) const { return row(2).right[static_cast<std::size_t>(x)]; }

    [[nodiscard]] CrossingTracer tracer() const { return {buffers_, triangles_, camera()}; }

private:
    [[nodiscard]] std::vector<std::uint32_t> firstTriangles() const {
        std::vector<std::uint32_t> first;
        std::uint32_t count = 0;
        for (const Instance& instance : scene_.instances()) {
            first.push_back(count);
            count += static_cast<std::uint32_t>(scene_.meshes()[instance.mesh].indices.size() / 3);
        }
        return first;
    }

    [[nodiscard]] bool covers(scene::SceneFace face, glm::dvec2 p) const {
        const std::vector<std::uint32_t>& indices = scene_.meshes()[face.instance].indices;
        int left = 0;
        for (std::uint32_t k = 0; k < 3; ++k) {
            const glm::dvec2 a{triangles_.projected(face.instance, indices[3 * face.triangle + k])};
            const glm::dvec2 b{triangles_.projected(face.instance, indices[3 * face.triangle + (k + 1) % 3])};
            left += (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x) > 0.0 ? 1 : 0;
        }
        return left == 0 || left == 3;
    }

    void look(int x, int y) {
        const glm::dvec2 centre{x + 0.5, y + 0.5};
        for (int channel = 0; channel < 4; ++channel) buffers_.planes(x, y, channel) = 0.0F;
        buffers_.triangles(x, y) = 0;
        for (std::uint32_t i = 0; i < scene_.instances().size(); ++i) {
            const auto count = static_cast<std::uint32_t>(scene_.meshes()[i].indices.size() / 3);
            for (std::uint32_t t = 0; t < count; ++t) {
                if (!covers({i, t}, centre)) continue;
                const auto [w, dx, dy] = triangles_.plane({i, t}, centre);
                if (buffers_.triangles(x, y) != 0 && w <= static_cast<double>(buffers_.planes(x, y))) continue;
                const float patch = 0x1p48F * static_cast<float>(triangles_.patchOf({i, t}));
                const float values[]{static_cast<float>(w), static_cast<float>(dx), static_cast<float>(dy), patch};
                for (int channel = 0; channel < 4; ++channel) buffers_.planes(x, y, channel) = values[channel];
                buffers_.triangles(x, y) = first_[i] + t + 1;
            }
        }
    }

    [[nodiscard]] raster::SeenPlane plane(int x, int y) const {
        const auto value = [&](int channel) { return static_cast<double>(buffers_.planes(x, y, channel)); };
        return {value(0), {value(1), value(2)}, value(3), {x + 0.5 - 0.5 * size.width, y + 0.5 - 0.5 * size.height}};
    }

    void mark() {
        const raster::PlaneView view{camera().focalLengths(size), true,
                                     std::cos(scene_.creaseAngle() * std::numbers::pi / 180.0)};
        for (int y = 0; y < size.height; ++y) {
            for (int x = 0; x < size.width; ++x) {
                unsigned marks = x + 1 < size.width ? pairMarks(plane(x, y), plane(x + 1, y), 0, view) : 0;
                if (y + 1 < size.height) marks |= pairMarks(plane(x, y), plane(x, y + 1), 1, view) << 4U;
                buffers_.marks(x, y) = static_cast<std::uint8_t>(marks);
            }
        }
    }

    Scene scene_;
    std::vector<std::uint32_t> first_;
    ScreenTriangles triangles_;
    LineBuffers buffers_;
};

constexpr double rounding = 1e-5;  // of floats

void expectCrossing(const StepCrossing& found, double x, LineTypes types, double z) {
    EXPECT_EQ(found.types, types);
    EXPECT_NEAR(found.position.x, x, rounding);
    EXPECT_NEAR(found.position.y, 2.5, rounding);
    EXPECT_NEAR(found.inverseDepth, z - eye, 20.0 * rounding) << "minus the depth of the nearer surface there";
}

TEST(TracedCrossings, areWhereASheetEnds) {
    const Seen seen{together({sheet(1.2, 0, 5.3, 0)})};
    const CrossingRow row = seen.row(2);
    EXPECT_THAT(row.columns, ElementsAre(0, 4));
    expectCrossing(row.right[0], 1.2, LineType::Outline | LineType::Boundary, 0);
    expectCrossing(row.right[4], 5.3, LineType::Outline | LineType::Boundary, 0);
    EXPECT_EQ(row.right[0].face.instance, 0U);
}

TEST(TracedCrossings, areBelowASampleToo) {
    const Seen seen{together({scenes::quad(at(-1, 3.7, 0), at(9, 3.7, 0), at(9, -1, 0), at(-1, -1, 0))})};
    const CrossingRow row = seen.row(3);
    ASSERT_EQ(row.columns.size(), std::size_t{size.width});
    EXPECT_EQ(row.down[4].types, LineType::Outline | LineType::Boundary);
    EXPECT_NEAR(row.down[4].position.x, 4.5, rounding);
    EXPECT_NEAR(row.down[4].position.y, 3.7, rounding);
    EXPECT_EQ(row.right[4].types, LineTypes{});
    EXPECT_THAT(seen.row(2).columns, IsEmpty());
}

TEST(TracedCrossings, ofASolidAreNoBoundaries) {
    const Seen seen{together({scenes::box({4.1, 20, 3})})};  // from x = 1.95 to 6.05
    expectCrossing(seen.rightOf(1), 1.95, LineType::Outline, 1.5);
    expectCrossing(seen.rightOf(5), 6.05, LineType::Outline, 1.5);
}

TEST(TracedCrossings, areWhereTheNearerSurfaceEnds) {
    const Mesh wall = sheet(-1, 0, 9, 0);
    const Mesh front = sheet(3.3, 5, 9, 5);
    expectCrossing(Seen{together({wall, front})}.rightOf(2), 3.3, LineType::Occlusion | LineType::Boundary, 5);
    const Seen nodes{apart({wall, front})};
    expectCrossing(nodes.rightOf(2), 3.3, LineType::Occlusion | LineType::Boundary | LineType::Object, 5);
    EXPECT_EQ(nodes.rightOf(2).face.instance, 1U) << "of the nearer one";
}

TEST(TracedCrossings, areWhereASurfaceBends) {
    const Seen roof{together({sheet(-1, -4.3, 3.3, 0), sheet(3.3, 0, 9, -5.7)})};
    expectCrossing(roof.rightOf(2), 3.3, LineType::Crease, 0);
    const Seen valley{together({sheet(-1, 4.3, 3.3, 0), sheet(3.3, 0, 9, 5.7)})};
    expectCrossing(valley.rightOf(2), 3.3, LineType::Crease, 0);
}

TEST(TracedCrossings, areNoneWhereASurfaceGoesOn) {
    EXPECT_THAT(Seen{together({sheet(-1, 0, 9, 0)})}.row(2).columns, IsEmpty());
    const CrossingRow flat = Seen{together({sheet(-1, 0, 3.3, 0), sheet(3.3, 0, 9, 0.3)})}.row(2);
    for (const StepCrossing& crossing : flat.right) EXPECT_EQ(crossing.types, LineTypes{}) << "a slight bend";
    // Steep, so that neighbouring samples are more than a sample apart in depth.
    EXPECT_THAT(Seen{together({sheet(-1, -30, 9, 9)})}.row(2).columns, IsEmpty());
}

TEST(TracedCrossings, areWhereSurfacesRunThroughEachOther) {
    // z = 3.3 - x and z = 0.
    const Mesh falling = sheet(-1, 4.3, 9, -5.7);
    const Mesh level = sheet(-1, 0, 9, 0);
    expectCrossing(Seen{together({falling, level})}.rightOf(2), 3.3, LineType::Intersection, 0);
    const StepCrossing ofNodes = Seen{apart({level, falling})}.rightOf(2);
    expectCrossing(ofNodes, 3.3, LineType::Intersection | LineType::Object, 0);
    EXPECT_EQ(ofNodes.face.instance, 0U) << "neither ends: the first node";
}

TEST(TracedCrossings, ofASheetThatStandsOnASurfaceAreIntersections) {
    // A sheet falls towards the wall and ends: on it, or before it by some gap across it, in samples.
    const auto foot = [](double gap) {
        return Seen{apart({sheet(-1, 0, 9, 0), sheet(-1, 4.3 + gap, 3.3, gap)})}.rightOf(2);
    };
    for (const double gap : {0.0, 0.05}) {
        SCOPED_TRACE(gap);
        EXPECT_EQ(foot(gap).types, LineType::Intersection | LineType::Object);
        EXPECT_NEAR(foot(gap).position.x, 3.3, rounding);
        EXPECT_EQ(foot(gap).face.instance, 1U) << "of the one that ends there";
    }
    EXPECT_EQ(foot(0.6).types, LineType::Occlusion | LineType::Boundary | LineType::Object);
    EXPECT_NEAR(foot(0.6).position.x, 3.3, rounding);
}

TEST(TracedCrossings, ofASheetJustBeforeAnotherAreItsBorder) {
    const StepCrossing crossing = Seen{together({sheet(-1, 0, 9, 0), sheet(3.3, 0.5, 9, 0.5)})}.rightOf(2);
    expectCrossing(crossing, 3.3, LineType::Occlusion | LineType::Boundary, 0.5);
}

// A sheet over a wall that bends down at one column and ends at another.
Seen bentDown(double bend, double end) {
    return Seen{together({sheet(-1, -9, 9, -9), sheet(-1, 0, bend, 0), sheet(bend, 0, end, -3)})};
}

TEST(TracedCrossings, ofStripsThatNoSampleSeesAreBothLines) {
    const CrossingRow row = bentDown(3.6, 3.9).row(2);
    expectCrossing(row.rightStrips[3], 3.6, LineType::Crease, 0);
    EXPECT_NEAR(row.rightStrips[3].width, 0.3, rounding);
    EXPECT_EQ(row.right[3].types, LineType::Occlusion | LineType::Boundary);
    EXPECT_NEAR(row.right[3].position.x, 3.9, rounding);
    EXPECT_EQ(row.right[3].width, 1.0F);
}

TEST(TracedCrossings, ofStripsThatASampleSeesAreTheSame) {
    const CrossingRow row = bentDown(3.3, 3.8).row(2);
    expectCrossing(row.rightStrips[2], 3.3, LineType::Crease, 0);
    EXPECT_NEAR(row.rightStrips[2].width, 0.5, rounding);
    EXPECT_EQ(row.right[2].types, LineTypes{});
    EXPECT_EQ(row.right[3].types, LineType::Occlusion | LineType::Boundary);
    EXPECT_NEAR(row.right[3].position.x, 3.8, rounding);
    EXPECT_EQ(row.rightStrips[3].types, LineTypes{});
}

TEST(TracedCrossings, ofStripsOfASampleAreCreasesAsAnyOther) {
    const CrossingRow row = bentDown(3.3, 4.4).row(2);
    expectCrossing(row.right[2], 3.3, LineType::Crease, 0);
    EXPECT_EQ(row.right[2].width, 1.0F);
    for (const StepCrossing& crossing : row.rightStrips) EXPECT_EQ(crossing.types, LineTypes{});
}

TEST(TracedCrossings, markTheTypesOfTheNearerSample) {
    const Seen seen{together({sheet(-1, 0, 9, 0), sheet(3.3, 5, 9, 5)})};
    CrossingTracer tracer = seen.tracer();
    CrossingRow row{size.width};
    tracer.traceRow(2, row);
    const Image<std::uint16_t> types = tracer.takeTypes();
    for (int x = 0; x < size.width; ++x) {
        const LineTypes expected = x == 3 ? LineType::Occlusion | LineType::Boundary : LineTypes{};
        EXPECT_EQ(types(x, 2), expected.bits()) << x;
        EXPECT_EQ(types(x, 3), 0) << "a row that was not traced";
    }
}

TEST(TracedCrossings, ofTheRowBeforeAreCleared) {
    const Seen seen{together({scenes::quad(at(3.3, 2.7, 0), at(9, 2.7, 0), at(9, -1, 0), at(3.3, -1, 0))})};
    CrossingTracer tracer = seen.tracer();
    CrossingRow row{size.width};
    tracer.traceRow(2, row);
    EXPECT_THAT(row.columns, ElementsAre(2, 3, 4, 5, 6, 7)) << "ascending";
    tracer.traceRow(3, row);
    EXPECT_THAT(row.columns, IsEmpty());
    for (int x = 0; x < size.width; ++x) {
        EXPECT_EQ(row.right[static_cast<std::size_t>(x)].types, LineTypes{});
        EXPECT_EQ(row.down[static_cast<std::size_t>(x)].types, LineTypes{});
    }
}

}  // namespace
}  // namespace inkedge::trace
