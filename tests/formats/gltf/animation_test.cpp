#include <cmath>
#include <numbers>

#include <inkedge/scene.h>

#include "formats/gltf/gltf_files.h"

namespace inkedge::gltf {
namespace {

using namespace gltf_files;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

class Animation : public GltfFileTest {
protected:
    // A triangle whose node an animation "wave" drives.
    Model animated(const std::string& path, const std::vector<float>& times, const std::vector<float>& values,
                   const std::string& type, const std::string& interpolation) {
        Model model = triangle();
        const int input = model.accessor<float>(times, "SCALAR");
        const int output = model.accessor<float>(values, type);
        model.add("animations",
                  {{"name", "wave"},
                   {"samplers", {{{"input", input}, {"output", output}, {"interpolation", interpolation}}}},
                   {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", path}}}}}}});
        return model;
    }

    [[nodiscard]] glm::dvec3 firstCornerAt(const Model& model, double time, const std::string& name = "wave") const {
        LoadSettings settings;
        settings.animation = name;
        settings.time = time;
        return worldCorners(load(model, settings)).at(0);
    }
};

TEST_F(Animation, MovesLinearlyBetweenItsKeysAndHoldsBeyondThem) {
    const Model model = animated("translation", {1, 3}, {0, 0, 0, 8, 0, 0}, "VEC3", "LINEAR");
    EXPECT_DOUBLE_EQ(firstCornerAt(model, 0.0).x, 0.0);
    EXPECT_DOUBLE_EQ(firstCornerAt(model, 1.5).x, 2.0);
    EXPECT_DOUBLE_EQ(firstCornerAt(model, 3.0).x, 8.0);
    EXPECT_DOUBLE_EQ(firstCornerAt(model, 99.0).x, 8.0);
    EXPECT_DOUBLE_EQ(firstCornerAt(model, 1.5, "0").x, 2.0) << "by number";
    EXPECT_DOUBLE_EQ(worldCorners(load(model)).at(0).x, 0.0) << "without an animation: as the file places it";
}

TEST_F(Animation, StepsAtItsKeys) {
    const Model model = animated("translation", {0, 1, 2}, {0, 0, 0, 5, 0, 0, 7, 0, 0}, "VEC3", "STEP");
    EXPECT_DOUBLE_EQ(firstCornerAt(model, 0.999).x, 0.0);
    EXPECT_DOUBLE_EQ(firstCornerAt(model, 1.0).x, 5.0);
    EXPECT_DOUBLE_EQ(firstCornerAt(model, 1.999).x, 5.0);
}

// p(t) = (2t^3 - 3t^2 + 1) v0 + d (t^3 - 2t^2 + t) b0 + (-2t^3 + 3t^2) v1 + d (t^3 - t^2) a1, glTF 2.0, appendix C.5
TEST_F(Animation, FollowsACubicSpline) {
    const std::vector<float> keys{0, 0, 0, 1, 0, 0, 4, 0, 0,  // in-tangent, value, out-tangent
                                  2, 0, 0, 3, 0, 0, 0, 0, 0};
    const Model model = animated("translation", {0, 2}, keys, "VEC3", "CUBICSPLINE");
    const double t = 0.25;
    const double expected = (2 * t * t * t - 3 * t * t + 1) * 1 + 2 * (t * t * t - 2 * t * t + t) * 4 +
                            (-2 * t * t * t + 3 * t * t) * 3 + 2 * (t * t * t - t * t) * 2;
    EXPECT_NEAR(firstCornerAt(model, 0.5).x, expected, 1e-12);
}

TEST_F(Animation, TurnsAtAnEvenRate) {
    const auto half = static_cast<float>(std::sqrt(0.5));
    Model model = animated("rotation", {0, 1}, {0, 0, 0, 1, 0, 0, half, half}, "VEC4", "LINEAR");  // 90 degrees about z
    LoadSettings settings;
    settings.animation = "wave";
    settings.time = 1.0 / 3.0;
    const glm::dvec3 corner = worldCorners(load(model, settings)).at(1);  // (1, 0, 0) in the mesh
    EXPECT_NEAR(std::atan2(corner.y, corner.x), std::numbers::pi / 6.0, 1e-7);
}

TEST_F(Animation, SetsMorphWeights) {
    Model model = animated("weights", {0, 2}, {0, 1}, "SCALAR", "LINEAR");
    const int target = model.accessor<float>({0, 0, 4, 0, 0, 4, 0, 0, 4}, "VEC3");
    model.json["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", target}}};
    EXPECT_NEAR(firstCornerAt(model, 0.5).z, 1.0, 1e-6);
}

TEST_F(Animation, WarnsOfWhatIsNotRead) {
    Model model = animated("pointer", {0, 1}, {0, 0, 0, 1, 1, 1}, "VEC3", "LINEAR");
    LoadSettings settings;
    settings.animation = "wave";
    EXPECT_THAT(load(model, settings).warnings,
                ElementsAre("animation 0 'wave': 1 of 1 channels drive what is not read"));
}

// glTF 2.0, section 3.11: "When node isn't defined, channel SHOULD be ignored."
TEST_F(Animation, IgnoresChannelsWithoutANode) {
    Model model = animated("translation", {0, 1}, {0, 0, 0, 8, 0, 0}, "VEC3", "LINEAR");
    Json& channels = model.json["animations"][0]["channels"];
    const Json withoutNode{{"sampler", 0}, {"target", {{"path", "scale"}}}};
    channels.insert(channels.begin(), withoutNode);
    EXPECT_THAT(load(model).warnings, IsEmpty());
    LoadSettings settings;
    settings.animation = "wave";
    settings.time = 0.5;
    const Scene::Data data = load(model, settings);
    EXPECT_THAT(data.warnings, IsEmpty());
    expectNear(worldCorners(data), {{4, 0, 0}, {5, 0, 0}, {4, 1, 0}});
}

class AnimationPointer : public Animation {
protected:
    template <class T>
    static Model driven(const std::string& pointer, const std::vector<T>& values, const std::string& type,
                        bool normalized = false) {
        Model model = triangle();
        model.json["extensionsUsed"] = {"KHR_animation_pointer", "KHR_node_visibility"};
        const int input = model.accessor<float>({0, 1}, "SCALAR");
        const int output = model.accessor<T>(values, type);
        if (normalized) model.json["accessors"][static_cast<std::size_t>(output)]["normalized"] = true;
        model.add("animations", {{"samplers", {{{"input", input}, {"output", output}}}}, {"channels", Json::array()}});
        drive(model, pointer);
        return model;
    }

