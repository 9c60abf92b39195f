#include "lines/find/contour_finders.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <random>

#include <gmock/gmock.h>

#include <inkedge/error.h>
#include <inkedge/load_scene.h>

#include "lines/object_lines.h"
#include "scene/prepared.h"
#include "scenes.h"

namespace inkedge::lines {
namespace {

using namespace scenes;
using testing::HasSubstr;
using testing::IsEmpty;

using Edges = std::vector<std::uint32_t>;

struct Searched {
    explicit Searched(Scene whole, std::size_t mesh = 0)
        : scene{std::move(whole)},
          number{mesh},
          edges{findEdges(scene.meshes()[mesh], scene::topologyOf(scene, mesh), scene.creaseAngle())},
          search{std::make_unique<ContourSearch>(scene.meshes()[mesh], scene::topologyOf(scene, mesh), edges)} {}
    Searched(const Searched&) = delete;
    Searched& operator=(const Searched&) = delete;

    [[nodiscard]] Edges find(const MeshEye& eye, ContourFinder finder) const {
        ContourMemory memory;
        return search->find(eye, finder, memory).edges;
    }

    // By the definition, an edge at a time.
    [[nodiscard]] Edges expected(const MeshEye& eye) const {
        enum { Back, Front, EdgeOn };
        const auto facing = [&](std::uint32_t t) {
            const glm::dvec3 view = viewOf(eye, 3 * t);
            const double height = glm::dot(edges.faceNormals[t], view);
            const bool edgeOn = edges.faceNormals[t] != glm::dvec3{0.0} &&
                                std::abs(height) <= double{edges.edgeOnSines[t]} * glm::length(view);
            return edgeOn ? EdgeOn : height < 0.0 ? Front : Back;
        };
        Edges found;
        for (std::uint32_t e = 0; e < edges.shared.halfEdges.size(); ++e) {
            const std::uint32_t first = edges.shared.faces[2 * e];
            const std::uint32_t second = edges.shared.faces[2 * e + 1];
            const bool differ = facing(first) != facing(second);
            const std::uint32_t edgeOn = facing(first) == EdgeOn ? first : second;
            const bool contour = facing(edgeOn) == EdgeOn ? differ && isBehind(eye, edgeOn, edges.shared.halfEdges[e])
                                                          : differ != (edges.shared.against[e] != 0);
            if (contour) found.push_back(e);
        }
        return found;
    }

    [[nodiscard]] glm::dvec3 corner(std::uint32_t c) const {
        const Mesh& mesh = scene.meshes()[number];
        return glm::dvec3{mesh.positions[mesh.indices[c]]};
    }
    [[nodiscard]] glm::dvec3 viewOf(const MeshEye& eye, std::uint32_t c) const {
        return eye.orthographic ? eye.direction : corner(c) - eye.position;
    }

    // Whether a face, at right angles to an edge, goes on away from the eye.
    [[nodiscard]] bool isBehind(const MeshEye& eye, std::uint32_t t, std::uint32_t halfEdge) const {
        const glm::dvec3 along = glm::normalize(corner(mesh::nextHalfEdge(halfEdge)) - corner(halfEdge));
        const glm::dvec3 middle = (corner(3 * t) + corner(3 * t + 1) + corner(3 * t + 2)) / 3.0 - corner(halfEdge);
        const glm::dvec3 view = viewOf(eye, halfEdge);
        return glm::dot(middle, view) - glm::dot(middle, along) * glm::dot(along, view) >= 0.0;
    }

    [[nodiscard]] double lengthOf(const Edges& some) const {
        const Mesh& mesh = scene.meshes()[number];
        double sum = 0.0;
        for (const std::uint32_t e : some) {
            const std::uint32_t h = edges.shared.halfEdges[e];
            sum += double{
                glm::distance(mesh.positions[mesh.indices[h]], mesh.positions[mesh.indices[mesh::nextHalfEdge(h)]])};
        }
        return sum;
    }

