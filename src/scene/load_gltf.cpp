#include "scene/load_gltf.h"

#include <algorithm>
#include <cmath>
#include <fstream>  // tiny_gltf.h needs it but leaves it out with TINYGLTF_NO_FS
#include <limits>
#include <map>
#include <new>
#include <numbers>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <glm/gtc/matrix_access.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#define TINYGLTF_IMPLEMENTATION
#define TINYGLTF_NO_EXTERNAL_IMAGE
#define TINYGLTF_NO_FS
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#include <tiny_gltf.h>

#include "scene/gltf_accessor.h"
#include "scene/gltf_file.h"
#include "scene/gltf_triangles.h"
#include "scene/load_message.h"

namespace inkedge {
namespace {

using gltf::Component;
using gltf::Expected;
using load::label;
using load::refuse;
using load::within;

constexpr std::uint64_t maximumElements = std::uint64_t{1} << 28;  // vertices and indices of all meshes drawn
constexpr std::uint64_t maximumInstances = std::uint64_t{1} << 24;

// KHR_mesh_quantization included.
const Expected anyPosition{gltf::vec3,
                           {Component::Float, Component::Int8, Component::Uint8, Component::Int16, Component::Uint16}};
const Expected anyNormal{gltf::vec3, {Component::Float, Component::Int8, Component::Int16}};
const Expected anyRotation{gltf::vec4, {Component::Float, Component::Int8, Component::Int16}};
const Expected anyWeights{gltf::vec4, {Component::Float, Component::Uint8, Component::Uint16}};
const Expected anyJoints{gltf::vec4, {Component::Uint8, Component::Uint16}};
const Expected floatVec3{gltf::vec3, {Component::Float}};
const Expected floatMat4{gltf::mat4, {Component::Float}};

// ---- tinygltf's model

using Buffers = std::vector<std::vector<std::uint8_t>>;

// Lets tinygltf reach no file: a buffer's uri is its number among those already read.
tinygltf::FsCallbacks servedFrom(Buffers& buffers) {
    const auto exists = [](const std::string&, void*) { return true; };
    const auto expand = [](const std::string& name, void*) { return name; };
    const auto read = [](std::vector<unsigned char>* bytes, std::string*, const std::string& name, void* all) {
        *bytes = std::move(static_cast<Buffers*>(all)->at(std::stoul(name)));
        return true;
    };
    return {exists, expand, read, nullptr, &buffers};
}

// The first line of tinygltf's errors that is one: a skin may do without inverse bind matrices.
std::string firstError(std::string_view errors) {
    while (!errors.empty()) {
        const std::string_view line = errors.substr(0, errors.find('\n'));
        if (!line.empty() && !line.starts_with("'inverseBindMatrices' property is missing"))
            return load::printable(line.substr(0, 300));
        errors.remove_prefix(std::min(errors.size(), line.size() + 1));
    }
    return {};
}

tinygltf::Model parse(gltf::File file) {
    if (file.json.size() > std::numeric_limits<unsigned int>::max())
        refuse(fmt::format("expected less than 4 GiB of JSON, found {} bytes", file.json.size()));
    tinygltf::TinyGLTF parser;
    parser.SetFsCallbacks(servedFrom(file.buffers));
    tinygltf::Model model;
    std::string errors;
    std::string warnings;
    const bool parsed = parser.LoadASCIIFromString(&model, &errors, &warnings, file.json.data(),
                                                   static_cast<unsigned int>(file.json.size()), "");
    // Some errors only make it leave an element out.
    const std::string error = firstError(errors);
    if (!parsed || !error.empty()) refuse("expected glTF 2.0, found: " + error);
    return model;
}

template <class T>
const T& at(const std::vector<T>& all, int index, std::string_view kind) {
    if (index < 0 || static_cast<std::size_t>(index) >= all.size())
        refuse(fmt::format("expected {} below {}, found {}", kind, all.size(), index));
    return all[static_cast<std::size_t>(index)];
}

std::string nodeLabel(const tinygltf::Model& model, std::size_t node) {
    return label("node", node, model.nodes[node].name);
}

// ---- accessors

gltf::Elements elementsOf(const tinygltf::Model& model, int bufferView, std::uint64_t offset, std::uint64_t stride) {
    const tinygltf::BufferView& view = at(model.bufferViews, bufferView, "a bufferView");
    return within(label("bufferView", static_cast<std::size_t>(bufferView)), [&] {
        const tinygltf::Buffer& buffer = at(model.buffers, view.buffer, "a buffer");
        return gltf::Elements{gltf::partOf(buffer.data, view.byteOffset, view.byteLength), offset, stride};
    });
}

gltf::ElementType elementType(int type) {
    switch (type) {
        case TINYGLTF_TYPE_SCALAR:
            return gltf::scalar;
        case TINYGLTF_TYPE_VEC2:
            return {"VEC2", 2};
        case TINYGLTF_TYPE_VEC3:
            return gltf::vec3;
        case TINYGLTF_TYPE_VEC4:
            return gltf::vec4;
        case TINYGLTF_TYPE_MAT2:
            return {"MAT2", 4};
        case TINYGLTF_TYPE_MAT3:
            return {"MAT3", 9};
        default:
            return gltf::mat4;
    }
}

std::uint64_t notNegative(int number) {
    if (number < 0) refuse(fmt::format("expected a number of at least 0, found {}", number));
    return static_cast<std::uint64_t>(number);
}

gltf::Accessor describe(const tinygltf::Model& model, const tinygltf::Accessor& source) {
    gltf::Accessor accessor{
        elementType(source.type), Component{source.componentType}, source.normalized, source.count, {}, {}};
    if (source.bufferView != -1) {
        const std::uint64_t stride = at(model.bufferViews, source.bufferView, "a bufferView").byteStride;
        accessor.elements = elementsOf(model, source.bufferView, source.byteOffset, stride);
    }
    if (source.sparse.isSparse) {
        const auto& indices = source.sparse.indices;
        const auto& values = source.sparse.values;
        accessor.sparse =
            gltf::Accessor::Sparse{notNegative(source.sparse.count), Component{indices.componentType},
                                   elementsOf(model, indices.bufferView, notNegative(indices.byteOffset), 0),
                                   elementsOf(model, values.bufferView, notNegative(values.byteOffset), 0)};
    }
    return accessor;
}

// Names an accessor and what it is for in whatever goes wrong with it.
template <class Read>
auto withAccessor(const tinygltf::Model& model, int index, std::string_view use, Read&& read) {
    return within(std::string{use}, [&] {
        const tinygltf::Accessor& source = at(model.accessors, index, "an accessor");
        return within(label("accessor", static_cast<std::size_t>(index)),
                      [&] { return read(describe(model, source)); });
    });
}

std::vector<double> readNumbers(const tinygltf::Model& model, int index, std::string_view use,
                                const Expected& expected) {
    return withAccessor(model, index, use,
                        [&](const gltf::Accessor& accessor) { return gltf::readNumbers(accessor, expected); });
}

template <class Vector>
std::vector<Vector> readVectors(const tinygltf::Model& model, int index, std::string_view use,
                                const Expected& expected) {
    constexpr std::size_t components = static_cast<std::size_t>(Vector::length());
    const std::vector<double> numbers = readNumbers(model, index, use, expected);
    std::vector<Vector> vectors(numbers.size() / components);
    for (std::size_t i = 0; i < numbers.size(); ++i)
        vectors[i / components][static_cast<int>(i % components)] = numbers[i];
    return vectors;
}

// One vector for each of count vertices, or none if the attribute is missing.
template <class Vector>
std::vector<Vector> readAttribute(const tinygltf::Model& model, const std::map<std::string, int>& attributes,
                                  const std::string& name, const Expected& expected, std::size_t count) {
    const auto attribute = attributes.find(name);
    if (attribute == attributes.end()) return {};
    std::vector<Vector> vectors = readVectors<Vector>(model, attribute->second, name, expected);
    if (vectors.size() != count)
        refuse(fmt::format("{}: expected as many elements as POSITION has, {}, found {}", name, count, vectors.size()));
    return vectors;
}

// 1 + the number of a primitive's material; 0: none. Which materials there are does not matter.
std::uint32_t materialOf(const tinygltf::Primitive& primitive) {
    if (primitive.material < -1) refuse(fmt::format("expected a material of at least 0, found {}", primitive.material));
    return static_cast<std::uint32_t>(primitive.material + 1);
}

// ---- nodes

bool finite(const glm::dmat4& matrix) {
    return std::all_of(glm::value_ptr(matrix), glm::value_ptr(matrix) + 16, [](double x) { return std::isfinite(x); });
}

glm::dmat4 compose(const glm::dvec3& translation, const glm::dvec4& rotation, const glm::dvec3& scale) {
    const double length = glm::length(rotation);
    const glm::dvec4 unit = length > 0.0 ? rotation / length : glm::dvec4{0, 0, 0, 1};
    glm::dmat4 matrix = glm::mat4_cast(glm::dquat{unit.w, unit.x, unit.y, unit.z});
    for (int axis = 0; axis < 3; ++axis) matrix[axis] *= scale[axis];
    matrix[3] = glm::dvec4{translation, 1.0};
    return matrix;
}

const std::vector<double>& sized(const std::vector<double>& numbers, std::size_t size, std::string_view property) {
    if (!numbers.empty() && numbers.size() != size)
        refuse(fmt::format("expected {} numbers as {}, found {}", size, property, numbers.size()));
    return numbers;
}

glm::dmat4 affine(const std::vector<double>& numbers) {
    constexpr double rounding = 1e-6;
    glm::dmat4 matrix = glm::make_mat4(numbers.data());
    const glm::dvec4 last = glm::row(matrix, 3);
    if (!(glm::length(last - glm::dvec4{0, 0, 0, 1}) <= rounding))
        refuse(
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

// Every node's parent, -1 for roots.
std::vector<int> parentsOf(const tinygltf::Model& model) {
    std::vector<int> parents(model.nodes.size(), -1);
    for (std::size_t node = 0; node < model.nodes.size(); ++node) {
        for (const int child : model.nodes[node].children) {
            within(nodeLabel(model, node), [&] { at(model.nodes, child, "a child node"); });
            int& parent = parents[static_cast<std::size_t>(child)];
            if (parent != -1)
                refuse(fmt::format("{}: expected one parent, found nodes {} and {}",
                                   nodeLabel(model, static_cast<std::size_t>(child)), parent, node));
            parent = static_cast<int>(node);
        }
    }
    return parents;
}

[[noreturn]] void refuseCycle(const tinygltf::Model& model, const std::vector<int>& parents, std::size_t below) {
    for (std::size_t step = 0; step < parents.size(); ++step) below = static_cast<std::size_t>(parents[below]);
    refuse(nodeLabel(model, below) + ": expected a tree of nodes, found a node among its own descendants");
}

// Every node's transform to world space. Follows children without recursion: chains may be long.
std::vector<glm::dmat4> worldTransforms(const tinygltf::Model& model, const std::vector<int>& parents) {
    std::vector<glm::dmat4> worlds(model.nodes.size());
    std::vector<std::size_t> order;
    std::vector<bool> reached(model.nodes.size(), false);
    for (std::size_t node = 0; node < parents.size(); ++node)
        if (parents[node] == -1) order.push_back(node);
    for (std::size_t i = 0; i < order.size(); ++i) {
        const std::size_t node = order[i];
        reached[node] = true;
        within(nodeLabel(model, node), [&] {
            const glm::dmat4 local = localTransform(model.nodes[node]);
            worlds[node] = parents[node] == -1 ? local : worlds[static_cast<std::size_t>(parents[node])] * local;
            if (!finite(worlds[node])) refuse("expected a finite transform, found an infinite one");
        });
        for (const int child : model.nodes[node].children) order.push_back(static_cast<std::size_t>(child));
    }
    for (std::size_t node = 0; node < reached.size(); ++node)
        if (!reached[node]) refuseCycle(model, parents, node);
    return worlds;
}

// The nodes drawn, parents before their children: the default scene's, else the first scene's, else all.
std::vector<std::size_t> nodesDrawn(const tinygltf::Model& model, const std::vector<int>& parents) {
    std::vector<int> roots;
    if (model.defaultScene != -1 || !model.scenes.empty()) {
        roots = at(model.scenes, model.defaultScene == -1 ? 0 : model.defaultScene, "a scene").nodes;
    } else {
        for (std::size_t node = 0; node < parents.size(); ++node)
            if (parents[node] == -1) roots.push_back(static_cast<int>(node));
    }
    std::vector<std::size_t> order;
    std::vector<bool> reached(model.nodes.size(), false);
    std::vector<int> next{roots.rbegin(), roots.rend()};
    while (!next.empty()) {
        at(model.nodes, next.back(), "a node of the scene");
        const auto node = static_cast<std::size_t>(next.back());
        next.pop_back();
        if (reached[node]) refuse(nodeLabel(model, node) + ": expected it once in the scene, found it twice");
        reached[node] = true;
        order.push_back(node);
        const std::vector<int>& children = model.nodes[node].children;
        next.insert(next.end(), children.rbegin(), children.rend());
    }
    return order;
}

// The copies that EXT_mesh_gpu_instancing makes of a node's mesh, in the node's space; without it, one.
std::vector<glm::dmat4> copiesOf(const tinygltf::Model& model, const tinygltf::Node& node) {
    const auto extension = node.extensions.find("EXT_mesh_gpu_instancing");
    if (extension == node.extensions.end()) return {glm::dmat4{1.0}};
    const tinygltf::Value& attributes = extension->second.Get("attributes");
    std::optional<std::size_t> count;
    const auto read = [&]<class Vector>(const char* name, const Expected& expected, Vector otherwise) {
        std::vector<Vector> vectors;
        const tinygltf::Value& index = attributes.Get(name);
        if (index.IsInt()) {
            vectors = readVectors<Vector>(model, index.GetNumberAsInt(), name, expected);
            if (count && *count != vectors.size())
                refuse(fmt::format("{}: expected as many instances as before, {}, found {}", name, *count,
                                   vectors.size()));
            count = vectors.size();
        }
        return [vectors = std::move(vectors), otherwise](std::size_t i) {
            return vectors.empty() ? otherwise : vectors[i];
        };
    };
    return within("EXT_mesh_gpu_instancing", [&] {
        const auto translation = read("TRANSLATION", floatVec3, glm::dvec3{0.0});
        const auto rotation = read("ROTATION", anyRotation, glm::dvec4{0, 0, 0, 1});
        const auto scale = read("SCALE", floatVec3, glm::dvec3{1.0});
        std::vector<glm::dmat4> copies;
        for (std::size_t i = 0; i < count.value_or(1); ++i)
            copies.push_back(compose(translation(i), rotation(i), scale(i)));
        return copies;
    });
}

// ---- cameras

// A camera's transform without scale, shear and reflection, which glTF has a camera ignore.
glm::dmat4 rigid(const glm::dmat4& transform) {
    const auto unitOr = [](const glm::dvec3& v, const glm::dvec3& otherwise) {
        const double length = glm::length(v);
        return length > 0.0 ? v / length : otherwise;
    };
    const glm::dvec3 z = unitOr(glm::dvec3{transform[2]}, {0, 0, 1});
    const glm::dvec3 across = std::abs(z.y) < 0.9 ? glm::dvec3{0, 1, 0} : glm::dvec3{1, 0, 0};
    const glm::dvec3 x = unitOr(glm::cross(glm::dvec3{transform[1]}, z), glm::normalize(glm::cross(across, z)));
    return {glm::dvec4{x, 0}, glm::dvec4{glm::cross(z, x), 0}, glm::dvec4{z, 0}, transform[3]};
}

// The camera's lens; or, in words, why it has none.
std::optional<std::string> readLens(const tinygltf::Camera& source, SceneCamera& camera) {
    if (source.type == "perspective") {
        camera.viewAngle = source.perspective.yfov * 180.0 / std::numbers::pi;
        if (camera.viewAngle > 0.0 && camera.viewAngle < 180.0) return {};
        return fmt::format("a yfov between 0 and pi, found {}", source.perspective.yfov);
    }
    camera.orthographicHeight = 2.0 * source.orthographic.ymag;
    if (camera.orthographicHeight > 0.0 && std::isfinite(camera.orthographicHeight)) return {};
    return fmt::format("a ymag over 0, found {}", source.orthographic.ymag);
}

// ---- meshes

// Triangles as the file has them, before they move to their origin.
struct Shape {
    std::vector<glm::dvec3> positions;
    std::vector<glm::dvec3> normals;  // as many; (0, 0, 0) where the file has none
    std::vector<std::uint32_t> indices;
    std::vector<std::uint32_t> materials;  // one a triangle; 0: none
    bool authored = false;                 // some normals are the file's
};

// How a mesh is bent out of the shape that the file stores.
struct Pose {
    std::vector<double> weights;     // of the morph targets; empty: none is on
    std::vector<glm::dmat4> joints;  // joint -> world; empty: no skin
};

void addScaled(std::vector<glm::dvec3>& vectors, const std::vector<glm::dvec3>& offsets, double weight) {
    for (std::size_t i = 0; i < offsets.size() && i < vectors.size(); ++i) vectors[i] += weight * offsets[i];
}

void morph(const tinygltf::Model& model, const tinygltf::Primitive& primitive, const std::vector<double>& weights,
           Shape& part) {
    for (std::size_t i = 0; i < weights.size() && i < primitive.targets.size(); ++i) {
        if (weights[i] == 0.0) continue;
        within(label("target", i), [&] {
            const std::size_t count = part.positions.size();
            const auto read = [&](const char* attribute, const Expected& expected) {
                return readAttribute<glm::dvec3>(model, primitive.targets[i], attribute, expected, count);
            };
            addScaled(part.positions, read("POSITION", anyPosition), weights[i]);
            if (part.authored) addScaled(part.normals, read("NORMAL", anyNormal), weights[i]);
        });
    }
}

// A vertex's joint matrix, glTF 2.0, section 3.7.3.3: the sum of its joints' by weight.
glm::dmat4 blend(const std::vector<glm::dmat4>& joints, const glm::dvec4& chosen, const glm::dvec4& weights) {
    const double sum = weights.x + weights.y + weights.z + weights.w;
    const glm::dvec4 shares = sum > 0.0 && std::isfinite(sum) ? weights / sum : glm::dvec4{1, 0, 0, 0};
    glm::dmat4 matrix{0.0};
    for (int i = 0; i < 4; ++i) {
        if (shares[i] == 0.0) continue;
        if (chosen[i] >= static_cast<double>(joints.size()))
            refuse(fmt::format("JOINTS_0: expected joints below {}, found {}", joints.size(), chosen[i]));
        matrix += shares[i] * joints[static_cast<std::size_t>(chosen[i])];
    }
    return matrix;
}

// The inverse transpose, whatever the matrix's determinant, but for its positive scale.
glm::dmat3 normalTransform(const glm::dmat3& matrix) {
    const glm::dmat3 cofactors{glm::cross(matrix[1], matrix[2]), glm::cross(matrix[2], matrix[0]),
                               glm::cross(matrix[0], matrix[1])};
    return glm::dot(matrix[0], cofactors[0]) < 0.0 ? -cofactors : cofactors;
}

void skin(const tinygltf::Model& model, const tinygltf::Primitive& primitive, const std::vector<glm::dmat4>& joints,
          Shape& part) {
    const std::size_t count = part.positions.size();
    const auto chosen = readAttribute<glm::dvec4>(model, primitive.attributes, "JOINTS_0", anyJoints, count);
    const auto weights = readAttribute<glm::dvec4>(model, primitive.attributes, "WEIGHTS_0", anyWeights, count);
    if (chosen.size() != count || weights.size() != count)
        refuse("expected JOINTS_0 and WEIGHTS_0 in a mesh with a skin, found one of them missing");
    for (std::size_t i = 0; i < count; ++i) {
        const glm::dmat4 toWorld = blend(joints, chosen[i], weights[i]);
        part.positions[i] = glm::dvec3{toWorld * glm::dvec4{part.positions[i], 1.0}};
        part.normals[i] = normalTransform(glm::dmat3{toWorld}) * part.normals[i];
    }
}

void checkPositions(const std::vector<glm::dvec3>& positions) {
    constexpr double largest = std::numeric_limits<float>::max();
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const glm::dvec3& p = positions[i];
        if (!(std::abs(p.x) <= largest && std::abs(p.y) <= largest && std::abs(p.z) <= largest))
            refuse(fmt::format("expected finite positions, found ({}, {}, {}) at vertex {}", p.x, p.y, p.z, i));
    }
}

void normalize(std::vector<glm::dvec3>& normals) {
    for (glm::dvec3& normal : normals) {
        const double length = glm::length(normal);
        normal = length > 0.0 && std::isfinite(length) ? normal / length : glm::dvec3{0.0};
    }
}

void append(Shape& shape, const Shape& part) {
    const auto first = static_cast<std::uint32_t>(shape.positions.size());
    shape.positions.insert(shape.positions.end(), part.positions.begin(), part.positions.end());
    shape.normals.insert(shape.normals.end(), part.normals.begin(), part.normals.end());
    for (const std::uint32_t index : part.indices) shape.indices.push_back(first + index);
    shape.materials.insert(shape.materials.end(), part.materials.begin(), part.materials.end());
    shape.authored = shape.authored || part.authored;
}

glm::dvec3 centreOf(const std::vector<glm::dvec3>& positions) {
    glm::dvec3 low = positions.front();
    glm::dvec3 high = low;
    for (const glm::dvec3& position : positions) {
        low = glm::min(low, position);
        high = glm::max(high, position);
    }
    return 0.5 * (low + high);
}

Mesh meshOf(Shape shape, const std::string& name) {
    Mesh mesh{name, centreOf(shape.positions), {}, {}, std::move(shape.indices), {}};
    mesh.positions.reserve(shape.positions.size());
    for (const glm::dvec3& position : shape.positions) mesh.positions.emplace_back(position - mesh.origin);
    if (shape.authored) mesh.normals.assign(shape.normals.begin(), shape.normals.end());
    if (std::ranges::any_of(shape.materials, [](std::uint32_t material) { return material != 0; }))
        mesh.materials = std::move(shape.materials);
    return mesh;
}

// ---- the scene

class Loader {
public:
    explicit Loader(const tinygltf::Model& model)
        : model_{model}, parents_{parentsOf(model)}, worlds_{worldTransforms(model, parents_)} {}

    Scene::Data load() {
        for (const std::size_t node : nodesDrawn(model_, parents_)) {
            within(nodeLabel(model_, node), [&] {
                if (model_.nodes[node].camera != -1) placeCamera(node);
                if (model_.nodes[node].mesh != -1) placeMesh(node);
            });
        }
        warnOfModes();
        return std::move(data_);
    }

private:
    void placeCamera(std::size_t node) {
        const int index = model_.nodes[node].camera;
        const tinygltf::Camera& source = at(model_.cameras, index, "a camera");
        SceneCamera camera{nameOf(node, source.name), rigid(worlds_[node]), SceneCamera{}.viewAngle, 0.0};
        if (const std::optional<std::string> missing = readLens(source, camera))
            warn(label("camera", static_cast<std::size_t>(index), source.name) + " is left out: expected " + *missing);
        else
            data_.cameras.push_back(std::move(camera));
    }

    void placeMesh(std::size_t node) {
        const tinygltf::Node& source = model_.nodes[node];
        const tinygltf::Mesh& mesh = at(model_.meshes, source.mesh, "a mesh");
        Pose pose{source.weights.empty() ? mesh.weights : source.weights, {}};
        if (std::ranges::all_of(pose.weights, [](double weight) { return weight == 0.0; })) pose.weights.clear();
        if (source.skin != -1) pose.joints = jointMatrices(source.skin);

        const std::optional<std::uint32_t> drawn = meshInPose(source.mesh, pose);
        if (!drawn) return;
        const std::string name = nameOf(node, mesh.name);
        if (!pose.joints.empty()) return place({name, *drawn, glm::dmat4{1.0}});  // a skin places its mesh itself
        for (const glm::dmat4& copy : copiesOf(model_, source)) place({name, *drawn, worlds_[node] * copy});
    }

    void place(Instance instance) {
        if (!finite(instance.transform)) refuse("expected instances with finite transforms, found an infinite one");
        if (data_.instances.size() == maximumInstances)
            refuse(fmt::format("expected at most {} instances in the scene, found more", maximumInstances));
        data_.instances.push_back(std::move(instance));
    }

    std::vector<glm::dmat4> jointMatrices(int index) const {
        const tinygltf::Skin& source = at(model_.skins, index, "a skin");
        return within(label("skin", static_cast<std::size_t>(index), source.name), [&] {
            if (source.joints.empty()) refuse("expected joints, found none");
            std::vector<glm::dmat4> joints;
            for (const int joint : source.joints) joints.push_back(at(worlds_, joint, "a joint node"));
            if (source.inverseBindMatrices == -1) return joints;
            const std::vector<double> inverses =
                readNumbers(model_, source.inverseBindMatrices, "inverseBindMatrices", floatMat4);
            if (inverses.size() < joints.size() * 16)
                refuse(fmt::format("expected an inverse bind matrix for each of {} joints, found {}", joints.size(),
                                   inverses.size() / 16));
            for (std::size_t i = 0; i < joints.size(); ++i) joints[i] *= glm::make_mat4(&inverses[i * 16]);
            return joints;
        });
    }

    // The mesh's place in the scene's list; none if it draws no triangle. Nodes in one pose share it.
    std::optional<std::uint32_t> meshInPose(int index, const Pose& pose) {
        if (!pose.joints.empty()) return makeMesh(index, pose);
        const std::pair key{index, pose.weights};
        const auto known = meshes_.find(key);
        if (known != meshes_.end()) return known->second;
        return meshes_.emplace(key, makeMesh(index, pose)).first->second;
    }

    std::optional<std::uint32_t> makeMesh(int index, const Pose& pose) {
        const auto number = static_cast<std::size_t>(index);
        const tinygltf::Mesh& source = model_.meshes[number];
        const bool isNew = seen_.insert(index).second;
        Shape shape;
        for (std::size_t i = 0; i < source.primitives.size(); ++i) {
            const std::string where = label("mesh", number, source.name) + ", " + label("primitive", i);
            within(where, [&] {
                const gltf::Mode mode{source.primitives[i].mode};
                const std::string_view modeName = gltf::name(mode);
                if (gltf::drawsTriangles(mode))
                    append(shape, readPrimitive(source.primitives[i], pose, isNew ? where : std::string{}));
                else if (isNew)
                    ++ignored_[modeName];
            });
        }
        if (shape.indices.empty()) return {};
        data_.meshes.push_back(meshOf(std::move(shape), source.name));
        return static_cast<std::uint32_t>(data_.meshes.size() - 1);
    }

    // A warning starts with warnedAs; with none, the primitive has been warned of before.
    Shape readPrimitive(const tinygltf::Primitive& primitive, const Pose& pose, const std::string& warnedAs) {
        Shape part;
        const auto position = primitive.attributes.find("POSITION");
        if (position == primitive.attributes.end()) {
            if (!warnedAs.empty()) warn(warnedAs + ": has no positions and is not drawn");
            return part;
        }
        part.positions = readVectors<glm::dvec3>(model_, position->second, "POSITION", anyPosition);
        const std::size_t count = part.positions.size();
        part.normals = readAttribute<glm::dvec3>(model_, primitive.attributes, "NORMAL", anyNormal, count);
        part.authored = !part.normals.empty();
        part.normals.resize(count);
        spend(count);

        const gltf::Mode mode{primitive.mode};
        const std::vector<std::uint32_t> corners = cornersOf(primitive, count);
        if (mode == gltf::Mode::Triangles && corners.size() % 3 != 0 && !warnedAs.empty())
            warn(fmt::format("{}: expected a multiple of 3 corners, found {}: the last are not drawn", warnedAs,
                             corners.size()));
        part.indices = gltf::triangleList(mode, corners);
        spend(part.indices.size());
        part.materials.assign(part.indices.size() / 3, materialOf(primitive));
        morph(model_, primitive, pose.weights, part);
        if (!pose.joints.empty()) skin(model_, primitive, pose.joints, part);
        normalize(part.normals);
        checkPositions(part.positions);
        return part;
    }

    std::vector<std::uint32_t> cornersOf(const tinygltf::Primitive& primitive, std::size_t vertexCount) const {
        if (primitive.indices != -1)
            return withAccessor(model_, primitive.indices, "indices", [&](const gltf::Accessor& accessor) {
                return gltf::readIndices(accessor, vertexCount);
            });
        std::vector<std::uint32_t> corners(vertexCount);
        std::iota(corners.begin(), corners.end(), 0U);
        return corners;
    }

    void spend(std::size_t elements) {
        if (elements > elementsLeft_)
            refuse(fmt::format("expected at most {} vertices and indices in the scene, found more", maximumElements));
        elementsLeft_ -= elements;
    }

    void warnOfModes() {
        std::size_t count = 0;
        std::string modes;
        for (const auto& [mode, number] : ignored_) {
            count += number;
            modes += fmt::format("{}{} {}", modes.empty() ? "" : ", ", number, mode);
        }
        if (count == 1) warn(fmt::format("1 primitive of points or lines is not drawn: {}", modes));
        if (count > 1) warn(fmt::format("{} primitives of points or lines are not drawn: {}", count, modes));
    }

    void warn(std::string line) { data_.warnings.push_back(std::move(line)); }

    std::string nameOf(std::size_t node, const std::string& otherwise) const {
        return model_.nodes[node].name.empty() ? otherwise : model_.nodes[node].name;
    }

    const tinygltf::Model& model_;
    std::vector<int> parents_;
    std::vector<glm::dmat4> worlds_;  // node -> world
    Scene::Data data_;
    std::map<std::pair<int, std::vector<double>>, std::optional<std::uint32_t>> meshes_;  // by mesh and morph weights
    std::set<int> seen_;                               // meshes whose ignored primitives are counted
    std::map<std::string_view, std::size_t> ignored_;  // primitives by mode
    std::uint64_t elementsLeft_ = maximumElements;
};

}  // namespace

Scene::Data loadGltf(const std::filesystem::path& file) {
    return within(load::printable(file.string()), [&] {
        try {
            return Loader{parse(gltf::readFile(file))}.load();
        } catch (const Error&) {
            throw;
        } catch (const std::bad_alloc&) {
            refuse("expected a model that fits into memory, found one that does not");
        } catch (const std::exception& error) {
            refuse("expected glTF 2.0, found: " + load::printable(error.what()));
        }
    });
}

}  // namespace inkedge
