#include <set>

#include <gmock/gmock.h>

#include <inkedge/renderer.h>

#include "gl/gl_test.h"
#include "scene/prepared.h"
#include "scenes.h"

namespace inkedge::gl {
namespace {

using testing::ElementsAre;

// Four unit squares side by side before a camera that looks along -Z: one that faces it, one that turns its back, one
// that faces it in a mirror, one that turns its back but has a double-sided material.
Scene squares(BackFaces backFaces) {
    const glm::dmat4 mirror = scenes::scaling({-1, 1, 1});
    Scene::Data data;
    data.materials = {{"paper", false}, {"cloth", true}};
    const auto add = [&](double x, bool turned, bool mirrored, std::uint32_t material) {
        Mesh mesh = scenes::quad({-0.5, -0.5, 0}, {0.5, -0.5, 0}, {0.5, 0.5, 0}, {-0.5, 0.5, 0});
        if (turned) std::swap(mesh.indices[1], mesh.indices[2]), std::swap(mesh.indices[4], mesh.indices[5]);
        mesh.normals.clear();
        mesh.materials.assign(2, material);
        const glm::dmat4 transform = scenes::translation({x, 0, 0});
        data.instances.push_back(
            {"", static_cast<std::uint32_t>(data.meshes.size()), mirrored ? transform * mirror : transform});
        data.meshes.push_back(mesh);
    };
    add(-3, false, false, 1);
    add(-1, true, false, 1);
    add(1, false, true, 1);
    add(3, true, false, 2);
    LoadSettings settings;
    settings.backFaces = backFaces;
    return Scene{std::move(data), settings};
}

INKEDGE_ON_EACH_BACKEND(BackFacesTest);

TEST_P(BackFacesTest, AreLeftOutWhereTheMaterialIsSingleSided) {
    for (const Detector detector : {Detector::Planes, Detector::Classic}) {
        const auto seen = [&](BackFaces backFaces) {
            const Scene scene = squares(backFaces);
            Settings settings;
            settings.picture.size = {160, 40};
            settings.detector.detector = detector;
            settings.maps = {Map::Depth, Map::Ids};
            CameraSettings look;
            look.direction = glm::dvec3{0, 0, -1};
            const Maps maps = renderer().render(scene, frameCamera(scene, look, settings.picture.size), settings);
            std::set<std::uint32_t> instances;
            for (int x = 0; x < 160; ++x)
                if (const std::uint32_t instance = maps.ids.at(x, 20, 2); instance != 0) instances.insert(instance);
            return instances;
        };
        EXPECT_THAT(seen(BackFaces::Draw), ElementsAre(1, 2, 3, 4));
        EXPECT_THAT(seen(BackFaces::Material), ElementsAre(1, 3, 4));
    }
}

// Triangles of both kinds in one mesh: the numbers by which pixels name their triangle must stay right.
TEST_P(BackFacesTest, MixedMeshesKeepTheirTrianglesNumbers) {
    Mesh mesh = scenes::quad({-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0});
    mesh.normals.clear();
    mesh.materials = {2, 1};  // the first is double-sided and moves behind the second
    Scene::Data data;
    data.materials = {{"paper", false}, {"cloth", true}};
    data.instances.push_back({"", 0, glm::dmat4{1.0}});
    data.meshes.push_back(mesh);
    LoadSettings load;
    load.backFaces = BackFaces::Material;
    const Scene scene{std::move(data), load};
    EXPECT_EQ(scene::oneSidedTriangles(scene, 0), 1U);
    Settings settings;
    settings.picture.size = {64, 64};
    settings.maps = {Map::Ids};
    CameraSettings look;
    look.direction = glm::dvec3{0, 0, -1};
    const Maps maps = renderer().render(scene, frameCamera(scene, look, settings.picture.size), settings);
    EXPECT_EQ(maps.ids.at(40, 44, 3), 2U) << "lower right: the file's first triangle";
    EXPECT_EQ(maps.ids.at(24, 20, 3), 1U);
}

}  // namespace
}  // namespace inkedge::gl