    Scene scene;
    std::size_t number;
    MeshEdges edges;
    std::unique_ptr<ContourSearch> search;
};

MeshEye from(glm::dvec3 position) { return {false, position, {}}; }
MeshEye along(glm::dvec3 direction) { return {true, {}, direction}; }

// Along the axes, where flat models have faces seen exactly from their side, and at random.
std::vector<glm::dvec3> directions() {
    std::vector<glm::dvec3> all{{1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {1, 1, 0}, {0, -1, 1}, {1, -1, 1}};
    std::mt19937 numbers{7};
    const auto next = [&] { return static_cast<double>(numbers()) / 2147483648.0 - 1.0; };
    for (int i = 0; i < 12; ++i) all.push_back(100.0 * glm::dvec3{next(), next(), next()});
    return all;
}

// Triangles between random points: edges of one, two and many faces, wound anyhow; some collapsed.
Mesh randomTriangles(unsigned seed, std::size_t triangles, float scale = 1.0F) {
    std::mt19937 numbers{seed};
    Mesh mesh;
    mesh.name = "random triangles";
    for (std::size_t i = 0; i < triangles / 2; ++i) {
        const auto next = [&] { return scale * (static_cast<float>(numbers() % 2048) / 1024.0F - 1.0F); };
        mesh.positions.emplace_back(next(), next(), next());
    }
    for (std::size_t i = 0; i < 3 * triangles; ++i)
        mesh.indices.push_back(static_cast<std::uint32_t>((i / 3 / 2 + numbers() % 5) % mesh.positions.size()));
    return mesh;
}

// A closed mesh of hills and hollows, with loops of contour large and small.
Mesh hills(std::uint32_t segments) {
    Mesh mesh = sphere(1.0, segments);
    for (glm::vec3& p : mesh.positions)
        p *= 1.0F + 0.06F * std::sin(9.0F * p.x) * std::cos(7.0F * p.y) * std::sin(8.0F * p.z);
    mesh.normals.clear();
    return mesh;
}

Mesh everyOtherFaceTurned(Mesh mesh) {
    for (std::size_t i = 0; i < mesh.indices.size(); i += 6) mesh::turnOver(mesh, i);
    return mesh;
}

// A strip with faces too thin to have a normal between the others.
Mesh withThinFaces() {
    Mesh mesh;
    mesh.name = "thin";
    for (int i = 0; i < 20; ++i) {
        const double angle = 0.3 * i;
        for (const double gap : {0.0, 1e-9})
            for (const double y : {0.0, 1.0})
                mesh.positions.emplace_back(std::sin(angle + gap), y, std::cos(angle + gap));
    }
    for (std::uint32_t i = 0; i + 3 < mesh.positions.size(); i += 2)
        mesh.indices.insert(mesh.indices.end(), {i, i + 1, i + 2, i + 2, i + 1, i + 3});
    return mesh;
}

std::vector<std::filesystem::path> assets() {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator{INKEDGE_SOURCE_DIR "/assets"})
        if (entry.path().extension() == ".glb") files.push_back(entry.path());
    std::ranges::sort(files);
    return files;
}

void expectTheDefinition(const Searched& model, const std::string& name) {
    const double reach = 2.5 * model.scene.bounds().radius;
    for (const glm::dvec3& direction : directions()) {
        SCOPED_TRACE(testing::Message() << name << " along " << direction.x << ' ' << direction.y << ' '
                                        << direction.z);
        const MeshEye near = from(-reach * glm::normalize(direction));
        const MeshEye far = from(-1e6 * reach * glm::normalize(direction));
        EXPECT_EQ(model.find(near, ContourFinder::Every), model.expected(near));
        EXPECT_EQ(model.find(far, ContourFinder::Every), model.expected(far));
        EXPECT_EQ(model.find(along(direction), ContourFinder::Every), model.expected(along(direction)));
        EXPECT_EQ(model.find(along(direction), ContourFinder::Gauss), model.expected(along(direction)));
    }
}

TEST(ContourFinders, EveryAndGaussFindWhatTheDefinitionSaysOnAssets) {
    ASSERT_FALSE(assets().empty());
    for (const auto& file : assets()) {
        const Scene scene = loadScene(file);
        for (std::size_t mesh = 0; mesh < std::min<std::size_t>(scene.meshes().size(), 3); ++mesh)
            expectTheDefinition(Searched{scene, mesh}, file.filename().string());
    }
}

TEST(ContourFinders, EveryAndGaussFindWhatTheDefinitionSaysOnAnyMesh) {
    for (unsigned seed = 0; seed < 20; ++seed)
        expectTheDefinition(Searched{sceneOf(randomTriangles(seed, 60 + 40 * seed))},
                            "random triangles " + std::to_string(seed));
    expectTheDefinition(Searched{sceneOf(cube())}, "cube");
    expectTheDefinition(Searched{sceneOf(hills(64))}, "hills");
    expectTheDefinition(Searched{sceneOf(everyOtherFaceTurned(hills(64)))}, "every other face turned");
    expectTheDefinition(Searched{sceneOf(withThinFaces())}, "thin faces");
}

TEST(ContourFinders, FindTheSameFromInsideAFacesPlane) {
    const Searched model{sceneOf(cube())};
    for (const glm::dvec3 position :
         {glm::dvec3{1, 5, 5}, glm::dvec3{7, -1, 1}, glm::dvec3{1, 1, 1}, glm::dvec3{0, 0, 0}})
        EXPECT_EQ(model.find(from(position), ContourFinder::Every), model.expected(from(position)));
}

TEST(ContourFinders, FindTheSameInSmallAndLargeUnits) {
    for (const float scale : {1e-15F, 1e-6F, 1e6F, 1e15F})
        expectTheDefinition(Searched{sceneOf(randomTriangles(3, 400, scale))}, "scaled by " + std::to_string(scale));
}

TEST(ContourFinders, GiveNothingForAMeshWithoutSharedEdges) {
    Mesh triangle;
    triangle.name = "triangle";
    triangle.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    triangle.indices = {0, 1, 2};
    const Searched model{sceneOf(triangle)};
    EXPECT_THAT(model.find(along({0, 0, -1}), ContourFinder::Every), IsEmpty());
    EXPECT_THAT(model.find(along({0, 0, -1}), ContourFinder::Gauss), IsEmpty());
    EXPECT_THAT(model.find(along({0, 0, -1}), ContourFinder::Random), IsEmpty());
}

TEST(ContourFinders, RandomFindsNearlyAllOfATurntableAndNothingElse) {
    for (const Mesh& mesh : {hills(192), everyOtherFaceTurned(hills(192))}) {
        const Searched model{sceneOf(mesh)};
        ContourMemory memory;
        double found = 0.0;
        double expected = 0.0;
        for (int view = 0; view < 60; ++view) {
            const double angle = 0.05 * view;
            const MeshEye eye = from(4.0 * glm::dvec3{std::sin(angle), 0.3, std::cos(angle)});
            const Edges all = model.expected(eye);
            const Edges some = model.search->find(eye, ContourFinder::Random, memory).edges;
            EXPECT_TRUE(std::ranges::is_sorted(some));
            EXPECT_TRUE(std::ranges::includes(all, some)) << "view " << view;
            found += model.lengthOf(some);
            expected += model.lengthOf(all);
        }
        // The share that the finder promises.
        EXPECT_LT(1.0 - found / expected, 0.01);
    }
}

TEST(ContourFinders, RandomFindsNearlyAllOfAFirstView) {
    const Searched model{sceneOf(hills(192))};
    for (const glm::dvec3& direction : directions()) {
        const double expected = model.lengthOf(model.expected(along(direction)));
        EXPECT_GT(model.lengthOf(model.find(along(direction), ContourFinder::Random)), 0.9 * expected);
    }
}

TEST(ContourFinders, RandomRepeatsItself) {
    const Searched model{sceneOf(hills(128))};
    const Searched again{sceneOf(hills(128))};
    ContourMemory memory;
    ContourMemory other;
    for (const glm::dvec3& direction : directions()) {
        const auto once = model.search->find(along(direction), ContourFinder::Random, memory).edges;
        EXPECT_FALSE(once.empty());
        EXPECT_EQ(once, again.search->find(along(direction), ContourFinder::Random, other).edges);
    }
}

TEST(ContourFinders, GaussLooksAtAFewEdgesOnly) {
    const Searched model{sceneOf(hills(192))};
    const GaussMap map{model.edges};
    for (const glm::dvec3& direction : directions()) {
        Edges near;
        map.findNear(direction, near);
        // A hundredth are contours; an arc's cell is up to four times as wide as the arc.
        EXPECT_FALSE(near.empty());
        EXPECT_LT(near.size(), model.edges.shared.halfEdges.size() / 5);
    }
}

TEST(ContourFinders, GaussRefusesAPerspectiveEye) {
    const Searched model{sceneOf(cube())};
    try {
        (void)model.find(from({0, 0, 5}), ContourFinder::Gauss);
        FAIL() << "expected an Error";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), Error::Kind::Usage);
        EXPECT_THAT(error.what(), HasSubstr("--contour-finder: expected an orthographic camera for gauss"));
    }
}

