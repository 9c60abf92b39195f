#include "gl/upload.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <unordered_map>

#include <glm/matrix.hpp>
#include <glm/vec3.hpp>

#include <inkedge/error.h>

#include "scene/patch_numbers.h"
#include "scene/topology.h"

namespace inkedge::gl {
namespace {

struct Vertex {
    glm::vec3 position;
    glm::vec3 normal;
    GLuint patch;  // of the mesh
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
    api.NamedBufferStorage(buffer.id(), static_cast<GLsizeiptr>(data.size() * sizeof(T)), data.data(), flags);
    return buffer;
}

constexpr GLuint perVertex = 0;  // vertex buffer bindings
constexpr GLuint perPlacement = 1;
constexpr GLuint perNumbering = 2;

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
    std::vector<std::uint32_t> indices;
    std::vector<DrawCommand> meshes;  // without instances
};

// A vertex that several patches share is repeated for each, so that every corner of a triangle names its patch.
void append(const Mesh& mesh, const MeshTopology& topology, Geometry& geometry) {
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
}

// Draws only the triangles of an instance's layered patches; their indices are added behind all others.
void appendLayers(const Scene& scene, std::uint32_t instance, GLuint place, Geometry& geometry,
                  std::vector<DrawCommand>& commands) {
    const PatchNumbers& patches = scene.patchNumbers();
    const std::uint32_t meshNumber = scene.instances()[instance].mesh;
    const MeshTopology& topology = scene.topology(meshNumber);
    const DrawCommand& mesh = geometry.meshes[meshNumber];
    const auto first = static_cast<GLuint>(geometry.indices.size());
    for (std::uint32_t t = 0; t < topology.patches.size(); ++t) {
        if (!patches.layered[patches.base[instance] + topology.patches[t]]) continue;
        for (std::uint32_t c = 3 * t; c < 3 * t + 3; ++c) {
            geometry.indices.push_back(geometry.indices[mesh.firstIndex + c]);
        }
    }
    const auto count = static_cast<GLuint>(geometry.indices.size()) - first;
    if (count > 0) commands.push_back({count, 1, first, mesh.baseVertex, place});
}

// Numbers from 1, negative where layers overlap: draw_planes.vert tells the two kinds apart by the sign.
std::vector<float> signedPatchNumbers(const PatchNumbers& patches) {
    std::vector<float> numbers(patches.number.size());
    for (std::size_t p = 0; p < numbers.size(); ++p) {
        numbers[p] = static_cast<float>(patches.number[p]) * (patches.layered[p] ? -1.0F : 1.0F);
    }
    return numbers;
}

}  // namespace

