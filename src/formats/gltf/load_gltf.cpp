#include "formats/gltf/load_gltf.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <new>
#include <numbers>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include <fmt/format.h>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include "formats/gltf/animation.h"
#include "formats/gltf/attributes.h"
#include "formats/gltf/cameras.h"
#include "formats/gltf/cut_outs.h"
#include "formats/gltf/edges.h"
#include "formats/gltf/file.h"
#include "formats/gltf/instancing.h"
#include "formats/gltf/line_pieces.h"
#include "formats/gltf/mask_uses.h"
#include "formats/gltf/model.h"
#include "formats/gltf/nodes.h"
#include "formats/gltf/not_drawn.h"
#include "formats/gltf/paint.h"
#include "formats/gltf/shape.h"
#include "formats/gltf/triangles.h"
#include "formats/text.h"
#include "images/decode_picture.h"

namespace inkedge::gltf {
namespace {

template <class T>
std::vector<std::string> namesOf(const std::vector<T>& all) {
    std::vector<std::string> names;
    for (const T& each : all) names.push_back(base::printable(each.name));
    return names;
}

// A limit on vertices and indices by the file's size: primitives may share accessors, but a small file must not take
// much memory.
std::uint64_t elementLimit(const tinygltf::Model& model) {
    std::uint64_t bytes = 0;
    for (const tinygltf::Buffer& buffer : model.buffers) bytes += buffer.data.size();
    return (std::uint64_t{1} << 24U) + 16 * bytes;
}

// ---- the scene

class Loader {
public:
    Loader(const tinygltf::Model& model, const File& file, const formats::ModelInput& input,
           const LoadSettings& settings)
        : model_{model},
          file_{file},
          input_{input},
          settings_{settings},
          nodes_{nodeTransforms(model, settings.limits)},
          sceneNodes_(model.nodes.size(), noNode),
          cutOuts_{model, file, input, settings.limits},
          elementsLeft_{std::min(settings.limits.vertices, elementLimit(model))} {}

    Scene::Data load() {
        for (const Material& material : file_.materials)
            data_.materials.push_back({material.name, material.doubleSided});
        if (settings_.paint) readPaints();
        const std::vector<DrawnNode> drawn = nodesOfScene(model_, nodes_, settings_.scene);
        if (settings_.alphaMask == AlphaMask::Cut)
            if (std::string warning = cutOuts_.coarsen(maskUses(model_, file_, drawn, elementsLeft_)); !warning.empty())
                warn(std::move(warning));
        for (const auto& [number, shown] : drawn) {
            addNode(number);
            base::within(nodeLabel(model_, number), [&, node = number, visible = shown] {
                if (model_.nodes[node].camera != -1) addCamera(node);
                if (model_.nodes[node].mesh != -1 && visible) addInstances(node);
            });
        }
        warnOfPoints();
        if (data_.instances.empty()) data_.undrawn = whatIsThere(model_, nodes_, drawn, settings_.scene, notDrawn_);
        return std::move(data_);
    }

private:
    // Parents come before their children.
    void addNode(std::size_t node) {
        const int parent = nodes_.parents[node];
        sceneNodes_[node] = static_cast<std::uint32_t>(data_.nodes.size());
        data_.nodes.push_back({model_.nodes[node].name,  //
                               parent == -1 ? noNode : sceneNodes_[static_cast<std::size_t>(parent)]});
    }

    void addCamera(std::size_t node) {
        const int index = model_.nodes[node].camera;
        const tinygltf::Camera& source = at(model_.cameras, index, "a camera");
        SceneCamera camera{nameOf(node, source.name), rigid(nodes_.toWorld[node]), SceneCamera{}.viewAngle, 0.0};
        if (const std::optional<std::string> missing = readLens(source, camera))
            warn(base::label("camera", static_cast<std::size_t>(index), source.name) + " is left out: expected " +
                 *missing);
        else
            data_.cameras.push_back(std::move(camera));
    }

