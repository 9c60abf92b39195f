#include "gl/upload.h"

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <unordered_map>

#include <fmt/format.h>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "gl/errors.h"
#include "mesh/topology.h"
#include "scene/prepared.h"

namespace inkedge::gl {
namespace {

struct Vertex {
    glm::vec3 position;
    glm::vec3 normal;
    GLuint patch;  // of the mesh
};

// Vertex attributes that only surface functions read; none if the scene has none of them.
struct Extra {
    glm::vec2 coordinates{0.0F};
    glm::vec4 color{1.0F};
    glm::vec2 uv{0.0F};
    GLfloat curvature = 0.0F;
};

struct DrawCommand {  // DrawElementsIndirectCommand
    GLuint indexCount;
    GLuint instanceCount;
    GLuint firstIndex;
    GLint baseVertex;
    GLuint baseInstance;
};

bool mirrors(const Instance& instance) { return glm::determinant(glm::dmat3{instance.transform}) < 0.0; }

template <class T>
Buffer createFilledBuffer(const Api& api, const std::vector<T>& data, GLbitfield flags = 0) {
    Buffer buffer = createBuffer(api);
    const std::size_t size = std::max<std::size_t>(data.size(), 1) * sizeof(T);  // no buffer may be empty
    api.NamedBufferStorage(buffer.id(), static_cast<GLsizeiptr>(size), data.empty() ? nullptr : data.data(), flags);
    return buffer;
}

constexpr GLuint perVertex = 0;  // vertex buffer bindings
constexpr GLuint perInstance = 1;
constexpr GLuint perNumbering = 2;
constexpr GLuint perExtra = 3;

void describeFloats(const Api& api, GLuint vertexArray, GLuint location, GLuint binding, GLint components,
                    std::size_t offset) {
    api.EnableVertexArrayAttrib(vertexArray, location);
    api.VertexArrayAttribFormat(vertexArray, location, components, GL_FLOAT, GL_FALSE, static_cast<GLuint>(offset));
    api.VertexArrayAttribBinding(vertexArray, location, binding);
}

void describeIntegers(const Api& api, GLuint vertexArray, GLuint location, GLuint binding, GLint components,
                      std::size_t offset) {
    api.EnableVertexArrayAttrib(vertexArray, location);
    api.VertexArrayAttribIFormat(vertexArray, location, components, GL_UNSIGNED_INT, static_cast<GLuint>(offset));
    api.VertexArrayAttribBinding(vertexArray, location, binding);
}

struct Geometry {
    std::vector<Vertex> vertices;
    std::vector<Extra> extras;  // one per vertex, or none
    std::vector<std::uint32_t> indices;
    std::vector<DrawCommand> meshes;  // without instances
};

bool hasExtras(const Mesh& mesh) {
    return !mesh.textureCoordinates.empty() || !mesh.paint.empty() || !mesh.curvatures.empty();
}

Extra extraOf(const Mesh& mesh, std::size_t vertex) {
    Extra extra;
    if (!mesh.textureCoordinates.empty()) extra.coordinates = mesh.textureCoordinates[vertex];
    if (!mesh.paint.empty()) extra.color = mesh.paint[vertex].color, extra.uv = mesh.paint[vertex].uv;
    if (!mesh.curvatures.empty()) extra.curvature = mesh.curvatures[vertex];
    return extra;
}

// Appends one per vertex of the mesh, repeated vertices included.
void appendExtras(const Mesh& mesh, std::size_t base, Geometry& geometry) {
    geometry.extras.resize(geometry.vertices.size());
    const DrawCommand& command = geometry.meshes.back();
    for (std::size_t c = 0; c < mesh.indices.size(); ++c) {
        geometry.extras[base + geometry.indices[command.firstIndex + c]] = extraOf(mesh, mesh.indices[c]);
    }
}

// Appends a mesh. A vertex that several patches share is repeated for each, so that every corner of a triangle names
// its patch.
void append(const Mesh& mesh, const mesh::MeshTopology& topology, Geometry& geometry) {
    constexpr GLuint unused = ~0U;
    const auto base = geometry.vertices.size();
    geometry.meshes.push_back({static_cast<GLuint>(mesh.indices.size()), 0,
                               static_cast<GLuint>(geometry.indices.size()), static_cast<GLint>(base), 0});
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        geometry.vertices.push_back({mesh.positions[i], mesh.normals[i], unused});
    }
    std::unordered_map<std::uint64_t, std::uint32_t> repeated;
    for (std::size_t c = 0; c < mesh.indices.size(); ++c) {
        const std::uint32_t original = mesh.indices[c];
        const std::uint32_t patch = topology.patches[c / 3];
        std::uint32_t index = original;
        if (GLuint& owner = geometry.vertices[base + original].patch; owner == unused) {
            owner = patch;
        } else if (owner != patch) {
            const auto next = static_cast<std::uint32_t>(geometry.vertices.size() - base);
            const auto [found, added] = repeated.try_emplace((std::uint64_t{original} << 32U) | patch, next);
            index = found->second;
            if (added) geometry.vertices.push_back({mesh.positions[original], mesh.normals[original], patch});
        }
        geometry.indices.push_back(index);
    }
    if (hasExtras(mesh)) appendExtras(mesh, base, geometry);
}

// Triangles of an instance that are drawn alike.
struct Item {
    std::uint32_t instance = 0;
    std::uint32_t first = 0;  // of the mesh's triangles
    std::uint32_t count = 0;
    bool oneSided = false;
    bool hidesBacks = false;
    bool mirrored = false;
};

std::vector<Item> itemsOf(const Scene& scene) {
    std::vector<Item> items;
    const std::vector<Instance>& instances = scene.instances();
    for (std::uint32_t i = 0; i < instances.size(); ++i) {
        const auto total = static_cast<std::uint32_t>(scene.meshes()[instances[i].mesh].indices.size() / 3);
        const std::uint32_t oneSided = scene::oneSidedTriangles(scene, instances[i].mesh);
        const bool mirrored = mirrors(instances[i]);
        const bool hidesBacks = scene::hidesItsBacks(scene, instances[i].mesh);
        if (oneSided > 0) items.push_back({i, 0, oneSided, true, hidesBacks, mirrored});
        if (oneSided < total) items.push_back({i, oneSided, total - oneSided, false, hidesBacks, mirrored});
    }
    std::ranges::stable_sort(items, {}, [&](const Item& item) {
        return std::tuple{item.oneSided, item.hidesBacks, item.mirrored, instances[item.instance].mesh};
    });
    return items;
}

// Adds a command that draws only the triangles of layered patches. Their indices are added after all others.
// @param index  of the item among all items
void appendLayers(const Scene& scene, const Item& item, GLuint index, Geometry& geometry,
                  std::vector<DrawCommand>& commands) {
    const scene::PatchNumbers& patches = scene::patchNumbersOf(scene);
    const std::uint32_t meshNumber = scene.instances()[item.instance].mesh;
    const mesh::MeshTopology& topology = scene::topologyOf(scene, meshNumber);
    const DrawCommand& mesh = geometry.meshes[meshNumber];
    const auto first = static_cast<GLuint>(geometry.indices.size());
    for (std::uint32_t t = item.first; t < item.first + item.count; ++t) {
        if (!patches.layered[patches.base[item.instance] + topology.patches[t]]) continue;
        for (std::uint32_t c = 3 * t; c < 3 * t + 3; ++c) {
            geometry.indices.push_back(geometry.indices[mesh.firstIndex + c]);
        }
    }
    const auto count = static_cast<GLuint>(geometry.indices.size()) - first;
    if (count > 0) commands.push_back({count, 1, first, mesh.baseVertex, index});
}

// Numbers of patches, negative where layers overlap: draw_planes.vert looks at the sign. Those of other patches are so
// large that the number of a layer, which is under 2^24, is lost in rounding when it is added. A patch that a seam
// joins to a layer has the same number as the layer.
std::vector<float> signedPatchNumbers(const scene::PatchNumbers& patches) {
    std::vector<bool> ofLayers(std::size_t{patches.count} + 1, false);
    for (std::size_t p = 0; p < patches.number.size(); ++p)
        if (patches.layered[p]) ofLayers[patches.number[p]] = true;
    std::vector<float> numbers(patches.number.size());
    for (std::size_t p = 0; p < numbers.size(); ++p) {
        const float factor = patches.layered[p] ? -1.0F : ofLayers[patches.number[p]] ? 1.0F : 0x1p48F;
        numbers[p] = factor * static_cast<float>(patches.number[p]);
    }
    return numbers;
}

}  // namespace

