#include "gl/function_inputs.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <inkedge/settings.h>

#include "base/message.h"
#include "base/read_file.h"
#include "gl/errors.h"
#include "images/decode_picture.h"
#include "scene/face_edges.h"
#include "scene/prepared.h"

namespace inkedge::gl {
namespace {

using Picture = Image<std::uint8_t>;  // RGBA

// struct Paint of shaders/shared/paint.glsl.
struct PaintEntry {
    glm::vec4 factor{1.0F};
    GLuint first = 0;
    GLuint width = 0;
    GLuint height = 0;
    GLuint levels = 0;
    glm::uvec2 wrap{0};
    glm::uvec2 unused{0};
};
static_assert(sizeof(PaintEntry) == 48);

// A copy half as wide and high: each texel is the mean of four. The last row and column of odd sizes are left out.
Picture halved(const Picture& picture) {
    const Size size{std::max(picture.size().width / 2, 1), std::max(picture.size().height / 2, 1)};
    Picture half{size, 4};
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const int right = std::min(2 * x + 1, picture.size().width - 1);
            const int below = std::min(2 * y + 1, picture.size().height - 1);
            for (int c = 0; c < 4; ++c) {
                const int sum = picture(2 * x < right ? 2 * x : right, 2 * y < below ? 2 * y : below, c) +
                                picture(right, 2 * y < below ? 2 * y : below, c) +
                                picture(2 * x < right ? 2 * x : right, below, c) + picture(right, below, c);
                half(x, y, c) = static_cast<std::uint8_t>((sum + 2) / 4);
            }
        }
    }
    return half;
}

std::uint32_t texel(const Picture& picture, std::size_t i) {
    const std::uint8_t* const p = &picture.pixels()[4 * i];
    return p[0] | std::uint32_t{p[1]} << 8U | std::uint32_t{p[2]} << 16U | std::uint32_t{p[3]} << 24U;
}

// Appends the halved copies of a picture, from the first that is no larger than maxSide down to one texel.
void append(const Picture& source, int maxSide, PaintEntry& entry, std::vector<std::uint32_t>& texels) {
    Picture picture = source;
    while (std::max(picture.size().width, picture.size().height) > maxSide) picture = halved(picture);
    entry.first = static_cast<GLuint>(texels.size());
    entry.width = static_cast<GLuint>(picture.size().width);
    entry.height = static_cast<GLuint>(picture.size().height);
    for (entry.levels = 1;; ++entry.levels) {
        for (std::size_t i = 0; i < picture.pixels().size() / 4; ++i) texels.push_back(texel(picture, i));
        if (picture.size().width == 1 && picture.size().height == 1) return;
        picture = halved(picture);
    }
}

// The largest side at which all pictures fit into one buffer.
int sideThatFits(const Scene& scene, std::size_t maxTexels) {
    for (int side = 4096; side > 1; side /= 2) {
        std::size_t sum = 0;
        for (const Material& material : scene.materials()) {
            if (!material.picture) continue;
            auto [width, height] = material.picture->size();
            while (std::max(width, height) > side) width = std::max(width / 2, 1), height = std::max(height / 2, 1);
            sum += static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3 / 2 + 32;
        }
        if (sum <= maxTexels) return side;
    }
    return 1;
}

std::vector<GLuint> materialsOfTriangles(const Scene& scene) {
    std::vector<GLuint> materials;
    for (const Instance& instance : scene.instances()) {
        const Mesh& mesh = scene.meshes()[instance.mesh];
        for (std::size_t t = 0; t < mesh.indices.size() / 3; ++t) {
            const std::uint32_t material = mesh.materials.empty() ? 0 : mesh.materials[t];
            materials.push_back(material <= scene.materials().size() ? material : 0);
        }
    }
    return materials;
}

// No buffer is of no bytes: of lines alone, or without a picture, it holds one value that nothing reads.
template <class T>
Buffer filled(const Api& api, std::vector<T> data) {
    if (data.empty()) data.emplace_back();
    Buffer buffer = createBuffer(api);
    api.NamedBufferStorage(buffer.id(), static_cast<GLsizeiptr>(data.size() * sizeof(T)), data.data(), 0);
    return buffer;
}

TextureName uploadPicture(const Api& api, const Picture& picture) {
    GLuint id = 0;
    api.CreateTextures(GL_TEXTURE_2D, 1, &id);
    TextureName name{api, id};
    const auto [width, height] = picture.size();
    api.TextureStorage2D(id, 1, GL_RGBA8, width, height);
    api.BindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    api.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    api.TextureSubImage2D(id, 0, 0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, picture.pixels().data());
    api.TextureParameteri(id, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    api.TextureParameteri(id, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    api.TextureParameteri(id, GL_TEXTURE_WRAP_S, GL_REPEAT);
    api.TextureParameteri(id, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    checkErrors(api, "a surface function's picture", "use a smaller picture");
    return name;
}

}  // namespace

void FunctionInputs::bindPicture(const std::string& file) {
    const TextureName& picture = pictures_.of(file, [&] {
        const Picture read = base::within(base::printable(file), [&] {
            LoadLimits limits;
            return images::decodePicture(base::readBytes(file, limits.fileSize), limits.imagePixels);
        });
        return uploadPicture(api_, read);
    });
    api_.BindTextureUnit(0, picture.id());
    api_.BindSampler(0, 0);
}

FunctionInputs::Paint FunctionInputs::upload(const Scene& scene) const {
    GLint maxBytes = 0;
    api_.GetIntegerv(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &maxBytes);
    const int side = sideThatFits(scene, static_cast<std::size_t>(maxBytes) / 4);
    std::vector<PaintEntry> entries(1);  // of triangles without a material
    std::vector<std::uint32_t> texels;
    for (const Material& material : scene.materials()) {
        PaintEntry& entry = entries.emplace_back();
        entry.factor = material.color;
        entry.wrap = {static_cast<GLuint>(material.wrap[0]), static_cast<GLuint>(material.wrap[1])};
        if (material.picture) append(*material.picture, side, entry, texels);
    }
    Paint paint{scene::identityOf(scene), filled(api_, materialsOfTriangles(scene)), filled(api_, entries),
                filled(api_, texels)};
    checkErrors(api_, "the pictures of a scene's materials", "draw a smaller model or use --backend osmesa");
    return paint;
}

void FunctionInputs::bindPaint(const Scene& scene) {
    const auto held = paint_.scene.lock();
    if (held == nullptr || held != scene::identityOf(scene).lock()) paint_ = upload(scene);
    api_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, paint_.triangles.id());
    api_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 2, paint_.materials.id());
    api_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 3, paint_.texels.id());
}

void FunctionInputs::bindFaceEdges(const Scene& scene) {
    const auto held = faces_.scene.lock();
    if (held == nullptr || held != scene::identityOf(scene).lock()) {
        faces_ = {scene::identityOf(scene), filled(api_, scene::faceEdgesOf(scene))};
        checkErrors(api_, "the edges of a scene's faces", "draw a smaller model or use --backend osmesa");
    }
    api_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, faces_.edges.id());
}

}  // namespace inkedge::gl