    static void drive(Model& model, const std::string& pointer) {
        const Json extension{{"KHR_animation_pointer", {{"pointer", pointer}}}};
        model.json["animations"][0]["channels"].push_back(
            {{"sampler", 0}, {"target", {{"path", "pointer"}, {"extensions", extension}}}});
    }

    // Two morph targets, which lift the triangle by 4 and move it by 2 along x, with weights of the mesh.
    static Model morphed(const std::string& pointer, const std::vector<float>& values) {
        Model model = driven<float>(pointer, values, "SCALAR");
        const int up = model.accessor<float>({0, 0, 4, 0, 0, 4, 0, 0, 4}, "VEC3");
        const int aside = model.accessor<float>({2, 0, 0, 2, 0, 0, 2, 0, 0}, "VEC3");
        model.json["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", up}}, {{"POSITION", aside}}};
        model.json["meshes"][0]["weights"] = {0.25, 0.5};
        return model;
    }

    [[nodiscard]] Scene::Data at(const Model& model, double time) const {
        LoadSettings settings;
        settings.animation = "0";
        settings.time = time;
        return load(model, settings);
    }
};

TEST_F(AnimationPointer, DrivesTransforms) {
    const auto half = static_cast<float>(std::sqrt(0.5));
    expectNear(worldCorners(at(driven<float>("/nodes/0/translation", {0, 0, 0, 8, 0, 0}, "VEC3"), 0.5)),
               {{4, 0, 0}, {5, 0, 0}, {4, 1, 0}});
    expectNear(worldCorners(at(driven<float>("/nodes/0/rotation", {0, 0, 0, 1, 0, 0, half, half}, "VEC4"), 1.0)),
               {{0, 0, 0}, {0, 1, 0}, {-1, 0, 0}});
    expectNear(worldCorners(at(driven<float>("/nodes/0/scale", {1, 1, 1, 3, 1, 1}, "VEC3"), 0.5)),
               {{0, 0, 0}, {2, 0, 0}, {0, 1, 0}});
}

TEST_F(AnimationPointer, TakesIntegersAsTheyAreOrNormalized) {
    const std::vector<std::uint8_t> values{0, 0, 0, 255, 0, 0};
    EXPECT_DOUBLE_EQ(worldCorners(at(driven("/nodes/0/translation", values, "VEC3"), 1.0)).at(0).x, 255.0);
    EXPECT_DOUBLE_EQ(worldCorners(at(driven("/nodes/0/translation", values, "VEC3", true), 1.0)).at(0).x, 1.0);
}

TEST_F(AnimationPointer, HidesAndShowsNodes) {
    const std::string pointer = "/nodes/0/extensions/KHR_node_visibility/visible";
    const Model hiding = driven<std::uint8_t>(pointer, {1, 0}, "SCALAR");
    EXPECT_THAT(at(hiding, 0.9).instances, SizeIs(1)) << "a boolean steps";
    EXPECT_THAT(at(hiding, 1.0).instances, IsEmpty());
    EXPECT_THAT(at(hiding, 1.0).warnings, IsEmpty());
    Model showing = driven<std::uint8_t>(pointer, {0, 7}, "SCALAR");
    showing.json["nodes"][0]["extensions"] = {{"KHR_node_visibility", {{"visible", false}}}};
    EXPECT_THAT(load(showing).instances, IsEmpty());
    EXPECT_THAT(at(showing, 0.0).instances, IsEmpty());
    EXPECT_THAT(at(showing, 1.0).instances, SizeIs(1));
}

TEST_F(AnimationPointer, DrivesWeightsOfNodesAndMeshesAllOrOne) {
    const auto cornerOf = [&](const Model& model) { return worldCorners(at(model, 1.0)).at(0); };
    expectNear({cornerOf(morphed("/nodes/0/weights", {0, 0, 1, 1}))}, {{2, 0, 4}});
    expectNear({cornerOf(morphed("/meshes/0/weights", {0, 0, 1, 1}))}, {{2, 0, 4}});
    expectNear({cornerOf(morphed("/nodes/0/weights/0", {0, 1}))}, {{1, 0, 4}});
    expectNear({cornerOf(morphed("/meshes/0/weights/1", {0, 1}))}, {{2, 0, 1}});
    Model own = morphed("/meshes/0/weights", {0, 0, 1, 1});
    own.json["nodes"][0]["weights"] = {0.0, 0.5};
    expectNear({cornerOf(own)}, {{1, 0, 0}});
}

TEST_F(AnimationPointer, WarnsOfWhatIsNotRead) {
    Model model = driven<float>("/materials/0/alphaCutoff", {0, 1}, "SCALAR");
    for (const char* pointer : {"", "/", "nodes/0/scale", "/nodes/0", "/nodes/0/matrix", "/nodes/x/scale",
                                "/nodes/-1/scale", "/nodes/0/scale/0", "/nodes/0/weights/", "/meshes/0/translation",
                                "/meshes/0/extensions/KHR_node_visibility/visible", "/nodes/99999999999/scale"})
        drive(model, pointer);
    EXPECT_THAT(at(model, 1.0).warnings, ElementsAre("animation 0: 13 of 13 channels drive what is not read"));
}

TEST_F(AnimationPointer, RefusesWhatIsNotThereOrDamaged) {
    LoadSettings settings;
    settings.animation = "0";
    const auto why = [&](const Model& model) { return refusal(model, settings); };
    EXPECT_EQ(why(driven<float>("/nodes/7/scale", {1, 1, 1, 1, 1, 1}, "VEC3")),
              "animation 0, channel 0: expected a node below 1, found 7");
    EXPECT_EQ(why(driven<float>("/meshes/1/weights", {0, 1}, "SCALAR")),
              "animation 0, channel 0: expected a mesh below 1, found 1");
    EXPECT_EQ(why(morphed("/nodes/0/weights/2", {0, 1})), "animation 0, channel 0: expected a weight below 2, found 2");
    EXPECT_EQ(why(morphed("/nodes/0/weights/1", {0, 0, 1, 1})),
              "animation 0, channel 0: expected 1 number a key, found 2");
    EXPECT_THAT(why(driven<float>("/nodes/0/extensions/KHR_node_visibility/visible", {0, 1}, "SCALAR")),
                HasSubstr("expected SCALAR"));
    EXPECT_THAT(why(driven<float>("/nodes/0/scale", {1, 1, 1, 1}, "VEC2")), HasSubstr("expected VEC3"));
}

TEST_F(Animation, RefusesWhatIsNotThereOrDamaged) {
    LoadSettings settings;
    settings.animation = "Run";
    EXPECT_EQ(refusal(triangle(), settings, Error::Kind::Usage),
              "--animation: expected none, as the file has no animations, found 'Run'");
    EXPECT_EQ(refusal(animated("translation", {0}, {0, 0, 0}, "VEC3", "LINEAR"), settings, Error::Kind::Usage),
              "--animation: expected one of 0 'wave', found 'Run'");
    settings.animation = "wave";
    EXPECT_THAT(refusal(animated("translation", {1, 0}, {0, 0, 0, 0, 0, 0}, "VEC3", "LINEAR"), settings),
                HasSubstr("channel 0: expected times that rise, found 0 at key 1"));
    EXPECT_THAT(refusal(animated("translation", {0, 1}, {0, 0, 0}, "VEC3", "LINEAR"), settings),
                HasSubstr("expected the same number of values for each of 2 keys, found 3 in all"));
    EXPECT_THAT(refusal(animated("rotation", {0, 1}, {0, 0, 0, 0, 0, 0}, "VEC3", "LINEAR"), settings),
                HasSubstr("expected VEC4"));
    Model nowhere = animated("translation", {0}, {0, 0, 0}, "VEC3", "LINEAR");
    nowhere.json["animations"][0]["channels"][0]["target"]["node"] = 7;
    EXPECT_THAT(refusal(nowhere, settings), HasSubstr("expected a node below 1, found 7"));
}

}  // namespace
}  // namespace inkedge::gltf
