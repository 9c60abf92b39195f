#include "mesh/subdivide.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <glm/geometric.hpp>

#include "mesh/control_meshes.h"
#include "mesh/topology.h"
#include "scenes.h"

namespace inkedge::mesh {
namespace {

using namespace control_meshes;

// A cube whose faces each are the whole texture, with a vertex for each corner of each triangle.
Mesh texturedCube() {
    const Mesh whole = quadCube();
    Mesh mesh;
    mesh.edges = whole.edges;
    for (std::uint32_t i = 0; i < whole.indices.size(); ++i) {
        mesh.positions.push_back(whole.positions[whole.indices[i]]);
        mesh.indices.push_back(i);
    }
    for (int face = 0; face < 6; ++face)
        mesh.textureCoordinates.insert(mesh.textureCoordinates.end(), {{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}});
    return mesh;
}

double textureArea(const Mesh& mesh, std::size_t t) {
    const auto at = [&](std::size_t k) { return glm::dvec2{mesh.textureCoordinates[mesh.indices[3 * t + k]]}; };
    const glm::dvec2 a = at(1) - at(0);
    const glm::dvec2 b = at(2) - at(0);
    return 0.5 * (a.x * b.y - a.y * b.x);
}

TEST(Subdivide, cutsTextureCoordinatesEvenlyAndLeavesSeamsWhereTheyAre) {
    for (const Mesh& cube : {texturedCube(), asTriangles(texturedCube())}) {
        for (const double creaseAngle : {30.0, smoothAngle}) {
            const Scene scene = refined(cube, levels(2, creaseAngle));
            const Mesh& mesh = scene.meshes()[0];
            ASSERT_EQ(mesh.textureCoordinates.size(), mesh.positions.size());
            // Of each face's one, 16 squares of two triangles, or 2 triangles of 16: all of one size, in exact binary.
            for (std::size_t t = 0; t < mesh.indices.size() / 3; ++t) EXPECT_EQ(textureArea(mesh, t), 1.0 / 32);
        }
    }
}

// Colours are a function of the position; each face's picture is its own, so that uvs have seams at every edge.
Mesh paintedCube() {
    Mesh mesh = texturedCube();
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const glm::vec3 share = 0.5F * (mesh.positions[i] + 1.0F);
        mesh.paint.push_back({{share, share.x * share.y * share.z}, 2.0F * mesh.textureCoordinates[i]});
    }
    return mesh;
}

TEST(Subdivide, mixesColoursLinearlyAcrossTheFacesThatWere) {
    for (const Mesh& cube : {paintedCube(), asTriangles(paintedCube())}) {
        const Scene scene = refined(cube, levels(2));  // stays a cube
        const Mesh& mesh = scene.meshes()[0];
        ASSERT_EQ(mesh.paint.size(), mesh.positions.size());
        for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
            const glm::vec3 share = 0.5F * (mesh.positions[i] + 1.0F);
            const glm::vec4 color = mesh.paint[i].color;
            EXPECT_LT(glm::distance(glm::vec3{color}, share), 1e-6F) << i;  // of floats of size 1
            if (cube.edges.empty()) continue;
            EXPECT_NEAR(color.a, share.x * share.y * share.z, 1e-6F) << "bilinear across squares";
        }
    }
}

TEST(Subdivide, mixesColoursAlikeHoweverFacesBend) {
    for (const Mesh& cube : {paintedCube(), asTriangles(paintedCube())}) {
        const Mesh sharp = refined(cube, levels(2)).meshes()[0];
        const Mesh round = refined(cube, levels(2, smoothAngle)).meshes()[0];
        ASSERT_EQ(sharp.indices.size(), round.indices.size());
        ASSERT_EQ(sharp.paint.size(), sharp.positions.size());
        ASSERT_EQ(round.paint.size(), round.positions.size());
        for (std::size_t c = 0; c < sharp.indices.size(); ++c) {
            EXPECT_EQ(sharp.paint[sharp.indices[c]].color, round.paint[round.indices[c]].color);
            EXPECT_EQ(sharp.paint[sharp.indices[c]].uv, round.paint[round.indices[c]].uv);
        }
    }
}

