#include "formats/gltf/nodes.h"

#include <algorithm>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>

namespace inkedge::gltf {

namespace {

constexpr const char* visibilityExtension = "KHR_node_visibility";

const std::vector<double>& sized(const std::vector<double>& numbers, std::size_t size, std::string_view property) {
    if (!numbers.empty() && numbers.size() != size)
        base::refuse(fmt::format("expected {} numbers as {}, found {}", size, property, numbers.size()));
    return numbers;
}

glm::dmat4 affine(const std::vector<double>& numbers) {
    constexpr double rounding = 1e-6;
    glm::dmat4 matrix = glm::make_mat4(numbers.data());
    const glm::dvec4 last = glm::row(matrix, 3);
    if (!(glm::length(last - glm::dvec4{0, 0, 0, 1}) <= rounding))
        base::refuse(
            fmt::format("expected a matrix with last row 0 0 0 1, found {} {} {} {}", last.x, last.y, last.z, last.w));
    return glm::row(matrix, 3, glm::dvec4{0, 0, 0, 1});
}

glm::dmat4 localTransform(const tinygltf::Node& node) {
    if (!sized(node.matrix, 16, "matrix").empty()) return affine(node.matrix);
    glm::dvec3 translation{0.0};
    glm::dvec4 rotation{0, 0, 0, 1};
    glm::dvec3 scale{1.0};
    if (!sized(node.translation, 3, "translation").empty()) translation = glm::make_vec3(node.translation.data());
    if (!sized(node.rotation, 4, "rotation").empty()) rotation = glm::make_vec4(node.rotation.data());
    if (!sized(node.scale, 3, "scale").empty()) scale = glm::make_vec3(node.scale.data());
    return compose(translation, rotation, scale);
}

// The parent of every node, -1 for roots.
std::vector<int> parentsOf(const tinygltf::Model& model) {
    std::vector<int> parents(model.nodes.size(), -1);
    for (std::size_t node = 0; node < model.nodes.size(); ++node) {
        for (const int child : model.nodes[node].children) {
            base::within(nodeLabel(model, node), [&] { at(model.nodes, child, "a child node"); });
            int& parent = parents[static_cast<std::size_t>(child)];
            if (parent != -1)
                base::refuse(fmt::format("{}: expected one parent, found nodes {} and {}",
                                         nodeLabel(model, static_cast<std::size_t>(child)), parent, node));
            parent = static_cast<int>(node);
        }
    }
    return parents;
}

[[noreturn]] void refuseCycle(const tinygltf::Model& model, const std::vector<int>& parents, std::size_t below) {
    for (std::size_t step = 0; step < parents.size(); ++step) below = static_cast<std::size_t>(parents[below]);
    base::refuse(nodeLabel(model, below) + ": expected a tree of nodes, found a node among its own descendants");
}

bool isHidden(const tinygltf::Node& node) {
    const auto extension = node.extensions.find(visibilityExtension);
    if (extension == node.extensions.end()) return false;
    const tinygltf::Value& visible = member(extension->second, "visible");
    return visible.IsBool() && !visible.Get<bool>();
}

const std::vector<int>* rootsOf(const tinygltf::Model& model, std::optional<int> scene) {
    if (scene && (*scene < 0 || static_cast<std::size_t>(*scene) >= model.scenes.size())) {
        const std::string found = model.scenes.empty() ? "a file without scenes" : fmt::format("{}", *scene);
        throw Error{Error::Kind::Usage,
                    fmt::format("--scene: expected a scene below {}, found {}", model.scenes.size(), found)};
    }
    if (scene) return &model.scenes[static_cast<std::size_t>(*scene)].nodes;
    if (model.defaultScene == -1 && model.scenes.empty()) return nullptr;
    return &at(model.scenes, model.defaultScene == -1 ? 0 : model.defaultScene, "a scene").nodes;
}

}  // namespace

void setVisible(tinygltf::Node& node, bool visible) {
    node.extensions[visibilityExtension] =
        tinygltf::Value{tinygltf::Value::Object{{"visible", tinygltf::Value{visible}}}};
}

glm::dmat4 compose(const glm::dvec3& translation, const glm::dvec4& rotation, const glm::dvec3& scale) {
    const double length = glm::length(rotation);
    const glm::dvec4 unit = length > 0.0 ? rotation / length : glm::dvec4{0, 0, 0, 1};
    glm::dmat4 matrix = glm::mat4_cast(glm::dquat{unit.w, unit.x, unit.y, unit.z});
    for (int axis = 0; axis < 3; ++axis) matrix[axis] *= scale[axis];
    matrix[3] = glm::dvec4{translation, 1.0};
    return matrix;
}

Nodes nodeTransforms(const tinygltf::Model& model, const LoadLimits& limits) {
    if (model.nodes.size() > limits.nodes)
        base::refuse(
            fmt::format("expected at most {} nodes, found {}; raise max-nodes", limits.nodes, model.nodes.size()));
    Nodes nodes{parentsOf(model), std::vector<glm::dmat4>(model.nodes.size())};
    const std::vector<int>& parents = nodes.parents;
    std::vector<std::uint64_t> depths(model.nodes.size(), 0);  // 0: not reached
    std::vector<std::size_t> order;
    for (std::size_t node = 0; node < parents.size(); ++node)
        if (parents[node] == -1) order.push_back(node);
    for (std::size_t i = 0; i < order.size(); ++i) {
        const std::size_t node = order[i];
        const auto parent = static_cast<std::size_t>(parents[node]);
        depths[node] = parents[node] == -1 ? 1 : depths[parent] + 1;
        base::within(nodeLabel(model, node), [&] {
            if (depths[node] > limits.nodeDepth)
                base::refuse(fmt::format("expected nodes at most {} deep, found deeper; raise max-node-depth",
                                         limits.nodeDepth));
            const glm::dmat4 local = localTransform(model.nodes[node]);
            nodes.toWorld[node] = parents[node] == -1 ? local : nodes.toWorld[parent] * local;
            if (!finite(nodes.toWorld[node])) base::refuse("expected a finite transform, found an infinite one");
        });
        for (const int child : model.nodes[node].children) order.push_back(static_cast<std::size_t>(child));
    }
    for (std::size_t node = 0; node < depths.size(); ++node)
        if (depths[node] == 0) refuseCycle(model, parents, node);
    return nodes;
}

std::vector<DrawnNode> nodesOfScene(const tinygltf::Model& model, const Nodes& nodes, std::optional<int> scene) {
    std::vector<int> next;
    if (const std::vector<int>* roots = rootsOf(model, scene)) {
        next.assign(roots->rbegin(), roots->rend());
    } else {
        for (std::size_t node = nodes.parents.size(); node-- > 0;)
            if (nodes.parents[node] == -1) next.push_back(static_cast<int>(node));
    }
    std::vector<DrawnNode> order;
    std::vector<bool> reached(model.nodes.size(), false);
    std::vector<bool> hidden(model.nodes.size(), false);
    while (!next.empty()) {
        at(model.nodes, next.back(), "a node of the scene");
        const auto node = static_cast<std::size_t>(next.back());
        next.pop_back();
        if (reached[node]) base::refuse(nodeLabel(model, node) + ": expected it once in the scene, found it twice");
        reached[node] = true;
        const int parent = nodes.parents[node];
        hidden[node] = isHidden(model.nodes[node]) || (parent != -1 && hidden[static_cast<std::size_t>(parent)]);
        order.push_back({node, !hidden[node]});
        const std::vector<int>& children = model.nodes[node].children;
        next.insert(next.end(), children.rbegin(), children.rend());
    }
    return order;
}

}  // namespace inkedge::gltf