    void addInstances(std::size_t node) {
        const tinygltf::Node& source = model_.nodes[node];
        const tinygltf::Mesh& mesh = at(model_.meshes, source.mesh, "a mesh");
        Pose pose{source.weights.empty() ? mesh.weights : source.weights, {}};
        if (std::ranges::all_of(pose.weights, [](double weight) { return weight == 0.0; })) pose.weights.clear();
        if (source.skin != -1) pose.joints = jointMatrices(source.skin);

        const std::optional<std::uint32_t> drawn = meshInPose(source.mesh, pose);
        if (!drawn) return;
        const std::string name = nameOf(node, mesh.name);
        const std::uint32_t part = sceneNodes_[node];
        if (!pose.joints.empty())
            return addInstance({name, *drawn, glm::dmat4{1.0}, part});  // a skin holds its own transforms
        for (const glm::dmat4& copy : copiesOf(model_, source, instancesLeft()))
            addInstance({name, *drawn, nodes_.toWorld[node] * copy, part});
    }

    void addInstance(Instance instance) {
        if (!finite(instance.transform))
            base::refuse("expected instances with finite transforms, found an infinite one");
        if (instancesLeft() == 0)
            base::refuse(fmt::format("expected at most {} instances in the scene, found more; raise max-instances",
                                     settings_.limits.instances));
        data_.instances.push_back(std::move(instance));
    }

    std::uint64_t instancesLeft() const { return settings_.limits.instances - data_.instances.size(); }

    std::vector<glm::dmat4> jointMatrices(int index) const {
        const tinygltf::Skin& source = at(model_.skins, index, "a skin");
        return base::within(base::label("skin", static_cast<std::size_t>(index), source.name), [&] {
            if (source.joints.empty()) base::refuse("expected joints, found none");
            std::vector<glm::dmat4> joints;
            for (const int joint : source.joints) joints.push_back(at(nodes_.toWorld, joint, "a joint node"));
            if (source.inverseBindMatrices == -1) return joints;
            const std::vector<double> inverses =
                readNumbers(model_, source.inverseBindMatrices, "inverseBindMatrices", floatMat4);
            if (inverses.size() < joints.size() * 16)
                base::refuse(fmt::format("expected an inverse bind matrix for each of {} joints, found {}",
                                         joints.size(), inverses.size() / 16));
            for (std::size_t i = 0; i < joints.size(); ++i) joints[i] *= glm::make_mat4(&inverses[i * 16]);
            return joints;
        });
    }

    // The index of a mesh in the scene's list; none if it draws nothing. Nodes in one pose share the mesh.
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
        const auto label = [&](std::size_t i) {
            return base::label("mesh", number, source.name) + ", " + base::label("primitive", i);
        };
        checkElements(source, label);
        Shape shape;
        for (std::size_t i = 0; i < source.primitives.size(); ++i) {
            const std::string where = label(i);
            base::within(where, [&] {
                const Mode mode{source.primitives[i].mode};
                static_cast<void>(name(mode));  // refuses a mode that glTF has not
                const std::string warnedAs = isNew ? where : std::string{};
                if (drawsTriangles(mode))
                    append(shape, readTriangles(source.primitives[i], pose, warnedAs));
                else if (drawsLines(mode))
                    append(shape, readLines(source.primitives[i], pose, warnedAs));
                else if (isNew)
                    leaveOut(source.primitives[i]);
            });
        }
        if (shape.indices.empty() && shape.lines.empty()) return {};
        data_.meshes.push_back(meshOf(std::move(shape), source.name));
        return static_cast<std::uint32_t>(data_.meshes.size() - 1);
    }

    // Refuses a mesh of more vertices and indices than may still be read, before any of them is.
    // @param label  of its primitives, by their index
    template <class Label>
    void checkElements(const tinygltf::Mesh& source, const Label& label) const {
        const auto countOf = [&](int accessor) {
            const auto number = static_cast<std::size_t>(accessor);
            return number < model_.accessors.size() ? std::uint64_t{model_.accessors[number].count} : 0;
        };
        std::uint64_t elements = 0;
        for (std::size_t i = 0; i < source.primitives.size(); ++i) {
            const tinygltf::Primitive& primitive = source.primitives[i];
            const Mode mode{primitive.mode};
            const auto position = primitive.attributes.find("POSITION");
            if ((!drawsTriangles(mode) && !drawsLines(mode)) || isIgnored(materialOf(file_, primitive)) ||
                position == primitive.attributes.end())
                continue;
            elements += countOf(position->second);
            if (mode == Mode::Triangles)
                elements += countOf(primitive.indices != -1 ? primitive.indices : position->second) / 3 * 3;
            if (elements > elementsLeft_) base::within(label(i), [&] { refuseElements(); });
        }
    }

