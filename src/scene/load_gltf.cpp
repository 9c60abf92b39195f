#include "scene/load_gltf.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <new>
#include <numbers>
#include <numeric>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include <fmt/format.h>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include "scene/cut_out.h"
#include "scene/decode_picture.h"
#include "scene/gltf_animation.h"
#include "scene/gltf_edges.h"
#include "scene/gltf_file.h"
#include "scene/gltf_model.h"
#include "scene/gltf_nodes.h"
#include "scene/gltf_triangles.h"
#include "scene/opacity_map.h"

namespace inkedge {
namespace {

using gltf::at;
using gltf::compose;
using gltf::Component;
using gltf::Expected;
using gltf::finite;
using gltf::nodeLabel;
using gltf::readAttribute;
using gltf::readNumbers;
using gltf::readVectors;
using load::label;
using load::refuse;
using load::within;

// KHR_mesh_quantization included.
const Expected anyPosition{gltf::vec3,
                           {Component::Float, Component::Int8, Component::Uint8, Component::Int16, Component::Uint16}};
const Expected anyNormal{gltf::vec3, {Component::Float, Component::Int8, Component::Int16}};
const Expected anyCoordinates{
    gltf::vec2, {Component::Float, Component::Int8, Component::Uint8, Component::Int16, Component::Uint16}};
const Expected anyColor{gltf::vec4, {Component::Float, Component::Uint8, Component::Uint16}};
const Expected anyOpaqueColor{gltf::vec3, {Component::Float, Component::Uint8, Component::Uint16}};
const Expected anyRotation{gltf::vec4, {Component::Float, Component::Int8, Component::Int16}};
const Expected anyWeights{gltf::vec4, {Component::Float, Component::Uint8, Component::Uint16}};
const Expected anyJoints{gltf::vec4, {Component::Uint8, Component::Uint16}};
const Expected floatVec3{gltf::vec3, {Component::Float}};
const Expected floatMat4{gltf::mat4, {Component::Float}};

// The copies that EXT_mesh_gpu_instancing makes of a node's mesh, in the node's space; without it, one.
std::vector<glm::dmat4> copiesOf(const tinygltf::Model& model, const tinygltf::Node& node, std::uint64_t most) {
    const auto extension = node.extensions.find("EXT_mesh_gpu_instancing");
    if (extension == node.extensions.end()) return {glm::dmat4{1.0}};
    const tinygltf::Value& attributes = extension->second.Get("attributes");
    std::optional<std::size_t> count;
    const auto read = [&]<class Vector>(const char* name, const Expected& expected, Vector otherwise) {
        std::vector<Vector> vectors;
        const tinygltf::Value& index = attributes.Get(name);
        if (index.IsInt()) {
            if (const std::uint64_t copies = gltf::elementCount(model, index.GetNumberAsInt(), name); copies > most)
                refuse(fmt::format("expected at most {} more instances in the scene, found {}; raise max-instances",
                                   most, copies));
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
    std::vector<glm::vec2> coordinates;    // one a position, or none
    std::vector<VertexPaint> paint;        // likewise
    std::vector<bool> marked;              // one an index, or none: Mesh::markedEdges
    std::vector<bool> inner;               // one an index, or none: Mesh::innerEdges
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

// Where only one of two has values, the other's are nothing.
template <class T>
void appendOrFill(std::vector<T>& all, std::size_t countBefore, const std::vector<T>& more, std::size_t count) {
    if (all.empty() && more.empty()) return;
    all.resize(countBefore);
    all.insert(all.end(), more.begin(), more.end());
    all.resize(countBefore + count);
}

void append(Shape& shape, Shape part) {
    if (shape.positions.empty()) {
        shape = std::move(part);
        return;
    }
    const auto first = static_cast<std::uint32_t>(shape.positions.size());
    appendOrFill(shape.coordinates, shape.positions.size(), part.coordinates, part.positions.size());
    appendOrFill(shape.paint, shape.positions.size(), part.paint, part.positions.size());
    appendOrFill(shape.marked, shape.indices.size(), part.marked, part.indices.size());
    appendOrFill(shape.inner, shape.indices.size(), part.inner, part.indices.size());
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
    Mesh mesh;
    mesh.name = name;
    mesh.origin = centreOf(shape.positions);
    mesh.indices = std::move(shape.indices);
    mesh.positions.reserve(shape.positions.size());
    for (const glm::dvec3& position : shape.positions) mesh.positions.emplace_back(position - mesh.origin);
    if (shape.authored) mesh.normals.assign(shape.normals.begin(), shape.normals.end());
    if (std::ranges::any_of(shape.materials, [](std::uint32_t material) { return material != 0; }))
        mesh.materials = std::move(shape.materials);
    mesh.textureCoordinates = std::move(shape.coordinates);
    mesh.paint = std::move(shape.paint);
    mesh.markedEdges = std::move(shape.marked);
    mesh.innerEdges = std::move(shape.inner);
    return mesh;
}

// ---- cut-outs

TextureWrap wrapOf(gltf::Wrap wrap) {
    switch (wrap) {
        case gltf::Wrap::Clamp:
            return TextureWrap::Clamp;
        case gltf::Wrap::Mirror:
            return TextureWrap::Mirror;
        case gltf::Wrap::Repeat:
            break;
    }
    return TextureWrap::Repeat;
}

// A picture's file. What is read from beside the model is taken off bytesLeft.
load::Bytes pictureBytes(const tinygltf::Model& model, const std::filesystem::path& path, const gltf::Image& source,
                         std::uint64_t& bytesLeft) {
    if (!source.bufferView) return gltf::readUri(path, source.uri, bytesLeft);
    if (*source.bufferView > std::numeric_limits<int>::max())
        refuse(fmt::format("expected a bufferView, found {}", *source.bufferView));
    const auto view = gltf::viewBytes(model, static_cast<int>(*source.bufferView));
    return {view.begin(), view.end()};
}

const gltf::Image& imageOf(const gltf::File& file, const gltf::Texture& texture) {
    if (!texture.image) refuse("expected its picture as PNG or JPEG, found it in another form only");
    if (*texture.image >= file.images.size())
        refuse(fmt::format("expected an image below {}, found {}", file.images.size(), *texture.image));
    return file.images[*texture.image];
}

// What vertices say of the places in a material's picture.
std::vector<glm::dvec2> texturePlaces(const tinygltf::Model& model, const gltf::Texture& texture,
                                      const tinygltf::Primitive& primitive, std::size_t count) {
    const std::string name = fmt::format("TEXCOORD_{}", texture.set);
    std::vector<glm::dvec2> places = readAttribute<glm::dvec2>(model, primitive.attributes, name, anyCoordinates, count);
    for (glm::dvec2& place : places) place = texture.scale * place + texture.offset;
    return places;
}

// Vertex colours, linear; none: all are white.
std::vector<glm::dvec4> vertexColors(const tinygltf::Model& model, const tinygltf::Primitive& primitive,
                                     std::size_t count) {
    const auto color = primitive.attributes.find("COLOR_0");
    if (color == primitive.attributes.end()) return {};
    if (at(model.accessors, color->second, "an accessor").type == TINYGLTF_TYPE_VEC4)
        return readAttribute<glm::dvec4>(model, primitive.attributes, "COLOR_0", anyColor, count);
    std::vector<glm::dvec4> colors;
    for (const glm::dvec3& c : readAttribute<glm::dvec3>(model, primitive.attributes, "COLOR_0", anyOpaqueColor, count))
        colors.emplace_back(c, 1.0);
    return colors;
}

// The cut-outs of a file's materials, made when first asked for.
class CutOuts {
public:
    CutOuts(const tinygltf::Model& model, const gltf::File& file, const std::filesystem::path& path,
            const LoadLimits& limits)
        : model_{model}, file_{file}, path_{path}, mostPixels_{limits.imagePixels}, bytesLeft_{file.bytesLeft} {}

    // What is left of a part under a material with a mask.
    // @throws Error  if its picture cannot be read
    void apply(const gltf::Material& material, const tinygltf::Primitive& primitive, Shape& part) {
        const std::vector<double> opacities = vertexOpacities(primitive, part.positions.size());
        const auto opacityOf = [&](std::size_t triangle) {
            if (opacities.empty()) return material.opacity;
            const std::uint32_t* const corner = &part.indices[3 * triangle];
            return material.opacity * (opacities[corner[0]] + opacities[corner[1]] + opacities[corner[2]]) / 3.0;
        };
        std::vector<glm::dvec2> places;
        if (material.texture) places = texturePlaces(model_, *material.texture, primitive, part.positions.size());
        Shape rest;
        rest.authored = part.authored;
        for (std::size_t t = 0; t < part.indices.size() / 3; ++t) cutTriangle(material, places, opacityOf(t), part, t, rest);
        part = std::move(rest);
    }

private:
    using Alpha = std::optional<Image<std::uint8_t>>;

    // Of COLOR_0, where it has an alpha; none: all are 1.
    [[nodiscard]] std::vector<double> vertexOpacities(const tinygltf::Primitive& primitive, std::size_t count) const {
        const auto color = primitive.attributes.find("COLOR_0");
        if (color == primitive.attributes.end()) return {};
        if (at(model_.accessors, color->second, "an accessor").type != TINYGLTF_TYPE_VEC4) return {};
        std::vector<double> opacities;
        for (const glm::dvec4& c : readAttribute<glm::dvec4>(model_, primitive.attributes, "COLOR_0", anyColor, count))
            opacities.push_back(c.a);
        return opacities;
    }

    void cutTriangle(const gltf::Material& material, const std::vector<glm::dvec2>& places, double opacity,
                     const Shape& part, std::size_t triangle, Shape& rest) {
        constexpr CutOut::Piece whole{glm::dvec3{1, 0, 0}, glm::dvec3{0, 1, 0}, glm::dvec3{0, 0, 1}};
        if (opacity < material.cutoff) return;
        const std::uint32_t* const corners = &part.indices[3 * triangle];
        CutOut* const cutOut = places.empty() ? nullptr : find(*material.texture, material.cutoff / opacity);
        if (cutOut == nullptr) return add(part, triangle, whole, rest);
        for (const CutOut::Piece& piece : cutOut->cut({places[corners[0]], places[corners[1]], places[corners[2]]}))
            add(part, triangle, piece, rest);
    }

    static void add(const Shape& part, std::size_t triangle, const CutOut::Piece& piece, Shape& rest) {
        const std::uint32_t* const corners = &part.indices[3 * triangle];
        const auto mixed = [&](const std::vector<glm::dvec3>& of, const glm::dvec3& weights) {
            return weights.x * of[corners[0]] + weights.y * of[corners[1]] + weights.z * of[corners[2]];
        };
        for (const glm::dvec3& weights : piece) {
            rest.indices.push_back(static_cast<std::uint32_t>(rest.positions.size()));
            rest.positions.push_back(mixed(part.positions, weights));
            rest.normals.push_back(mixed(part.normals, weights));
            if (!part.coordinates.empty()) {
                const glm::vec3 w{weights};
                rest.coordinates.push_back(w.x * part.coordinates[corners[0]] + w.y * part.coordinates[corners[1]] +
                                           w.z * part.coordinates[corners[2]]);
            }
        }
        for (const glm::dvec3& weights : piece) {
            if (part.paint.empty()) break;
            const glm::vec3 w{weights};
            const VertexPaint* const at[]{&part.paint[corners[0]], &part.paint[corners[1]], &part.paint[corners[2]]};
            rest.paint.push_back({w.x * at[0]->color + w.y * at[1]->color + w.z * at[2]->color,
                                  w.x * at[0]->place + w.y * at[1]->place + w.z * at[2]->place});
        }
        rest.materials.push_back(part.materials[triangle]);
        addEdges(part.marked, triangle, piece, rest.marked);
        addEdges(part.inner, triangle, piece, rest.inner);
    }

    // What is said of an edge goes for the pieces' edges that lie on it.
    static void addEdges(const std::vector<bool>& of, std::size_t triangle, const CutOut::Piece& piece,
                         std::vector<bool>& rest) {
        constexpr double nothing = 1e-9;  // what rounding leaves of a weight
        if (of.empty()) return;
        for (std::size_t k = 0; k < 3; ++k) {
            bool said = false;
            for (std::size_t edge = 0; edge < 3; ++edge) {
                const auto opposite = static_cast<int>((edge + 2) % 3);
                const bool liesOnIt = piece[k][opposite] <= nothing && piece[(k + 1) % 3][opposite] <= nothing;
                said = said || (liesOnIt && of[3 * triangle + edge]);
            }
            rest.push_back(said);
        }
    }

    // None where the picture has no alpha or the threshold is nothing.
    CutOut* find(const gltf::Texture& texture, double threshold) {
        constexpr double opaque = 255.0;
        if (!texture.image) refuse("expected its picture as PNG or JPEG, found it in another form only");
        if (!(threshold > 0.0)) return nullptr;
        const Alpha& alpha = opacityMap(*texture.image);
        if (!alpha) return nullptr;
        auto& cutOut = cutOuts_[{*texture.image, texture.wrapS, texture.wrapT, threshold}];
        if (!cutOut)
            cutOut = std::make_unique<CutOut>(*alpha, std::array{wrapOf(texture.wrapS), wrapOf(texture.wrapT)},
                                              opaque * threshold);
        return cutOut.get();
    }

    const Alpha& opacityMap(std::uint64_t image) {
        const auto known = maps_.find(image);
        if (known != maps_.end()) return known->second;
        if (image >= file_.images.size())
            refuse(fmt::format("expected an image below {}, found {}", file_.images.size(), image));
        return within(label("image", image), [&]() -> const Alpha& {
            const gltf::Image& source = file_.images[image];
            return maps_.emplace(image, decode(source)).first->second;
        });
    }

    Alpha decode(const gltf::Image& source) {
        return decodeOpacity(pictureBytes(model_, path_, source, bytesLeft_), mostPixels_);
    }

    const tinygltf::Model& model_;
    const gltf::File& file_;
    const std::filesystem::path& path_;
    std::uint64_t mostPixels_;
    std::uint64_t bytesLeft_;
    std::map<std::uint64_t, Alpha> maps_;
    std::map<std::tuple<std::uint64_t, gltf::Wrap, gltf::Wrap, double>, std::unique_ptr<CutOut>> cutOuts_;
};

template <class T>
std::vector<std::string> namesOf(const std::vector<T>& all) {
    std::vector<std::string> names;
    for (const T& each : all) names.push_back(load::printable(each.name));
    return names;
}

// Primitives may share accessors, but a small file must not ask for much memory.
std::uint64_t mostElements(const tinygltf::Model& model) {
    std::uint64_t bytes = 0;
    for (const tinygltf::Buffer& buffer : model.buffers) bytes += buffer.data.size();
    return (std::uint64_t{1} << 24U) + 16 * bytes;
}

// ---- the scene

class Loader {
public:
    Loader(const tinygltf::Model& model, const gltf::File& file, const std::filesystem::path& path,
           const LoadSettings& settings)
        : model_{model},
          file_{file},
          path_{path},
          settings_{settings},
          nodes_{gltf::placeNodes(model, settings.limits)},
          cutOuts_{model, file, path, settings.limits},
          elementsLeft_{std::min(settings.limits.vertices, mostElements(model))} {}

    Scene::Data load() {
        for (const gltf::Material& material : file_.materials)
            data_.materials.push_back({material.name, material.doubleSided});
        if (settings_.paint) readPaints();
        for (const auto& [node, visible] : gltf::nodesOfScene(model_, nodes_, settings_.scene)) {
            within(nodeLabel(model_, node), [&, node = node, visible = visible] {
                if (model_.nodes[node].camera != -1) placeCamera(node);
                if (model_.nodes[node].mesh != -1 && visible) placeMesh(node);
            });
        }
        warnOfModes();
        return std::move(data_);
    }

private:
    void placeCamera(std::size_t node) {
        const int index = model_.nodes[node].camera;
        const tinygltf::Camera& source = at(model_.cameras, index, "a camera");
        SceneCamera camera{nameOf(node, source.name), rigid(nodes_.toWorld[node]), SceneCamera{}.viewAngle, 0.0};
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
        for (const glm::dmat4& copy : copiesOf(model_, source, instancesLeft())) place({name, *drawn, nodes_.toWorld[node] * copy});
    }

    void place(Instance instance) {
        if (!finite(instance.transform)) refuse("expected instances with finite transforms, found an infinite one");
        if (instancesLeft() == 0)
            refuse(fmt::format("expected at most {} instances in the scene, found more; raise max-instances",
                               settings_.limits.instances));
        data_.instances.push_back(std::move(instance));
    }

    std::uint64_t instancesLeft() const { return settings_.limits.instances - data_.instances.size(); }

    std::vector<glm::dmat4> jointMatrices(int index) const {
        const tinygltf::Skin& source = at(model_.skins, index, "a skin");
        return within(label("skin", static_cast<std::size_t>(index), source.name), [&] {
            if (source.joints.empty()) refuse("expected joints, found none");
            std::vector<glm::dmat4> joints;
            for (const int joint : source.joints) joints.push_back(at(nodes_.toWorld, joint, "a joint node"));
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
        const gltf::Material* const material = materialOf(primitive);
        if (material == nullptr && primitive.material != -1 && !warnedAs.empty())
            warn(fmt::format("{}: expected a material below {}, found {}", warnedAs, file_.materials.size(),
                             primitive.material));
        if (isIgnored(material)) return part;
        spend(gltf::elementCount(model_, position->second, "POSITION"));
        part.positions = readVectors<glm::dvec3>(model_, position->second, "POSITION", anyPosition);
        const std::size_t count = part.positions.size();
        part.normals = readAttribute<glm::dvec3>(model_, primitive.attributes, "NORMAL", anyNormal, count);
        part.authored = !part.normals.empty();
        part.normals.resize(count);

        const gltf::Mode mode{primitive.mode};
        std::vector<std::uint32_t> corners = cornersOf(primitive, count);
        if (mode == gltf::Mode::Triangles && corners.size() % 3 != 0 && !warnedAs.empty())
            warn(fmt::format("{}: expected a multiple of 3 corners, found {}: the last are not drawn", warnedAs,
                             corners.size()));
        readEdges(primitive, corners, part, warnedAs);
        part.indices = gltf::triangleList(mode, std::move(corners));
        spend(part.indices.size());
        if (settings_.textureCoordinates) readCoordinates(primitive, part);
        if (settings_.paint) readPaint(material, primitive, part);
        part.materials.assign(part.indices.size() / 3, static_cast<std::uint32_t>(primitive.material) + 1U);
        morph(model_, primitive, pose.weights, part);
        if (!pose.joints.empty()) skin(model_, primitive, pose.joints, part);
        checkPositions(part.positions);
        if (isCut(material)) cutOut(*material, primitive, part);
        normalize(part.normals);
        return part;
    }

    void readEdges(const tinygltf::Primitive& primitive, const std::vector<std::uint32_t>& corners, Shape& part,
                   const std::string& warnedAs) {
        gltf::EdgeVisibility edges = gltf::readEdgeVisibility(model_, primitive, gltf::Mode{primitive.mode}, corners,
                                                              part.positions.size());
        part.marked = std::move(edges.hard);
        part.inner = std::move(edges.hidden);
        if (edges.lost > 0 && !warnedAs.empty())
            warn(fmt::format("{}: {} edges of its line strings belong to no triangle and are not drawn", warnedAs,
                             edges.lost));
    }

    void readCoordinates(const tinygltf::Primitive& primitive, Shape& part) {
        const auto coordinates = readAttribute<glm::dvec2>(model_, primitive.attributes, "TEXCOORD_0", anyCoordinates,
                                                           part.positions.size());
        part.coordinates.reserve(coordinates.size());
        for (const glm::dvec2& c : coordinates) {
            if (const glm::vec2 f{c}; !std::isfinite(f.x) || !std::isfinite(f.y))
                refuse(fmt::format("TEXCOORD_0: expected finite numbers, found ({}, {})", c.x, c.y));
            part.coordinates.emplace_back(c);
        }
    }

    void readPaint(const gltf::Material* material, const tinygltf::Primitive& primitive, Shape& part) {
        const std::size_t count = part.positions.size();
        const std::vector<glm::dvec4> colors = vertexColors(model_, primitive, count);
        std::vector<glm::dvec2> places;
        if (material != nullptr && material->texture) places = texturePlaces(model_, *material->texture, primitive, count);
        part.paint.resize(count);
        const auto finiteOrZero = [](float x) { return std::isfinite(x) ? x : 0.0F; };
        for (std::size_t i = 0; i < count; ++i) {
            for (int c = 0; c < 4 && !colors.empty(); ++c) part.paint[i].color[c] = finiteOrZero(static_cast<float>(colors[i][c]));
            for (int c = 0; c < 2 && !places.empty(); ++c) part.paint[i].place[c] = finiteOrZero(static_cast<float>(places[i][c]));
        }
    }

    // What the materials are painted with. A picture that cannot be read leaves its material's colour.
    void readPaints() {
        std::map<std::uint64_t, std::shared_ptr<const Image<std::uint8_t>>> pictures;
        std::uint64_t bytesLeft = file_.bytesLeft;
        for (std::size_t i = 0; i < file_.materials.size(); ++i) {
            const gltf::Material& source = file_.materials[i];
            Material& material = data_.materials[i];
            material.color = glm::vec4{source.color, source.opacity};
            try {
                if (!source.unpainted.empty()) refuse(source.unpainted);
                if (!source.texture) continue;
                material.wrap = {wrapOf(source.texture->wrapS), wrapOf(source.texture->wrapT)};
                const gltf::Image& image = imageOf(file_, *source.texture);
                auto& picture = pictures[*source.texture->image];
                if (!picture)
                    picture = within(label("image", *source.texture->image), [&] {
                        return std::make_shared<const Image<std::uint8_t>>(decodePicture(
                            pictureBytes(model_, path_, image, bytesLeft), settings_.limits.imagePixels));
                    });
                material.picture = picture;
            } catch (const Error& error) {
                warn(fmt::format("{} is drawn without its picture: {}", label("material", i, source.name), error.what()));
            }
        }
    }

    // None, too, where the file leaves it out: what is drawn does not depend on it.
    const gltf::Material* materialOf(const tinygltf::Primitive& primitive) const {
        if (primitive.material < -1)
            refuse(fmt::format("expected a material of at least 0, found {}", primitive.material));
        const auto number = static_cast<std::size_t>(primitive.material);
        return primitive.material == -1 || number >= file_.materials.size() ? nullptr : &file_.materials[number];
    }

    bool isCut(const gltf::Material* material) const {
        return settings_.alphaMask == AlphaMask::Cut && material != nullptr &&
               material->alpha == gltf::Material::Alpha::Mask;
    }

    bool isIgnored(const gltf::Material* material) const {
        return settings_.transparent == Transparent::Ignore && material != nullptr &&
               material->alpha == gltf::Material::Alpha::Blend;
    }

    // A cut-out that cannot be made is drawn whole: one picture less is no reason to draw nothing.
    void cutOut(const gltf::Material& material, const tinygltf::Primitive& primitive, Shape& part) {
        try {
            cutOuts_.apply(material, primitive, part);
            spend(part.indices.size());
        } catch (const Error& error) {
            if (!uncut_.insert(primitive.material).second) return;
            warn(fmt::format("{} is drawn without its cut-out: {}",
                             label("material", static_cast<std::size_t>(primitive.material), material.name),
                             error.what()));
        }
    }

    std::vector<std::uint32_t> cornersOf(const tinygltf::Primitive& primitive, std::size_t vertexCount) const {
        if (primitive.indices != -1) return gltf::readIndices(model_, primitive.indices, vertexCount);
        std::vector<std::uint32_t> corners(vertexCount);
        std::iota(corners.begin(), corners.end(), 0U);
        return corners;
    }

    void spend(std::size_t elements) {
        if (elements > elementsLeft_ && mostElements(model_) < settings_.limits.vertices)
            refuse(fmt::format("expected at most {} vertices and indices from so small a file, found more",
                               mostElements(model_)));
        if (elements > elementsLeft_)
            refuse(fmt::format("expected at most {} vertices and indices in the scene, found more; raise max-vertices",
                               settings_.limits.vertices));
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
    const gltf::File& file_;
    const std::filesystem::path& path_;
    const LoadSettings& settings_;
    gltf::Nodes nodes_;
    CutOuts cutOuts_;
    Scene::Data data_;
    std::map<std::pair<int, std::vector<double>>, std::optional<std::uint32_t>> meshes_;  // by mesh and morph weights
    std::set<int> seen_;                               // meshes whose ignored primitives are counted
    std::map<std::string_view, std::size_t> ignored_;  // primitives by mode
    std::set<int> uncut_;                              // materials warned of
    std::uint64_t elementsLeft_;
};

}  // namespace

Scene::Data loadGltf(const std::filesystem::path& path, const LoadSettings& settings) {
    return within(load::printable(path.string()), [&] {
        try {
            gltf::File file = gltf::readFile(path, settings.limits);
            tinygltf::Model model = gltf::parse(std::move(file.json), std::move(file.buffers));
            std::vector<std::string> warnings = std::move(file.warnings);
            if (!settings.animation.empty())
                for (std::string& warning : gltf::poseNodes(model, settings.animation, settings.time))
                    warnings.push_back(std::move(warning));
            Scene::Data data = Loader{model, file, path, settings}.load();
            data.source = {"glTF 2.0", namesOf(model.scenes), namesOf(model.animations), file.extensions};
            data.warnings.insert(data.warnings.begin(), warnings.begin(), warnings.end());
            return data;
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
