#include "formats/gltf/not_drawn.h"

#include "formats/gltf/gltf_files.h"
#include "formats/gltf/triangles.h"

namespace inkedge::gltf {
namespace {

using namespace gltf_files;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class WhatIsThere : public GltfFileTest {
protected:
    [[nodiscard]] std::vector<std::string> of(const Model& model, const LoadSettings& settings = {}) const {
        return load(model, settings).undrawn;
    }
    // Twelve vertices, drawn twice.
    [[nodiscard]] Model twelve(Mode mode) const {
        Model model;
        const std::vector<float> numbers(36, 0.5F);
        Json primitive = positions(model.accessor(numbers, "VEC3"));
        primitive["mode"] = static_cast<int>(mode);
        model.mesh(primitive);
        model.root({{"mesh", 0}});
        model.root({{"mesh", 0}});
        return model;
    }
};

TEST_F(WhatIsThere, areCountedPoints) {
    EXPECT_THAT(of(twelve(Mode::Points)), ElementsAre("12 points"));
    Model indexed = twelve(Mode::Points);
    indexed.json["meshes"][0]["primitives"][0]["indices"] = indexed.accessor<std::uint16_t>({3}, "SCALAR");
    EXPECT_THAT(of(indexed), ElementsAre("1 point"));
}

TEST_F(WhatIsThere, isNotSaidWhereThereIsATriangleOrLine) {
    for (const bool line : {false, true}) {
        Model model = line ? twelve(Mode::LineStrip) : triangle();
        Json point = positions(0);
        point["mode"] = 0;
        model.json["meshes"][0]["primitives"].push_back(point);
        EXPECT_THAT(of(model), IsEmpty());
    }
}

TEST_F(WhatIsThere, areOtherScenesWithMeshes) {
    Model model = triangle();
    model.json["scenes"].push_back({{"nodes", Json::array()}});
    model.json["scene"] = 1;
    EXPECT_THAT(of(model), ElementsAre("scene 1 is empty", "scene 0 has 1 mesh: --scene 0"));
    LoadSettings settings;
    settings.scene = 0;
    EXPECT_THAT(of(model, settings), IsEmpty());
}

TEST_F(WhatIsThere, areMeshesThatNoNodeDraws) {
    Model model = triangle();
    model.mesh(positions(0));
    model.json["nodes"][0].erase("mesh");
    EXPECT_THAT(of(model), ElementsAre("2 meshes that no node draws"));
    model.json.erase("nodes");
    model.json.erase("scenes");
    EXPECT_THAT(of(model), ElementsAre("2 meshes that no node draws"));
}

TEST_F(WhatIsThere, areNodesAndCamerasWithoutAMesh) {
    Model model;
    EXPECT_THAT(of(model), ElementsAre("no mesh"));
    model.add("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 0.8}, {"znear", 0.1}}}});
    model.root({{"camera", 0}});
    model.root({{"name", "empty"}});
    EXPECT_THAT(of(model), ElementsAre("no mesh", "2 nodes", "1 camera"));
}

TEST_F(WhatIsThere, areMeshesThatAreHiddenMaskedOrLeftOut) {
    Model hidden = triangle();
    hidden.json["nodes"][0]["extensions"] = {{"KHR_node_visibility", {{"visible", false}}}};
    EXPECT_THAT(of(hidden), ElementsAre("1 mesh in hidden nodes"));

    Model masked = triangle();
    masked.json["meshes"][0]["primitives"][0]["material"] =
        masked.add("materials", {{"alphaMode", "MASK"}, {"pbrMetallicRoughness", {{"baseColorFactor", {1, 1, 1, 0}}}}});
    EXPECT_THAT(of(masked), ElementsAre("all triangles are masked away"));

    masked.json["meshes"][0]["primitives"][0]["mode"] = 3;
    EXPECT_THAT(of(masked), ElementsAre("all lines are masked away"));

    Model glass = triangle();
    glass.json["meshes"][0]["primitives"][0]["material"] = glass.add("materials", {{"alphaMode", "BLEND"}});
    LoadSettings settings;
    settings.transparent = Transparent::Ignore;
    EXPECT_THAT(of(glass, settings), ElementsAre(HasSubstr("all triangles are transparent")));
    EXPECT_THAT(of(glass), IsEmpty());

    Model bare = triangle();
    bare.json["meshes"][0]["primitives"][0]["attributes"] = {{"NORMAL", 0}};
    EXPECT_THAT(of(bare), ElementsAre("1 mesh without triangles or lines"));
}

}  // namespace
}  // namespace inkedge::gltf
