#include "scene/names.h"

#include <numeric>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "scene/prepared.h"

namespace inkedge {
namespace scene {
namespace {

constexpr std::size_t maxPath = 1024;  // bytes: trees may be a million nodes deep
constexpr std::string_view leftOut = "...";

// Of each node the nearest node above it that has a name.
std::vector<std::uint32_t> namedParents(const std::vector<SceneNode>& nodes) {
    std::vector<std::uint32_t> parents;
    parents.reserve(nodes.size());
    for (const SceneNode& node : nodes) {
        const bool skips = node.parent != noNode && nodes[node.parent].name.empty();
        parents.push_back(skips ? parents[node.parent] : node.parent);
    }
    return parents;
}

std::string pathOf(const Instance& instance, const std::vector<SceneNode>& nodes,
                   const std::vector<std::uint32_t>& parents) {
    std::vector<std::string_view> names;  // from the instance up
    std::size_t size = 0;
    const auto add = [&](std::string_view name) {
        names.push_back(name);
        size += name.size() + 1;
    };
    if (!instance.name.empty()) add(instance.name);
    std::uint32_t node = instance.node == noNode ? noNode : parents[instance.node];
    for (; node != noNode && size + nodes[node].name.size() <= maxPath; node = parents[node]) add(nodes[node].name);
    if (node != noNode) add(leftOut);
    std::string path;
    for (auto name = names.rbegin(); name != names.rend(); ++name) {
        if (!path.empty()) path += '/';
        path += *name;
    }
    return path;
}

std::vector<std::uint32_t> materialsOf(const Mesh& mesh) {
    std::set<std::uint32_t> ids;
    std::uint32_t last = 0;  // triangles of one material mostly stand together
    for (const std::uint32_t id : mesh.materials) {
        if (id != last && id != 0) ids.insert(id);
        last = id;
    }
    return {ids.begin(), ids.end()};
}

}  // namespace

SceneNames namesOf(const Scene& scene, std::span<const std::uint32_t> ids) {
    const std::vector<glm::dmat4>& transforms = preparedOf(scene)->transforms;
    const std::vector<std::uint32_t> parents = namedParents(scene.nodes());
    std::vector<std::optional<std::vector<std::uint32_t>>> materials(scene.meshes().size());
    SceneNames names;
    names.instances.reserve(ids.size());
    for (const std::uint32_t id : ids) {
        const Instance& instance = scene.instances()[id - 1];
        const Mesh& mesh = scene.meshes()[instance.mesh];
        auto& used = materials[instance.mesh];
        if (!used) used = materialsOf(mesh);
        names.instances.push_back({id, pathOf(instance, scene.nodes(), parents), mesh.name, *used, transforms[id - 1]});
    }
    for (const Material& material : scene.materials()) names.materials.push_back(material.name);
    return names;
}

}  // namespace scene

SceneNames namesOf(const Scene& scene) {
    std::vector<std::uint32_t> ids(scene.instances().size());
    std::iota(ids.begin(), ids.end(), 1U);
    return scene::namesOf(scene, ids);
}

}  // namespace inkedge