UploadedScene::UploadedScene(const Api& api, const Scene& scene) : api_{api}, scene_{scene.identity()} {
    Geometry geometry;
    for (std::size_t i = 0; i < scene.meshes().size(); ++i) append(scene.meshes()[i], scene.topology(i), geometry);

    const std::vector<Instance>& instances = scene.instances();
    std::uint32_t triangles = 0;
    for (const Instance& instance : instances) {
        firstTriangles_.push_back(triangles);
        triangles += geometry.meshes[instance.mesh].indexCount / 3;
    }
    instanceOrder_.resize(instances.size());
    std::iota(instanceOrder_.begin(), instanceOrder_.end(), 0U);
    std::ranges::stable_sort(instanceOrder_, {}, [&](std::uint32_t i) {
        return std::pair{mirrors(instances[i]), instances[i].mesh};
    });

    std::vector<DrawCommand> commands;
    std::vector<DrawCommand> layerCommands;
    std::vector<glm::uvec3> numberings;
    for (std::uint32_t place = 0; place < instanceOrder_.size(); ++place) {
        const std::uint32_t i = instanceOrder_[place];
        const Instance& instance = instances[i];
        const Instance* before = place > 0 ? &instances[instanceOrder_[place - 1]] : nullptr;
        if (before == nullptr || before->mesh != instance.mesh || mirrors(*before) != mirrors(instance)) {
            commands.push_back(geometry.meshes[instance.mesh]);
            commands.back().baseInstance = place;
            mirroredCount_ += mirrors(instance) ? 1 : 0;
        }
        ++commands.back().instanceCount;
        numberings.emplace_back(scene.patchNumbers().base[i], firstTriangles_[i],
                                geometry.meshes[instance.mesh].indexCount / 3);
        appendLayers(scene, i, place, geometry, layerCommands);
    }
    commandCount_ = static_cast<GLsizei>(commands.size());
    layerCommandCount_ = static_cast<GLsizei>(layerCommands.size());
    commands.insert(commands.end(), layerCommands.begin(), layerCommands.end());

    vertices_ = createFilledBuffer(api, geometry.vertices);
    indices_ = createFilledBuffer(api, geometry.indices);
    commands_ = createFilledBuffer(api, commands);
    numberings_ = createFilledBuffer(api, numberings);
    patchNumbers_ = createFilledBuffer(api, signedPatchNumbers(scene.patchNumbers()));
    placements_ = createFilledBuffer(api, std::vector<PlacedInstance>(instances.size()), GL_DYNAMIC_STORAGE_BIT);
    if (api.GetError() == GL_OUT_OF_MEMORY) {
        throw Error{Error::Kind::Runtime, "expected graphics memory for the scene, found too little"};
    }
    vertexArray_ = createVertexArray(api);
    const GLuint id = vertexArray_.id();
    api.VertexArrayElementBuffer(id, indices_.id());
    api.VertexArrayVertexBuffer(id, perVertex, vertices_.id(), 0, sizeof(Vertex));
    api.VertexArrayVertexBuffer(id, perPlacement, placements_.id(), 0, sizeof(PlacedInstance));
    api.VertexArrayVertexBuffer(id, perNumbering, numberings_.id(), 0, sizeof(glm::uvec3));
    api.VertexArrayBindingDivisor(id, perPlacement, 1);
    api.VertexArrayBindingDivisor(id, perNumbering, 1);
    describeFloats(api, id, 0, perVertex, 3, offsetof(Vertex, position));
    describeFloats(api, id, 1, perVertex, 3, offsetof(Vertex, normal));
    for (GLuint row = 0; row < 6; ++row) describeFloats(api, id, 2 + row, perPlacement, 4, row * sizeof(glm::vec4));
    describeIntegers(api, id, 8, perVertex, 1, offsetof(Vertex, patch));
    describeIntegers(api, id, 9, perNumbering, 3, 0);
}

bool UploadedScene::holds(const Scene& scene) const noexcept {
    const auto held = scene_.lock();
    return held != nullptr && held == scene.identity().lock();
}

void UploadedScene::place(const std::vector<PlacedInstance>& placements) const {
    api_.NamedBufferSubData(placements_.id(), 0, static_cast<GLsizeiptr>(placements.size() * sizeof(PlacedInstance)),
                            placements.data());
}

void UploadedScene::draw(Part part) const {
    api_.BindVertexArray(vertexArray_.id());
    api_.BindBuffer(GL_DRAW_INDIRECT_BUFFER, commands_.id());
    api_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, patchNumbers_.id());
    const auto drawCommands = [&](GLsizei first, GLsizei count, GLenum frontFace) {
        if (count == 0) return;
        api_.FrontFace(frontFace);
        const auto offset = static_cast<std::uintptr_t>(first) * sizeof(DrawCommand);
        api_.MultiDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_INT, reinterpret_cast<const void*>(offset), count, 0);
    };
    if (part == Part::Layers) {
        drawCommands(commandCount_, layerCommandCount_, GL_CCW);
    } else {
        drawCommands(0, commandCount_ - mirroredCount_, GL_CCW);
        drawCommands(commandCount_ - mirroredCount_, mirroredCount_, GL_CW);
    }
}

}  // namespace inkedge::gl
