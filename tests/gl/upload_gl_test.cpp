#include "gl/upload.h"

#include <gmock/gmock.h>

#include "gl/gl_test.h"
#include "scenes.h"

namespace inkedge::gl {
namespace {

INKEDGE_ON_EACH_BACKEND(Uploading);

// What went through counting(): a function pointer cannot hold it. Nothing is drawn, as no program is in use.
GLsizeiptr bytesUploaded = 0;
GLsizei commandsDrawn = 0;
PFNGLNAMEDBUFFERSTORAGEPROC upload = nullptr;

Api counting(Api api) {
    upload = api.NamedBufferStorage;
    bytesUploaded = 0;
    commandsDrawn = 0;
    api.NamedBufferStorage = [](GLuint buffer, GLsizeiptr size, const void* data, GLbitfield flags) {
        bytesUploaded += size;
        upload(buffer, size, data, flags);
    };
    api.MultiDrawElementsIndirect = [](GLenum, GLenum, const void*, GLsizei count, GLsizei) { commandsDrawn += count; };
    return api;
}

TEST_P(Uploading, StoresAMeshOnceAndDrawsItsInstancesByOneCommand) {
    constexpr int instances = 3000;
    Scene::Data data;
    data.meshes = {scenes::sphere(0.4, 16)};
    for (int i = 0; i < instances; ++i) data.instances.push_back({"", 0, scenes::translation({i % 50, i / 50, 0})});
    const Scene scene{std::move(data)};
    ASSERT_EQ(scene.meshes().size(), 1U);
    const auto meshBytes =
        static_cast<GLsizeiptr>(scene.meshes()[0].positions.size() * (2 * sizeof(glm::vec3) + sizeof(GLuint)) +
                                scene.meshes()[0].indices.size() * sizeof(std::uint32_t));

    const Current current{context()};
    const Api api = counting(context().api());
    const UploadedScene uploaded{api, scene};
    // A transform of 24 floats, a numbering of 3 integers and a patch's number; and some draw commands.
    EXPECT_LE(bytesUploaded, meshBytes + instances * (24 * 4 + 3 * 4 + 4) + 1000);
    uploaded.draw(UploadedScene::Triangles::All, UploadedScene::HiddenBacks::Draw);
    EXPECT_EQ(commandsDrawn, 1);
}

}  // namespace
}  // namespace inkedge::gl