UploadedScene::UploadedScene(const Api& api, const Scene& scene) : api_{api}, scene_{scene::identityOf(scene)} {
    Geometry geometry;
    std::size_t vertexCount = 0;
    std::size_t indexCount = 0;
    for (const Mesh& mesh : scene.meshes()) vertexCount += mesh.positions.size(), indexCount += mesh.indices.size();
    geometry.vertices.reserve(vertexCount);
    geometry.indices.reserve(indexCount);
    for (std::size_t i = 0; i < scene.meshes().size(); ++i)
        append(scene.meshes()[i], scene::topologyOf(scene, i), geometry);

    const std::vector<Instance>& instances = scene.instances();
    std::uint32_t triangles = 0;
    for (const Instance& instance : instances) {
        firstTriangles_.push_back(triangles);
        triangles += geometry.meshes[instance.mesh].indexCount / 3;
    }
    const std::vector<Item> items = itemsOf(scene);
    std::vector<DrawCommand> commands;
    std::vector<DrawCommand> layerCommands;
    std::vector<glm::uvec3> numberings;
    const auto extend = [](std::vector<Run>& runs, const Item& item, std::size_t first, std::size_t end) {
        Run run{item.oneSided, item.hidesBacks, item.mirrored, static_cast<GLsizei>(first), 0};
        if (runs.empty() || !runs.back().drawnLike(run)) runs.push_back(run);
        runs.back().count = static_cast<GLsizei>(end) - runs.back().first;
    };
    for (std::uint32_t index = 0; index < items.size(); ++index) {
        const Item& item = items[index];
        const Item* const before = index > 0 ? &items[index - 1] : nullptr;
        const std::uint32_t mesh = instances[item.instance].mesh;
        const bool another = before == nullptr || before->oneSided != item.oneSided ||
                             before->mirrored != item.mirrored || instances[before->instance].mesh != mesh;
        if (another) {
            DrawCommand command = geometry.meshes[mesh];
            command.firstIndex += 3 * item.first;
            command.indexCount = 3 * item.count;
            command.baseInstance = index;
            commands.push_back(command);
            extend(runs_, item, commands.size() - 1, commands.size());
        }
        ++commands.back().instanceCount;
        instanceOrder_.push_back(item.instance);
        numberings.emplace_back(scene::patchNumbersOf(scene).base[item.instance],
                                firstTriangles_[item.instance] + item.first, item.count);
        const std::size_t layers = layerCommands.size();
        appendLayers(scene, item, index, geometry, layerCommands);
        if (layerCommands.size() > layers) extend(layerRuns_, item, layers, layerCommands.size());
    }
    for (Run& run : layerRuns_) run.first += static_cast<GLsizei>(commands.size());
    commands.insert(commands.end(), layerCommands.begin(), layerCommands.end());

    vertices_ = createFilledBuffer(api, geometry.vertices);
    vertexCount = geometry.vertices.size();
    geometry.vertices = std::vector<Vertex>{};  // frees the memory before the buffers are made; = {} would not
    if (!geometry.extras.empty()) {
        geometry.extras.resize(vertexCount);
        extras_ = createFilledBuffer(api, geometry.extras);
        geometry.extras = {};
    }
    indices_ = createFilledBuffer(api, geometry.indices);
    geometry.indices = {};
    commands_ = createFilledBuffer(api, commands);
    numberings_ = createFilledBuffer(api, numberings);
    patchNumbers_ = createFilledBuffer(api, signedPatchNumbers(scene::patchNumbersOf(scene)));
    transforms_ = createFilledBuffer(api, std::vector<InstanceTransforms>(items.size()), GL_DYNAMIC_STORAGE_BIT);
    checkErrors(api, fmt::format("a scene of {} triangles", triangles), "draw a smaller model or use --backend osmesa");
    vertexArray_ = createVertexArray(api);
    const GLuint id = vertexArray_.id();
    api.VertexArrayElementBuffer(id, indices_.id());
    api.VertexArrayVertexBuffer(id, perVertex, vertices_.id(), 0, sizeof(Vertex));
    api.VertexArrayVertexBuffer(id, perInstance, transforms_.id(), 0, sizeof(InstanceTransforms));
    api.VertexArrayVertexBuffer(id, perNumbering, numberings_.id(), 0, sizeof(glm::uvec3));
    api.VertexArrayBindingDivisor(id, perInstance, 1);
    api.VertexArrayBindingDivisor(id, perNumbering, 1);
    describeFloats(api, id, 0, perVertex, 3, offsetof(Vertex, position));
    describeFloats(api, id, 1, perVertex, 3, offsetof(Vertex, normal));
    for (GLuint row = 0; row < 6; ++row) describeFloats(api, id, 2 + row, perInstance, 4, row * sizeof(glm::vec4));
    describeIntegers(api, id, 8, perVertex, 1, offsetof(Vertex, patch));
    describeIntegers(api, id, 9, perNumbering, 3, 0);
    if (extras_.id() == 0) return;
    api.VertexArrayVertexBuffer(id, perExtra, extras_.id(), 0, sizeof(Extra));
    describeFloats(api, id, 10, perExtra, 2, offsetof(Extra, coordinates));
    describeFloats(api, id, 11, perExtra, 4, offsetof(Extra, color));
    describeFloats(api, id, 12, perExtra, 2, offsetof(Extra, uv));
    describeFloats(api, id, 13, perExtra, 1, offsetof(Extra, curvature));
}