TEST(ContourFinders, LeaveTheLinesOfAViewAsTheyAre) {
    const glm::dmat4 mirrored = scaling({-1, 1, 1.5});
    const Scene scene = sceneOf({{box({1, 2, 3}), mirrored}, {hills(48), translation({2.5, 0, 0})}});
    const ObjectLines object{scene};
    Settings settings;
    settings.camera.orthographicHeight = 0.0;
    settings.camera.direction = glm::dvec3{-0.4, -0.5, -1.0};
    const auto lines = [&](ContourFinder finder) {
        settings.lines.contourFinder = finder;
        return object.find(frameCamera(scene, settings.camera, settings.picture.size), settings).lines;
    };
    const auto every = lines(ContourFinder::Every);
    const auto gauss = lines(ContourFinder::Gauss);
    ASSERT_FALSE(every.empty());
    ASSERT_EQ(every.size(), gauss.size());
    for (std::size_t i = 0; i < every.size(); ++i) {
        EXPECT_EQ(every[i].type, gauss[i].type);
        ASSERT_EQ(every[i].points.size(), gauss[i].points.size());
        for (std::size_t k = 0; k < every[i].points.size(); ++k)
            EXPECT_EQ(every[i].points[k].position, gauss[i].points[k].position);
    }
}

}  // namespace
}  // namespace inkedge::lines
