#include "gl/upload.h"

#include <algorithm>
#include <cstddef>

#include <glm/matrix.hpp>

#include <inkedge/error.h>

namespace inkedge::gl {
namespace {

struct Vertex {
    glm::vec3 position;
    glm::vec3 normal;
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

void describeAttribute(const Api& api, GLuint vertexArray, GLuint location, GLuint binding, GLint components,
                       std::size_t offset) {
    api.EnableVertexArrayAttrib(vertexArray, location);
    api.VertexArrayAttribFormat(vertexArray, location, components, GL_FLOAT, GL_FALSE, static_cast<GLuint>(offset));
    api.VertexArrayAttribBinding(vertexArray, location, binding);
}

}  // namespace

UploadedScene::UploadedScene(const Api& api, const Scene& scene) : api_{api}, scene_{scene.identity()} {
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;
    std::vector<DrawCommand> meshes;
    for (const Mesh& mesh : scene.meshes()) {
        meshes.push_back({static_cast<GLuint>(mesh.indices.size()), 0, static_cast<GLuint>(indices.size()),
                          static_cast<GLint>(vertices.size()), 0});
        for (std::size_t i = 0; i < mesh.positions.size(); ++i) vertices.push_back({mesh.positions[i], mesh.normals[i]});
        indices.insert(indices.end(), mesh.indices.begin(), mesh.indices.end());
    }

    const std::vector<Instance>& instances = scene.instances();
    instanceOrder_.resize(instances.size());
    for (std::uint32_t i = 0; i < instanceOrder_.size(); ++i) instanceOrder_[i] = i;
    std::ranges::stable_sort(instanceOrder_, {}, [&](std::uint32_t i) {
        return std::pair{mirrors(instances[i]), instances[i].mesh};
    });
    std::vector<DrawCommand> commands;
    for (std::uint32_t place = 0; place < instanceOrder_.size(); ++place) {
        const Instance& instance = instances[instanceOrder_[place]];
        const Instance* before = place > 0 ? &instances[instanceOrder_[place - 1]] : nullptr;
        if (before == nullptr || before->mesh != instance.mesh || mirrors(*before) != mirrors(instance)) {
            commands.push_back(meshes[instance.mesh]);
            commands.back().baseInstance = place;
            mirroredCount_ += mirrors(instance) ? 1 : 0;
        }
        ++commands.back().instanceCount;
    }
    commandCount_ = static_cast<GLsizei>(commands.size());

    vertices_ = createFilledBuffer(api, vertices);
    indices_ = createFilledBuffer(api, indices);
    commands_ = createFilledBuffer(api, commands);
    instances_ = createFilledBuffer(api, std::vector<PlacedInstance>(instances.size()), GL_DYNAMIC_STORAGE_BIT);
    if (api.GetError() == GL_OUT_OF_MEMORY) {
        throw Error{Error::Kind::Runtime, "expected graphics memory for the scene, found too little"};
    }
    vertexArray_ = createVertexArray(api);
    const GLuint id = vertexArray_.id();
    api.VertexArrayElementBuffer(id, indices_.id());
    api.VertexArrayVertexBuffer(id, 0, vertices_.id(), 0, sizeof(Vertex));
    api.VertexArrayVertexBuffer(id, 1, instances_.id(), 0, sizeof(PlacedInstance));
    api.VertexArrayBindingDivisor(id, 1, 1);
    describeAttribute(api, id, 0, 0, 3, offsetof(Vertex, position));
    describeAttribute(api, id, 1, 0, 3, offsetof(Vertex, normal));
    for (GLuint row = 0; row < 6; ++row) describeAttribute(api, id, 2 + row, 1, 4, row * sizeof(glm::vec4));
}

bool UploadedScene::holds(const Scene& scene) const noexcept {
    const auto held = scene_.lock();
    return held != nullptr && held == scene.identity().lock();
}

void UploadedScene::draw(const std::vector<PlacedInstance>& placements) const {
    api_.NamedBufferSubData(instances_.id(), 0, static_cast<GLsizeiptr>(placements.size() * sizeof(PlacedInstance)),
                            placements.data());
    api_.BindVertexArray(vertexArray_.id());
    api_.BindBuffer(GL_DRAW_INDIRECT_BUFFER, commands_.id());
    const auto drawCommands = [&](GLsizei first, GLsizei count, GLenum frontFace) {
        if (count == 0) return;
        api_.FrontFace(frontFace);
        const auto offset = static_cast<std::uintptr_t>(first) * sizeof(DrawCommand);
        api_.MultiDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_INT, reinterpret_cast<const void*>(offset), count, 0);
    };
    drawCommands(0, commandCount_ - mirroredCount_, GL_CCW);
    drawCommands(commandCount_ - mirroredCount_, mirroredCount_, GL_CW);
}

}  // namespace inkedge::gl