bool UploadedScene::holds(const Scene& scene) const noexcept {
    const auto held = scene_.lock();
    return held != nullptr && held == scene::identityOf(scene).lock();
}

void UploadedScene::setTransforms(const std::vector<InstanceTransforms>& transforms) const {
    api_.NamedBufferSubData(transforms_.id(), 0,
                            static_cast<GLsizeiptr>(transforms.size() * sizeof(InstanceTransforms)), transforms.data());
}

void UploadedScene::draw(Triangles triangles, HiddenBacks backs) const {
    api_.BindVertexArray(vertexArray_.id());
    api_.BindBuffer(GL_DRAW_INDIRECT_BUFFER, commands_.id());
    api_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, patchNumbers_.id());
    api_.CullFace(GL_BACK);
    for (const Run& run : triangles == Triangles::Layers ? layerRuns_ : runs_) draw(run, backs);
    api_.Disable(GL_CULL_FACE);
}

void UploadedScene::draw(const Run& run, HiddenBacks backs) const {
    api_.FrontFace(run.mirrored ? GL_CW : GL_CCW);
    const bool cull = run.oneSided || (run.hidesBacks && backs == HiddenBacks::Skip);
    cull ? api_.Enable(GL_CULL_FACE) : api_.Disable(GL_CULL_FACE);
    const auto offset = static_cast<std::uintptr_t>(run.first) * sizeof(DrawCommand);
    api_.MultiDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_INT, reinterpret_cast<const void*>(offset), run.count, 0);
}

}  // namespace inkedge::gl
