// STEP, IGES and BREP to meshes: shapes whose every point is known.
#include <array>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include "formats/cad/cad_scenes.h"
#include "formats/cad/lost_nodes.h"
#include "scene/prepared.h"

namespace inkedge::cad {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

double volumeOf(const Mesh& mesh) {
    double sum = 0.0;
    for (std::size_t c = 0; c < mesh.indices.size(); c += 3)
        sum += glm::dot(position(mesh, c), glm::cross(position(mesh, c + 1), position(mesh, c + 2)));
    return sum / 6.0;
}

// Of each kind, the length of the edges between the file's faces; of an edge that two triangles share, half on each.
std::map<EdgeKind, double> lengthsOf(const Scene& scene) {
    std::map<EdgeKind, double> lengths;
    const Mesh& mesh = scene.meshes().front();
    const mesh::MeshTopology& topology = scene::topologyOf(scene, 0);
    for (std::uint32_t h = 0; h < mesh.indices.size(); ++h) {
        const double length = glm::distance(position(mesh, h), position(mesh, mesh::nextHalfEdge(h)));
        for (const EdgeKind kind : {EdgeKind::Sharp, EdgeKind::Tangent, EdgeKind::Free})
            if (mesh.edges[h].has(kind)) lengths[kind] += mesh::isHalfEdge(topology.twins[h]) ? 0.5 * length : length;
    }
    return lengths;
}

// ---- forms and units

TEST(LoadCad, readsEveryForm) {
    const std::vector<std::pair<std::string, std::string>> forms{
        {cad_files::step(Shape::Box, "AP203"), "a.stp"},
        {cad_files::step(Shape::Box, "AP214IS"), "b.STEP"},
        {cad_files::step(Shape::Box, "AP242DIS"), "c.p21"},
        {cad_files::step(Shape::Box), "named_otherwise.obj"},
        {cad_files::iges(Shape::Box), "d.igs"},
        {cad_files::iges(Shape::Box), "e.iges"},
        {cad_files::brep(Shape::Box), "f.brep"},
    };
    for (const auto& [text, name] : forms) {
        SCOPED_TRACE(name);
        const Scene scene = sceneOf(text, name);
        expectBox(scene, {0, 0, 0}, {10, 20, 30});
        EXPECT_EQ(scene.source().unit, LengthUnit::Millimetre);
        EXPECT_EQ(scene.up(), glm::dvec3(0, 0, 1));
        EXPECT_THAT(scene.warnings(), IsEmpty());
        ASSERT_EQ(scene.meshes().size(), 1U);
        EXPECT_NEAR(volumeOf(scene.meshes().front()), 6000.0, 1e-3) << "faces are wound outward";
        EXPECT_NEAR(lengthsOf(scene)[EdgeKind::Sharp], 240.0, 1e-3);
    }
}

TEST(LoadCad, givesMillimetresWhateverTheUnit) {
    for (const auto& [unit, millimetres] : std::map<std::string, double>{{"MM", 1.0}, {"M", 1000.0}, {"INCH", 25.4}})
        expectBox(sceneOf(cad_files::step(Shape::Box, "AP214IS", unit), "part.step"), {0, 0, 0},
                  millimetres * glm::dvec3{10, 20, 30});
}

// ---- surfaces

TEST(LoadCad, hasExactPositionsAndNormals) {
    for (const Known& known : known()) {
        SCOPED_TRACE(static_cast<int>(known.shape));
        const Scene scene = sceneOf(known.shape);
        const Mesh& mesh = scene.meshes().front();
        for (std::size_t c = 0; c < mesh.indices.size(); ++c) {
            const glm::dvec3 p = position(mesh, c);
            EXPECT_NEAR(known.distance(p), 0.0, 1e-5);
            const glm::dvec3 own{mesh.normals[mesh.indices[c]]};
            EXPECT_NEAR(glm::length(own), 1.0, 1e-5);
            const std::size_t t = c - c % 3;
            const glm::dvec3 face =
                glm::cross(position(mesh, t + 1) - position(mesh, t), position(mesh, t + 2) - position(mesh, t));
            if (glm::length(known.normal(p)) > 0.5) {  // where there is one
                EXPECT_GT(glm::dot(own, face), 0.0) << "triangles are wound as their normals point";
            }
            if (!isOnEdge(known.shape, p)) {
                EXPECT_GT(glm::dot(own, known.normal(p)), 1.0 - 1e-6);
            }
        }
    }
}

TEST(LoadCad, hasTheSideOfACone) {
    const Scene scene = sceneOf(Shape::Cone);
    const Mesh& mesh = scene.meshes().front();
    int atApex = 0;
    for (std::size_t c = 0; c < mesh.indices.size(); ++c) {
        const glm::dvec3 n{mesh.normals[mesh.indices[c]]};
        if (n.z < -0.999) continue;  // its base
        EXPECT_NEAR(n.z, 0.6, 1e-5) << "the apex has the normals of the sides beside it";
        if (position(mesh, c).z > 8.0 - 1e-6) ++atApex;
        const std::size_t t = c - c % 3;
        EXPECT_FALSE(position(mesh, t) == position(mesh, t + 1) || position(mesh, t + 1) == position(mesh, t + 2) ||
                     position(mesh, t + 2) == position(mesh, t));
    }
    EXPECT_GT(atApex, 8);
}

TEST(LoadCad, turnsWhatIsMovedAndMirrored) {
    const Scene moved = sceneOf(cad_files::brep(Shape::Moved), "moved.brep");
    constexpr double chord = 2e-3;  // what polygons miss of circles
    expectNear(moved.box().min, {100, -5, -5}, chord);
    expectNear(moved.box().max, {112, 5, 5}, chord);
    EXPECT_NEAR(volumeOf(moved.meshes().front()), 300.0 * std::numbers::pi, 0.01 * 300.0 * std::numbers::pi);
    const Scene mirrored = sceneOf(Shape::Mirrored);
    expectBox(mirrored, {-10, 0, 0}, {0, 20, 30});
    EXPECT_NEAR(volumeOf(mirrored.meshes().front()), 6000.0, 1e-3);
}

TEST(LoadCad, knowsTheSurfaceUnderEveryVertex) {
    for (const Shape shape : {Shape::Box, Shape::Cylinder, Shape::Cone, Shape::Sphere, Shape::Torus, Shape::SplineTorus,
                              Shape::SplineHalves, Shape::SplineCone, Shape::Extruded, Shape::Revolved, Shape::Moved,
                              Shape::OffsetTorus, Shape::ScaledTorus}) {
        SCOPED_TRACE(static_cast<int>(shape));
        const Scene scene = sceneOf(cad_files::brep(shape), "part.brep", ofSmallPicture());
        const Mesh& mesh = scene.meshes().front();
        ASSERT_NE(mesh.surfaces, nullptr);
        ASSERT_EQ(mesh.parameters.size(), mesh.positions.size());
        constexpr double step = 1e-5;
        for (std::uint32_t c = 0; c < mesh.indices.size(); ++c) {
            const auto triangle = mesh.surfaces->under(mesh, c / 3);
            ASSERT_TRUE(triangle);
            glm::dvec3 uv = triangle->corners[c % 3];
            for (int i = 0; i < 2; ++i)
                if (std::isnan(uv[i])) uv[i] = 0.25;  // any
            const SurfacePoint point = mesh.surfaces->at(triangle->face, uv);
            expectNear(point.position, position(mesh, c), 1e-5);
            if (glm::length(point.normal) > 1e-6) {
                EXPECT_GT(std::abs(glm::dot(glm::normalize(point.normal), glm::dvec3{mesh.normals[mesh.indices[c]]})),
                          1 - 1e-6);
            }
            if (c % 17 != 0) continue;  // for speed
            const auto difference = [&](glm::dvec3 by, auto&& of) {
                return (of(mesh.surfaces->at(triangle->face, uv + by)) -
                        of(mesh.surfaces->at(triangle->face, uv - by))) /
                       (2.0 * step);
            };
            const glm::dvec3 u{step, 0.0, 0.0};
            const glm::dvec3 v{0.0, step, 0.0};
            if (shape == Shape::Extruded || shape == Shape::Revolved || shape == Shape::SplineTorus ||
                shape == Shape::SplineHalves || shape == Shape::SplineCone || shape == Shape::OffsetTorus)
                continue;  // pieces of splines end where the nodes are
            const auto own = [](const SurfacePoint& p) { return p.position; };
            const auto across = [](const SurfacePoint& p) { return p.normal; };
            expectNear(point.du, difference(u, own), 1e-4);
            expectNear(point.dv, difference(v, own), 1e-4);
            expectNear(point.normalDu, difference(u, across), 1e-4);
            expectNear(point.normalDv, difference(v, across), 1e-4);
        }
    }
}

// ---- kinds of edges, and patches

TEST(LoadCad, hasTheKindsOfEdgesFromTheModel) {
    const double rim = 2.0 * std::numbers::pi * 5.0;
    const auto lengths = [](Shape shape) { return lengthsOf(sceneOf(shape)); };
    constexpr double chords = 0.02;  // polygons are shorter than their circles
    for (const Shape shape : {Shape::Cylinder, Shape::Halves, Shape::SplineHalves}) {
        SCOPED_TRACE(static_cast<int>(shape));
        EXPECT_NEAR(lengths(shape)[EdgeKind::Sharp], 2.0 * rim, chords * rim);
        EXPECT_EQ(lengths(shape)[EdgeKind::Tangent], 0.0) << "one surface has no line in it";
        EXPECT_EQ(lengths(shape)[EdgeKind::Free], 0.0);
    }
    for (const Shape shape : {Shape::Sphere, Shape::Torus, Shape::SplineTorus})
        EXPECT_THAT(lengths(shape), testing::Each(testing::Pair(testing::_, 0.0)));
    for (const Shape shape : {Shape::Cone, Shape::SplineCone})
        EXPECT_NEAR(lengths(shape)[EdgeKind::Sharp], 2.0 * std::numbers::pi * 6.0, 0.5);
    auto rounded = lengths(Shape::Rounded);
    EXPECT_NEAR(rounded[EdgeKind::Tangent], 8.0 * 30.0, 1e-3);
    EXPECT_NEAR(rounded[EdgeKind::Sharp], 2.0 * (2.0 * 6.0 + 2.0 * 16.0 + 4.0 * std::numbers::pi), 0.1);
    auto open = lengths(Shape::OpenBox);
    EXPECT_NEAR(open[EdgeKind::Free], 60.0, 1e-3);
    EXPECT_NEAR(open[EdgeKind::Sharp], 180.0, 1e-3);
}

TEST(LoadCad, hasAPatchForFacesThatGoOnIntoEachOther) {
    const std::map<Shape, std::uint32_t> patches{{Shape::Box, 6},        {Shape::Cylinder, 3}, {Shape::Halves, 3},
                                                 {Shape::Rounded, 3},    {Shape::Sphere, 1},   {Shape::Cone, 2},
                                                 {Shape::SplineCone, 2}, {Shape::Torus, 1},    {Shape::SplineTorus, 1}};
    for (const auto& [shape, count] : patches)
        EXPECT_EQ(scene::patchNumbersOf(sceneOf(shape)).count, count) << static_cast<int>(shape);
}

TEST(LoadCad, joinsFacesThatShareNoEdge) {
    for (const Scene& scene : {sceneOf(cad_files::iges(Shape::Pieces), "part.igs"), sceneOf(Shape::Pieces)}) {
        EXPECT_NEAR(volumeOf(scene.meshes().front()), 6000.0, 1e-2);
        auto lengths = lengthsOf(scene);
        EXPECT_NEAR(lengths[EdgeKind::Sharp], 240.0, 1e-2);
        EXPECT_EQ(lengths[EdgeKind::Free], 0.0);
    }
}

TEST(LoadCad, mendsAFaceOfManyHolesOfWhichTwoCross) {
    const Scene scene = sceneOf(Shape::ManyHoles);
    ASSERT_EQ(scene.meshes().size(), 1U);
    constexpr double squares = 64.0 * 16.0;
    const double both = 2.0 * std::numbers::pi * 64.0 - (128.0 * std::acos(0.625) - 5.0 * std::sqrt(156.0));
    constexpr double chords = 10.0;  // what polygons miss of both circles
    EXPECT_NEAR(areaOf(scene.meshes().front()), 10'000.0 - squares - both, chords);
    EXPECT_THAT(scene.warnings(), IsEmpty());
}

TEST(EdgeTable, bearsNodesThatAreLost) {
    const cad_files::LostNodes found = cad_files::boxOfLostNodes();
    EXPECT_EQ(found.borders, 23) << "12 edges on two faces each, but for one";
    EXPECT_EQ(found.onOther, EdgeKind::Sharp) << "it is no free end of the surface";
}

// ---- assemblies

TEST(LoadCad, hasAssembliesWithNamesColoursAndSharedParts) {
    const Scene scene = sceneOf(cad_files::assembly(), "table.step");
    expectBox(scene, {0, 0, 0}, {22, 2, 11});
    ASSERT_EQ(scene.meshes().size(), 2U);
    ASSERT_EQ(scene.instances().size(), 3U);
    EXPECT_EQ(scene.meshes()[0].name, "leg");
    EXPECT_EQ(scene.meshes()[1].name, "plate");
    std::vector<std::string> names;
    std::vector<std::uint32_t> meshes;
    for (const Instance& instance : scene.instances()) {
        names.push_back(instance.name);
        meshes.push_back(instance.mesh);
        EXPECT_EQ(scene.nodes()[scene.nodes()[instance.node].parent].name, "table");
    }
    EXPECT_THAT(names, ElementsAre("leg one", "leg two", "plate"));
    EXPECT_THAT(meshes, ElementsAre(0, 0, 1));
    EXPECT_EQ(glm::dvec3{scene.instances()[1].transform[3]}, glm::dvec3(20, 0, 0));
    const auto colours = [&](const Mesh& mesh) {
        std::set<std::array<float, 3>> all;
        for (const std::uint32_t material : mesh.materials) {
            const glm::vec4 c = scene.materials().at(material - 1).color;
            all.insert({std::round(c.r), std::round(c.g), std::round(c.b)});
        }
        return all;
    };
    EXPECT_THAT(colours(scene.meshes()[0]), ElementsAre(std::array{1.F, 0.F, 0.F}));
    EXPECT_THAT(colours(scene.meshes()[1]), ElementsAre(std::array{0.F, 0.F, 1.F}, std::array{0.F, 1.F, 0.F}));
}

TEST(LoadCad, countsWhatHasNoFacesInOneWarning) {
    const Scene scene = sceneOf(cad_files::brep(Shape::CurvesAndPoint), "part.brep");
    EXPECT_THAT(scene.warnings(), ElementsAre("not drawn: 2 curves, 1 point"));
}

TEST(LoadCad, mirrorsAndScalesMappedItems) {
    expectBox(sceneOf(mapped("$,$,#9023,1.,$"), "moved.step"), {-5, 0, 0}, {10, 20, 30});
    const Scene mirrored = sceneOf(mapped("#9021,#9022,#9023,1.,#9012"), "mirrored.step");
    expectBox(mirrored, {-15, 0, 0}, {10, 20, 30});
    EXPECT_EQ(mirrored.meshes().size(), 1U);
    expectBox(sceneOf(mapped("$,$,#9023,2.,$"), "scaled.step"), {-5, 0, 0}, {15, 40, 60});
}

TEST(LoadCad, isNotSubdivided) {
    LoadSettings settings;
    const std::uint64_t before = sceneOf(Shape::Cylinder, settings).triangleCount();
    settings.subdivide = 2;
    const Scene scene = sceneOf(Shape::Cylinder, settings);
    EXPECT_EQ(scene.triangleCount(), before);
    EXPECT_THAT(scene.warnings(), ElementsAre(HasSubstr("is not subdivided")));
}

}  // namespace
}  // namespace inkedge::cad