    void leaveOut(const tinygltf::Primitive& primitive) {
        ++pointPrimitives_;
        notDrawn_.addPoints(model_, primitive);
    }

    // The vertices of a primitive, not yet in their pose; none if it is not drawn. Warnings start with warnedAs. If it
    // is empty the primitive's warnings have been given before.
    Shape readVertices(const tinygltf::Primitive& primitive, const std::string& warnedAs) {
        Shape part;
        const auto position = primitive.attributes.find("POSITION");
        if (position == primitive.attributes.end()) {
            if (!warnedAs.empty()) warn(warnedAs + ": has no positions and is not drawn");
            return part;
        }
        const Material* const material = materialOf(file_, primitive);
        if (material == nullptr && primitive.material != -1 && !warnedAs.empty())
            warn(fmt::format("{}: expected a material below {}, found {}", warnedAs, file_.materials.size(),
                             primitive.material));
        if (isIgnored(material)) {
            ++notDrawn_.transparent;
            return part;
        }
        spend(elementCount(model_, position->second, "POSITION"));
        part.positions = readVectors<glm::dvec3>(model_, position->second, "POSITION", anyPosition);
        const std::size_t count = part.positions.size();
        part.normals = readAttribute<glm::dvec3>(model_, primitive.attributes, "NORMAL", anyNormal, count);
        part.authored = !part.normals.empty();
        part.normals.resize(count);
        return part;
    }

    void posePart(const tinygltf::Primitive& primitive, const Pose& pose, Shape& part) {
        morph(model_, primitive, pose.weights, part);
        if (!pose.joints.empty()) skin(model_, primitive, pose.joints, part);
        checkPositions(part.positions);
    }

    Shape readLines(const tinygltf::Primitive& primitive, const Pose& pose, const std::string& warnedAs) {
        Shape vertices = readVertices(primitive, warnedAs);
        if (vertices.positions.empty()) return {};
        const std::vector<std::uint32_t> corners = cornersOf(model_, file_, primitive, vertices.positions.size());
        if (Mode{primitive.mode} == Mode::Lines && corners.size() % 2 != 0 && !warnedAs.empty())
            warn(fmt::format("{}: expected a multiple of 2 corners, found {}: the last is not drawn", warnedAs,
                             corners.size()));
        const std::vector<std::uint32_t> ends = linePieces(Mode{primitive.mode}, corners);
        spend(ends.size());
        posePart(primitive, pose, vertices);
        Shape part;
        part.lines = linesBetween(primitive, vertices.positions, ends);
        if (part.lines.empty()) notDrawn_.maskedLines += ends.size() / 2;
        return part;
    }

    // @param ends  into the positions, which are in their pose: two for each straight piece
    std::vector<glm::dvec3> linesBetween(const tinygltf::Primitive& primitive, const std::vector<glm::dvec3>& positions,
                                         const std::vector<std::uint32_t>& ends) {
        std::vector<glm::dvec3> lines;
        for (const std::uint32_t end : ends) lines.push_back(positions[end]);
        const Material* const material = materialOf(file_, primitive);
        if (isCut(material))
            cutOrWarn(*material, primitive,
                      [&] { lines = cutOuts_.opaqueLines(*material, primitive, positions, ends); });
        return lines;
    }

