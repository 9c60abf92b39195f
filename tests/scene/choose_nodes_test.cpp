// LoadSettings::only and ::hide.
#include <gmock/gmock.h>

#include <inkedge/error.h>
#include <inkedge/scene.h>
#include <inkedge/scene_names.h>

#include "base/expect_error.h"
#include "scenes.h"

namespace inkedge::scene {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using testing::StrEq;

// robot: body, arm (arm/hand, arm/hand/finger 1, arm/hand/finger 2), and a lamp beside it.
Scene::Data robot() {
    Scene::Data data;
    data.nodes = {{"robot", noNode}, {"body", 0},     {"arm", 0},      {"hand", 2},
                  {"finger 1", 3},   {"finger 2", 3}, {"lamp", noNode}};
    for (const std::uint32_t node : {1U, 2U, 3U, 4U, 5U, 6U}) {
        data.meshes.push_back(scenes::cube(1.0 + node));
        data.meshes.back().name = "mesh of " + data.nodes[node].name;
        data.instances.push_back({data.nodes[node].name, node - 1, glm::dmat4{1.0}, node});
    }
    return data;
}

struct Chosen {
    std::vector<std::string> only;
    std::vector<std::string> hide;
};

Scene sceneOf(const Chosen& chosen) {
    LoadSettings settings;
    settings.only = chosen.only;
    settings.hide = chosen.hide;
    return Scene{robot(), settings};
}

std::vector<std::string> drawn(const Chosen& chosen) {
    std::vector<std::string> names;
    const Scene scene = sceneOf(chosen);
    for (const Instance& instance : scene.instances()) names.push_back(instance.name);
    return names;
}

TEST(ChooseNodes, drawsANodeAndAllThatBelongsToIt) {
    EXPECT_THAT(drawn({}), SizeIs(6));
    EXPECT_THAT(drawn({.only = {"hand"}, .hide = {}}), ElementsAre("hand", "finger 1", "finger 2"));
    EXPECT_THAT(drawn({.only = {"lamp", "body"}, .hide = {}}), ElementsAre("body", "lamp"));
    EXPECT_THAT(drawn({.only = {}, .hide = {"arm"}}), ElementsAre("body", "lamp"));
    EXPECT_THAT(drawn({.only = {"arm"}, .hide = {"hand"}}), ElementsAre("arm"));
    EXPECT_THAT(drawn({.only = {"robot"}, .hide = {"robot/body"}}), ElementsAre("arm", "hand", "finger 1", "finger 2"));
}

TEST(ChooseNodes, takesTheNamesThatAModelIsSaidToHave) {
    Scene::Data data = robot();
    for (SceneNode& node : data.nodes) node.name.clear();
    for (Instance& instance : data.instances) instance.name = "part of " + data.meshes[instance.mesh].name;
    const NamedInstance finger = namesOf(Scene{data, {}}).instances.at(3);
    LoadSettings settings;
    settings.only = {finger.node};
    const Scene scene{data, settings};
    ASSERT_THAT(scene.instances(), SizeIs(1));
    EXPECT_EQ(scene.instances()[0].name, "part of mesh of finger 1");
}

TEST(ChooseNodes, takesPatternsOfNamesAndPaths) {
    EXPECT_THAT(drawn({.only = {"finger ?"}, .hide = {}}), ElementsAre("finger 1", "finger 2"));
    EXPECT_THAT(drawn({.only = {"f*2"}, .hide = {}}), ElementsAre("finger 2"));
    EXPECT_THAT(drawn({.only = {"robot/*/finger 1"}, .hide = {}}), ElementsAre("finger 1"));
    EXPECT_THAT(drawn({.only = {}, .hide = {"*arm/hand"}}), ElementsAre("body", "arm", "lamp"));
    EXPECT_THAT(drawn({.only = {"*"}, .hide = {}}), SizeIs(6));
    EXPECT_THAT(drawn({.only = {"**b*d**y*", "x*"}, .hide = {}}), ElementsAre("body"));
}

TEST(ChooseNodes, keepsTheMeshesOfWhatIsDrawn) {
    const Scene scene = sceneOf({.only = {"finger 2", "body"}, .hide = {}});
    ASSERT_THAT(scene.meshes(), SizeIs(2));
    for (const Instance& instance : scene.instances())
        EXPECT_EQ(scene.meshes()[instance.mesh].name, "mesh of " + instance.name);
    EXPECT_EQ(scene.triangleCount(), 24U);
    EXPECT_THAT(scene.warnings(), IsEmpty());
}

TEST(ChooseNodes, goesByTheInstancesOfAFileWithoutNodes) {
    Scene::Data data = robot();
    data.nodes.clear();
    for (Instance& instance : data.instances) instance.node = noNode;
    LoadSettings settings;
    settings.only = {"hand"};
    EXPECT_THAT(Scene(data, settings).instances(), SizeIs(1));
}

TEST(ChooseNodes, saysWhatNoNodeIsNamed) {
    EXPECT_THAT(sceneOf({.only = {"body", "leg"}, .hide = {"wing*"}}).warnings(),
                ElementsAre("--only: no node is named 'leg'", "--hide: no node is named 'wing*'"));
    expectError(
        Error::Kind::Usage,
        StrEq("--only: expected a node to draw, found none for 'leg;a\\tb'; there are arm, body, finger 1, finger "
              "2, hand, lamp, robot"),
        [] {
            (void)sceneOf({.only = {"leg", "a\tb"}, .hide = {}});
        });
    expectError(Error::Kind::Usage,
                HasSubstr("--only: expected a node to draw, found none for 'body' that --hide leaves"),
                [] { (void)sceneOf({.only = {"body"}, .hide = {"robot"}}); });
    expectError(Error::Kind::Usage, HasSubstr("--hide: expected a node to draw, found none left; there are arm"),
                [] { (void)sceneOf({.only = {}, .hide = {"*"}}); });
}

}  // namespace
}  // namespace inkedge::scene
