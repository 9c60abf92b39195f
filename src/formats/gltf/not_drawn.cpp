#include "formats/gltf/not_drawn.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include <inkedge/error.h>

#include "formats/text.h"

namespace inkedge::gltf {
namespace {

using formats::counted;

std::set<int> meshesOf(const tinygltf::Model& model, std::span<const DrawnNode> drawn) {
    std::set<int> meshes;
    for (const DrawnNode& each : drawn)
        if (model.nodes[each.node].mesh != -1) meshes.insert(model.nodes[each.node].mesh);
    return meshes;
}

// The scenes that have meshes, of which one may be meant: empty if there is none, or one that is damaged.
std::vector<std::string> scenesWithMeshes(const tinygltf::Model& model, const Nodes& nodes) {
    std::vector<std::string> found;
    for (std::size_t i = 0; i < model.scenes.size(); ++i) {
        try {
            const std::size_t count = meshesOf(model, nodesOfScene(model, nodes, static_cast<int>(i))).size();
            if (count > 0)
                found.push_back(fmt::format("scene {} has {}: --scene {}", i, counted(count, "mesh", "meshes"), i));
        } catch (const Error&) {  // it is told of when that scene is asked for
        }
    }
    return found;
}

std::vector<std::string> withoutMesh(const tinygltf::Model& model, const Nodes& nodes, std::optional<int> scene) {
    if (model.meshes.empty()) {
        std::vector<std::string> found{"no mesh"};
        if (!model.nodes.empty()) found.push_back(counted(model.nodes.size(), "node"));
        if (!model.cameras.empty()) found.push_back(counted(model.cameras.size(), "camera"));
        return found;
    }
    std::vector<std::string> others = scenesWithMeshes(model, nodes);
    if (others.empty()) return {counted(model.meshes.size(), "mesh", "meshes") + " that no node draws"};
    const int drawnScene = scene.value_or(std::max(model.defaultScene, 0));
    others.insert(others.begin(), fmt::format("scene {} is empty", drawnScene));
    return others;
}

}  // namespace

void NotDrawn::addPoints(const tinygltf::Model& model, const tinygltf::Primitive& primitive) {
    const auto position = primitive.attributes.find("POSITION");
    const int accessor =
        primitive.indices != -1 || position == primitive.attributes.end() ? primitive.indices : position->second;
    if (accessor < 0 || static_cast<std::size_t>(accessor) >= model.accessors.size()) return;
    points += model.accessors[static_cast<std::size_t>(accessor)].count;
}

std::vector<std::string> whatIsThere(const tinygltf::Model& model, const Nodes& nodes, std::span<const DrawnNode> drawn,
                                     std::optional<int> scene, const NotDrawn& notDrawn) {
    const std::set<int> meshes = meshesOf(model, drawn);
    if (meshes.empty()) return withoutMesh(model, nodes, scene);
    std::vector<std::string> found;
    const bool allHidden = std::ranges::none_of(
        drawn, [&](const DrawnNode& each) { return each.visible && model.nodes[each.node].mesh != -1; });
    if (allHidden) found.push_back(counted(meshes.size(), "mesh", "meshes") + " in hidden nodes");
    if (notDrawn.points > 0) found.push_back(counted(notDrawn.points, "point"));
    if (notDrawn.maskedAway > 0) found.emplace_back("all triangles are masked away");
    if (notDrawn.maskedLines > 0) found.emplace_back("all lines are masked away");
    if (notDrawn.transparent > 0) found.emplace_back("all triangles are transparent, which are not wanted");
    if (found.empty()) found.push_back(counted(meshes.size(), "mesh", "meshes") + " without triangles or lines");
    return found;
}

}  // namespace inkedge::gltf