    Shape readTriangles(const tinygltf::Primitive& primitive, const Pose& pose, const std::string& warnedAs) {
        Shape part = readVertices(primitive, warnedAs);
        if (part.positions.empty()) return part;
        const Material* const material = materialOf(file_, primitive);
        const Mode mode{primitive.mode};
        std::vector<std::uint32_t> corners = cornersOf(model_, file_, primitive, part.positions.size());
        if (mode == Mode::Triangles && corners.size() % 3 != 0 && !warnedAs.empty())
            warn(fmt::format("{}: expected a multiple of 3 corners, found {}: the last are not drawn", warnedAs,
                             corners.size()));
        FileEdges edges = readEdges(model_, primitive, mode, corners, part.positions.size());
        part.edges = std::move(edges.kinds);
        part.indices = triangleList(mode, std::move(corners));
        spend(part.indices.size() + edges.lines.size());
        if (settings_.textureCoordinates) readCoordinates(primitive, part);
        if (settings_.paint) readPaint(material, primitive, part);
        part.materials.assign(part.indices.size() / 3, static_cast<std::uint32_t>(primitive.material) + 1U);
        posePart(primitive, pose, part);
        std::vector<glm::dvec3> lines = linesBetween(primitive, part.positions, edges.lines);
        if (isCut(material)) cutOut(*material, primitive, part);
        part.lines = std::move(lines);
        normalize(part.normals);
        return part;
    }

    void readCoordinates(const tinygltf::Primitive& primitive, Shape& part) {
        const auto coordinates = readAttribute<glm::dvec2>(model_, primitive.attributes, "TEXCOORD_0", anyCoordinates,
                                                           part.positions.size());
        part.coordinates.reserve(coordinates.size());
        for (const glm::dvec2& c : coordinates) {
            if (const glm::vec2 f{c}; !std::isfinite(f.x) || !std::isfinite(f.y))
                base::refuse(fmt::format("TEXCOORD_0: expected finite numbers, found ({}, {})", c.x, c.y));
            part.coordinates.emplace_back(c);
        }
    }

    void readPaint(const Material* material, const tinygltf::Primitive& primitive, Shape& part) {
        const std::size_t count = part.positions.size();
        const std::vector<glm::dvec4> colors = vertexColors(model_, primitive, count);
        std::vector<glm::dvec2> uvs;
        if (material != nullptr && material->texture) uvs = uvsOf(model_, *material->texture, primitive, count);
        part.paint.resize(count);
        const auto finiteOrZero = [](float x) { return std::isfinite(x) ? x : 0.0F; };
        for (std::size_t i = 0; i < count; ++i) {
            for (int c = 0; c < 4 && !colors.empty(); ++c)
                part.paint[i].color[c] = finiteOrZero(static_cast<float>(colors[i][c]));
            for (int c = 0; c < 2 && !uvs.empty(); ++c)
                part.paint[i].uv[c] = finiteOrZero(static_cast<float>(uvs[i][c]));
        }
    }

    // Reads the materials' colours and pictures. A material whose picture cannot be read keeps its colour.
    void readPaints() {
        std::map<std::uint64_t, std::shared_ptr<const inkedge::Image<std::uint8_t>>> pictures;
        std::uint64_t bytesLeft = file_.bytesLeft;
        for (std::size_t i = 0; i < file_.materials.size(); ++i) {
            const Material& source = file_.materials[i];
            inkedge::Material& material = data_.materials[i];
            material.color = glm::vec4{source.color, source.opacity};
            try {
                if (!source.unpainted.empty()) base::refuse(source.unpainted);
                if (!source.texture) continue;
                material.wrap = {wrapOf(source.texture->wrapS), wrapOf(source.texture->wrapT)};
                const gltf::Image& image = imageOf(file_, *source.texture);
                auto& picture = pictures[*source.texture->image];
                if (!picture)
                    picture = base::within(base::label("image", *source.texture->image), [&] {
                        return std::make_shared<const inkedge::Image<std::uint8_t>>(images::decodePicture(
                            pictureBytes(model_, input_, image, bytesLeft), settings_.limits.imagePixels));
                    });
                material.picture = picture;
            } catch (const Error& error) {
                unread_.insert(static_cast<int>(i));
                warn(fmt::format("{} is drawn without its picture: {}", base::label("material", i, source.name),
                                 error.what()));
            }
        }
    }