TEST(Subdivide, keepsTheUvsOfPicturesWithTheirSeams) {
    for (Mesh cube : {paintedCube(), asTriangles(paintedCube())}) {
        for (const bool coordinates : {true, false}) {
            if (!coordinates) cube.textureCoordinates.clear();
            const Mesh mesh = refined(cube, levels(2, smoothAngle)).meshes()[0];
            ASSERT_EQ(mesh.paint.size(), mesh.positions.size());
            EXPECT_EQ(mesh.textureCoordinates.size(), coordinates ? mesh.positions.size() : 0U);
            for (std::size_t t = 0; t < mesh.indices.size() / 3; ++t) {
                const auto at = [&](std::size_t k) { return glm::dvec2{mesh.paint[mesh.indices[3 * t + k]].uv}; };
                const glm::dvec2 a = at(1) - at(0);
                const glm::dvec2 b = at(2) - at(0);
                EXPECT_EQ(0.5 * (a.x * b.y - a.y * b.x), 4.0 / 32) << "of each face's 2 x 2, evenly";
            }
        }
    }
}

TEST(Subdivide, givesTheKindsOfEdgesToWhatTheyAreCutInto) {
    for (const Mesh& plain : {quadCube(), asTriangles(quadCube())}) {
        Mesh cube = plain;
        cube.edges.resize(cube.indices.size());
        cube.edges[0] |= EdgeKind::Marked | EdgeKind::Free;  // on one of its faces only
        const glm::dvec3 from{cube.positions[cube.indices[0]]};
        const glm::dvec3 to{cube.positions[cube.indices[1]]};
        const Scene scene = refined(cube, levels(2));
        const Mesh& mesh = scene.meshes()[0];
        ASSERT_EQ(mesh.edges.size(), mesh.indices.size());
        EXPECT_EQ(std::ranges::count(scenes::edgesOfKind(mesh, EdgeKind::Marked), true), 8)
            << "four parts, each on two faces";
        EXPECT_EQ(scenes::edgesOfKind(mesh, EdgeKind::Free), scenes::edgesOfKind(mesh, EdgeKind::Marked));
        for (std::uint32_t h = 0; h < mesh.indices.size(); ++h) {
            if (!mesh.edges[h].has(EdgeKind::Marked)) continue;
            const glm::dvec3 at{mesh.positions[mesh.indices[h]]};
            EXPECT_NEAR(glm::length(glm::cross(at - from, to - from)), 0.0, 1e-6) << "a cube's edges are sharp";
        }
    }
}

TEST(Subdivide, givesTheNumbersOfFacesToWhatTheyAreCutInto) {
    for (const std::size_t perFace : {1U, 2U}) {
        Mesh cube = perFace == 2 ? quadCube() : asTriangles(quadCube());
        for (std::uint32_t t = 0; t < 12; ++t) cube.faces.push_back(100 + t / 2);
        const Mesh mesh = refined(cube, levels(1)).meshes()[0];
        ASSERT_EQ(mesh.faces.size(), mesh.indices.size() / 3);
        for (std::uint32_t face = 100; face < 106; ++face) EXPECT_EQ(std::ranges::count(mesh.faces, face), 8);
        EXPECT_TRUE(std::ranges::is_sorted(mesh.faces));
    }
}

TEST(Subdivide, goesOnAcrossTangentEdges) {
    Mesh cube = quadCube();
    for (EdgeKinds& kinds : cube.edges)
        if (!kinds.has(EdgeKind::Inner)) kinds |= EdgeKind::Tangent;
    const Scene scene = refined(cube, levels(2));
    EXPECT_LT(scene.box().max.x, 1.0) << "rounded, however little the crease angle";
    EXPECT_EQ(std::ranges::count(scenes::edgesOfKind(scene.meshes()[0], EdgeKind::Sharp), true), 0);
}

}  // namespace
}  // namespace inkedge::mesh
