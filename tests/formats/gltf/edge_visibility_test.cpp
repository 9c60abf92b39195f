// Edges that a glTF file marks with EXT_mesh_primitive_edge_visibility or CESIUM_primitive_outline.
#include <functional>

#include <glm/common.hpp>

#include "formats/gltf/gltf_files.h"
#include "mesh/topology.h"
#include "scene/prepared.h"
#include "scenes.h"

namespace inkedge::gltf {
namespace {

using namespace gltf_files;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

constexpr const char* extensionName = "EXT_mesh_primitive_edge_visibility";

class EdgeVisibility : public GltfFileTest {
protected:
    // The square of two triangles 0 1 2, 2 1 3 with an extension; its accessors come after the first two.
    static Model squareWith(const std::function<Json(Model&)>& extension) {
        Model model;
        Json primitive = positions(model.accessor(square, "VEC3"));
        primitive["indices"] = model.accessor<std::uint16_t>({0, 1, 2, 2, 1, 3}, "SCALAR");
        primitive["extensions"][extensionName] = extension(model);
        model.json["extensionsUsed"] = {extensionName};
        model.json["extensionsRequired"] = {extensionName};
        model.root({{"mesh", model.mesh(primitive)}});
        return model;
    }
    static Model squareWithVisibility(const std::vector<std::uint8_t>& edges) {
        return squareWith([&](Model& model) { return Json{{"visibility", model.accessor(packed(edges), "SCALAR")}}; });
    }
    static Model squareWithLines(const std::vector<std::uint8_t>& indices) {
        return squareWith([&](Model& model) {
            return Json{{"lineStrings", {{{"indices", model.accessor(indices, "SCALAR")}}}}};
        });
    }
    // Two bits an edge, the first in the lowest.
    static std::vector<std::uint8_t> packed(const std::vector<std::uint8_t>& edges) {
        std::vector<std::uint8_t> bytes((edges.size() + 3) / 4);
        for (std::size_t i = 0; i < edges.size(); ++i)
            bytes[i / 4] = static_cast<std::uint8_t>(bytes[i / 4] | edges[i] << 2 * (i % 4));
        return bytes;
    }
};

std::vector<bool> marked(const Mesh& mesh) { return scenes::edgesOfKind(mesh, EdgeKind::Marked); }
std::vector<bool> inner(const Mesh& mesh) { return scenes::edgesOfKind(mesh, EdgeKind::Inner); }

TEST_F(EdgeVisibility, MarksHardEdgesAndThoseSaidBefore) {
    const Scene::Data data = load(squareWithVisibility({2, 1, 0, 0, 3, 2}));
    EXPECT_THAT(data.warnings, IsEmpty());
    EXPECT_THAT(marked(data.meshes.at(0)), ElementsAre(true, false, false, false, true, true));
    EXPECT_THAT(inner(data.meshes.at(0)), ElementsAre(false, true, true, true, false, false));
}

TEST_F(EdgeVisibility, IsReadAsTheExtensionsTextPacksIt) {
    // Its example: the values 2, 0, 1, 0, 2, 0 are the bytes 18 and 2.
    const Model model = squareWith([](Model& m) {
        return Json{{"visibility", m.accessor<std::uint8_t>({18, 2}, "SCALAR")}};
    });
    EXPECT_THAT(marked(load(model).meshes.at(0)), ElementsAre(true, false, false, false, true, false));
}

TEST_F(EdgeVisibility, MarksLineStringsWhicheverWayTheyRun) {
    const Scene::Data data = load(squareWithLines({0, 1, 3, 255, 2, 0}));
    EXPECT_THAT(data.warnings, IsEmpty());
    // Edges 0-1 1-2 2-0, 2-1 1-3 3-2.
    EXPECT_THAT(marked(data.meshes.at(0)), ElementsAre(true, false, true, false, true, false));
    EXPECT_THAT(inner(data.meshes.at(0)), testing::Each(false));
}

TEST_F(EdgeVisibility, DrawsLineStringsOnNoTriangleAsLines) {
    const Scene::Data data = load(squareWithLines({0, 3, 1}));
    EXPECT_THAT(data.warnings, IsEmpty());
    expectNear(lineEnds(data.meshes.at(0)), {{0, 0, 0}, {1, 1, 0}});
    EXPECT_THAT(load(squareWithLines({0, 1})).meshes.at(0).lines, IsEmpty());
}

class PrimitiveOutline : public GltfFileTest {
protected:
    // The square of two triangles 0 1 2, 2 1 3 with an outline of these edges.
    static Model squareWithOutline(const std::vector<std::uint16_t>& indices) {
        Model model;
        Json primitive = positions(model.accessor(square, "VEC3"));
        primitive["indices"] = model.accessor<std::uint16_t>({0, 1, 2, 2, 1, 3}, "SCALAR");
        primitive["extensions"]["CESIUM_primitive_outline"] = {{"indices", model.accessor(indices, "SCALAR")}};
        model.json["extensionsUsed"] = {"CESIUM_primitive_outline"};
        model.root({{"mesh", model.mesh(primitive)}});
        return model;
    }
};

TEST_F(PrimitiveOutline, MarksItsEdgesAndSaysNothingOfOthers) {
    const Scene::Data data = load(squareWithOutline({0, 1, 2, 1}));
    EXPECT_THAT(data.warnings, IsEmpty());
    // Edges 0-1 1-2 2-0, 2-1 1-3 3-2.
    EXPECT_THAT(marked(data.meshes.at(0)), ElementsAre(true, true, false, true, false, false));
    EXPECT_THAT(inner(data.meshes.at(0)), testing::Each(false));
}

TEST_F(PrimitiveOutline, DrawsEdgesOnNoTriangleAsLines) {
    const Scene::Data data = load(squareWithOutline({0, 3, 0, 1}));
    EXPECT_THAT(data.warnings, IsEmpty());
    expectNear(lineEnds(data.meshes.at(0)), {{0, 0, 0}, {1, 1, 0}});
}

TEST_F(PrimitiveOutline, RefusesWhatIsDamaged) {
    EXPECT_THAT(refusal(squareWithOutline({0, 1, 2})),
                HasSubstr("CESIUM_primitive_outline: indices: expected two for each edge, found 3"));
    EXPECT_THAT(refusal(squareWithOutline({0, 4})), HasSubstr("expected vertex indices below 4, found 4 at index 1"));
    Model none = squareWithOutline({0, 1});
    none.json["meshes"][0]["primitives"][0]["extensions"]["CESIUM_primitive_outline"] = Json::object();
    EXPECT_THAT(refusal(none), HasSubstr("indices: expected the number of an accessor"));
}

TEST_F(EdgeVisibility, CountsTheTrianglesOfStripsThatAreNotDrawn) {
    // 0 1 2, 2 1 3, then two without area, then 3 4 5 (odd: 3 5 4 by its index).
    Model model;
    std::vector<float> points = square;
    points.insert(points.end(), {3, 0, 0, 3, 1, 0});
    Json primitive = positions(model.accessor(points, "VEC3"));
    primitive["mode"] = 5;
    primitive["indices"] = model.accessor<std::uint16_t>({0, 1, 2, 3, 3, 4, 5}, "SCALAR");
    primitive["extensions"][extensionName] = {
        {"visibility", model.accessor(packed({2, 0, 0, 0, 0, 0, 2, 2, 2, 2, 2, 2, 0, 2, 0}), "SCALAR")}};
    model.root({{"mesh", model.mesh(primitive)}});
    const Mesh mesh = load(model).meshes.at(0);
    ASSERT_EQ(mesh.indices.size(), 9U);
    EXPECT_THAT(marked(mesh), ElementsAre(true, false, false, false, false, false, false, true, false));
}

TEST_F(EdgeVisibility, OfOnePrimitiveLeavesTheOthersUnmarked) {
    Model model = squareWithVisibility({2, 0, 0, 0, 0, 0});
    Json plain = positions(0);
    plain["indices"] = 1;
    model.json["meshes"][0]["primitives"].insert(model.json["meshes"][0]["primitives"].begin(), plain);
    const Mesh mesh = load(model).meshes.at(0);
    EXPECT_THAT(marked(mesh), ElementsAre(false, false, false, false, false, false,  //
                                          true, false, false, false, false, false));
}

TEST_F(EdgeVisibility, HiddenEdgesAreNoCreases) {
    for (const std::uint8_t visibility : std::initializer_list<std::uint8_t>{0, 1, 2}) {
        Model model;  // bent by a right angle along 1-2
        Json primitive = positions(model.accessor<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 1}, "VEC3"));
        primitive["indices"] = model.accessor<std::uint16_t>({0, 1, 2, 2, 1, 3}, "SCALAR");
        const auto again = static_cast<std::uint8_t>(visibility == 2 ? 3 : 0);
        primitive["extensions"][extensionName] = {
            {"visibility", model.accessor(packed({2, visibility, 2, again, 2, 2}), "SCALAR")}};
        model.root({{"mesh", model.mesh(primitive)}});
        const Scene scene{load(model)};
        EXPECT_EQ(scene::topologyOf(scene, 0).creases[1], visibility == 2) << int{visibility};
        EXPECT_EQ(scene::patchNumbersOf(scene).count, visibility == 2 ? 2U : 1U);
    }
}

