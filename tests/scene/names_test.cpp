#include <inkedge/scene_names.h>

#include <string>

#include <gmock/gmock.h>

#include <inkedge/scene.h>

namespace inkedge::scene {
namespace {

using testing::ElementsAre;

Scene::Data triangles() {
    Scene::Data data;
    Mesh& mesh = data.meshes.emplace_back();
    mesh.name = "plate";
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
    mesh.indices = {0, 1, 2, 1, 3, 2, 0, 1, 2};
    mesh.materials = {2, 0, 1};
    data.materials.resize(2);
    data.materials[0].name = "tin";
    return data;
}

TEST(NamesOf, countInstancesThatAreDrawnFromOne) {
    Scene::Data data = triangles();
    data.meshes.emplace_back().name = "nothing";
    data.nodes = {{"crane", noNode}, {"", 0}, {"arm", 1}, {"hook", 2}};
    glm::dmat4 sheared{1.0};
    sheared[1][0] = 0.5;
    data.instances = {
        {"arm", 0, glm::dmat4{1.0}, 2}, {"none", 1, glm::dmat4{1.0}, 2}, {"hook", 0, sheared, 3}, {"loose", 0, glm::dmat4{1.0}}};
    const SceneNames names = namesOf(Scene{std::move(data)});
    ASSERT_EQ(names.instances.size(), 3U) << "one draws nothing";
    EXPECT_EQ(names.instances[0], (NamedInstance{1, "crane/arm", "plate", {1, 2}, glm::dmat4{1.0}}));
    EXPECT_EQ(names.instances[1], (NamedInstance{2, "crane/arm/hook", "plate", {1, 2}, sheared})) << "as it was given";
    EXPECT_EQ(names.instances[2].node, "loose");
    EXPECT_THAT(names.materials, ElementsAre("tin", ""));
}

TEST(NamesOf, keepPathsShortInADeepTree) {
    Scene::Data data = triangles();
    constexpr std::uint32_t depth = 100000;
    for (std::uint32_t i = 0; i < depth; ++i) data.nodes.push_back({i % 2 == 0 ? "part" : "", i == 0 ? noNode : i - 1});
    data.instances = {{"leaf", 0, glm::dmat4{1.0}, depth - 1}};
    const SceneNames names = namesOf(Scene{std::move(data)});
    const std::string& path = names.instances.front().node;
    EXPECT_LE(path.size(), 1024U + 4U);
    EXPECT_TRUE(path.starts_with(".../part/part/")) << path;
    EXPECT_TRUE(path.ends_with("/part/leaf")) << path;
}

}  // namespace
}  // namespace inkedge::scene