    bool isCut(const Material* material) const {
        return settings_.alphaMask == AlphaMask::Cut && material != nullptr && material->alpha == Material::Alpha::Mask;
    }

    bool isIgnored(const Material* material) const {
        return settings_.transparent == Transparent::Ignore && material != nullptr &&
               material->alpha == Material::Alpha::Blend;
    }

    void cutOut(const Material& material, const tinygltf::Primitive& primitive, Shape& part) {
        cutOrWarn(material, primitive, [&] {
            const std::size_t before = part.indices.size() / 3;
            cutOuts_.apply(material, primitive, part);
            if (part.indices.empty()) notDrawn_.maskedAway += before;
            spend(part.indices.size());
        });
    }

    // A cut-out whose picture or opacity cannot be read is drawn whole, with a warning.
    template <class Cut>
    void cutOrWarn(const Material& material, const tinygltf::Primitive& primitive, Cut&& cut) {
        try {
            cut();
        } catch (const Error& error) {
            if (!unread_.insert(primitive.material).second) return;
            warn(fmt::format("{} is drawn without its cut-out: {}",
                             base::label("material", static_cast<std::size_t>(primitive.material), material.name),
                             error.what()));
        }
    }

    void spend(std::size_t elements) {
        if (elements > elementsLeft_) refuseElements();
        elementsLeft_ -= elements;
    }

    [[noreturn]] void refuseElements() const {
        if (elementLimit(model_) < settings_.limits.vertices)
            base::refuse(fmt::format("expected at most {} vertices and indices from so small a file, found more",
                                     elementLimit(model_)));
        base::refuse(
            fmt::format("expected at most {} vertices and indices in the scene, found more; raise max-vertices",
                        settings_.limits.vertices));
    }

    void warnOfPoints() {
        if (pointPrimitives_ > 0)
            warn(formats::counted(pointPrimitives_, "primitive") + " of points " +
                 (pointPrimitives_ == 1 ? "is not drawn" : "are not drawn"));
    }

    void warn(std::string line) { data_.warnings.push_back(std::move(line)); }

    std::string nameOf(std::size_t node, const std::string& otherwise) const {
        return model_.nodes[node].name.empty() ? otherwise : model_.nodes[node].name;
    }

    const tinygltf::Model& model_;
    const File& file_;
    const formats::ModelInput& input_;
    const LoadSettings& settings_;
    Nodes nodes_;
    std::vector<std::uint32_t> sceneNodes_;  // one per node of the file: its index in the scene
    CutOuts cutOuts_;
    Scene::Data data_;
    std::map<std::pair<int, std::vector<double>>, std::optional<std::uint32_t>> meshes_;  // by mesh and morph weights
    std::set<int> seen_;               // meshes whose primitives of points have been counted
    std::size_t pointPrimitives_ = 0;  // left out
    NotDrawn notDrawn_;
    std::set<int> unread_;  // materials whose pictures a warning names
    std::uint64_t elementsLeft_;
};

}  // namespace

Scene::Data loadGltf(const formats::ModelInput& input, const LoadSettings& settings) {
    return base::within(input.where(), [&] {
        try {
            File file = readFile(input, settings.limits);
            tinygltf::Model model = parse(std::move(file.json), std::move(file.buffers));
            std::vector<std::string> warnings = std::move(file.warnings);
            if (!settings.animation.empty())
                for (std::string& warning : poseNodes(model, settings.animation, settings.time))
                    warnings.push_back(std::move(warning));
            Scene::Data data = Loader{model, file, input, settings}.load();
            data.source.scenes = namesOf(model.scenes);
            data.source.animations = namesOf(model.animations);
            data.source.extensions = file.extensions;
            data.source.files = file.named;
            data.warnings.insert(data.warnings.begin(), warnings.begin(), warnings.end());
            return data;
        } catch (const Error&) {
            throw;
        } catch (const std::bad_alloc&) {
            base::refuse("expected a model that fits into memory, found one that does not");
        } catch (const std::exception& error) {
            base::refuse("expected glTF 2.0, found: " + base::printable(error.what()));
        }
    });
}

}  // namespace inkedge::gltf