// Each marked edge by the middle between its ends.
std::vector<glm::dvec3> middlesOfMarked(const Mesh& mesh) {
    std::vector<glm::dvec3> middles;
    for (std::uint32_t h = 0; h < mesh.edges.size(); ++h)
        if (mesh.edges[h].has(EdgeKind::Marked))
            middles.push_back(0.5 *
                              (position(mesh, mesh.indices[h]) + position(mesh, mesh.indices[mesh::nextHalfEdge(h)])));
    return middles;
}

TEST_F(EdgeVisibility, StaysWithItsEdges) {
    Model model;
    std::vector<float> points = square;
    points.insert(points.begin(), {9, 9, 9});  // unused, to be dropped
    Json primitive = positions(model.accessor(points, "VEC3"));
    primitive["indices"] = model.accessor<std::uint16_t>({1, 2, 3, 3, 2, 4}, "SCALAR");
    primitive["material"] = 0;
    primitive["extensions"][extensionName] = {{"visibility", model.accessor(packed({2, 0, 0, 0, 0, 2}), "SCALAR")}};
    Json sided = primitive;
    sided["material"] = 1;
    model.add("materials", {{"doubleSided", true}});
    model.add("materials", {{"doubleSided", false}});
    model.add("meshes", {{"primitives", {primitive, sided}}});
    const std::vector<double> mirrored{-2, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};  // and distorted
    model.root({{"mesh", 0}, {"matrix", mirrored}});
    LoadSettings settings;
    settings.backFaces = BackFaces::Material;
    const Scene scene{load(model, settings), settings};
    EXPECT_EQ(scene::oneSidedTriangles(scene, 0), 2U);
    const std::vector<glm::dvec3> expected{{-1, 0, 0}, {-1, 1, 0}, {-1, 0, 0}, {-1, 1, 0}};
    expectNear(middlesOfMarked(scene.meshes()[0]), expected);
}

TEST_F(EdgeVisibility, ThatIsMalformedIsRefused) {
    const auto refusalWith = [&](const std::function<Json(Model&)>& extension) {
        return refusal(squareWith(extension));
    };
    const std::string where = "mesh 0, primitive 0: EXT_mesh_primitive_edge_visibility: ";
    EXPECT_THAT(refusalWith([](Model&) { return Json::object(); }),
                HasSubstr(where + "expected visibility or lineStrings, found neither"));
    EXPECT_THAT(refusal(squareWithVisibility({2, 2, 2})),
                HasSubstr(where + "visibility: expected 2 bytes for 2 triangles, found 1"));
    EXPECT_THAT(refusalWith([](Model&) {
                    return Json{{"visibility", 7}};
                }),
                HasSubstr("expected an accessor below 2, found 7"));
    EXPECT_THAT(refusalWith([](Model&) {
                    return Json{{"visibility", "all"}};
                }),
                HasSubstr("visibility: expected the number of an accessor"));
    EXPECT_THAT(refusalWith([](Model&) {
                    return Json{{"visibility", 1}};
                }),
                HasSubstr("expected SCALAR of UNSIGNED_BYTE, found SCALAR of UNSIGNED_SHORT"));
    EXPECT_THAT(refusalWith([](Model&) {
                    return Json{{"lineStrings", 1}};
                }),
                HasSubstr("lineStrings: expected an array"));
    EXPECT_THAT(refusalWith([](Model&) {
                    return Json{{"lineStrings", {{{"material", 1}}}}};
                }),
                HasSubstr("line string 0: indices: expected the number of an accessor"));
    EXPECT_THAT(refusalWith([](Model&) {
                    return Json{{"lineStrings", {7}}};
                }),
                HasSubstr("line string 0: indices: expected the number of an accessor"));
    EXPECT_THAT(refusalWith([](Model&) { return Json{{"lineStrings", {{{"indices", -3}}}}}; }), HasSubstr("found -3"));
    EXPECT_THAT(refusal(squareWithLines({0, 1, 4})),
                HasSubstr("indices: expected vertex indices below 4, found 4 at index 2"));
}

}  // namespace
}  // namespace inkedge::gltf
