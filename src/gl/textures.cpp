#include "gl/textures.h"

#include <algorithm>

#include <fmt/format.h>

#include "gl/errors.h"

namespace inkedge::gl {

Texture::~Texture() {
    if (name_.id() != 0) pool_->free_.push_back({std::move(name_), size_, format_, 0});
}

void writeBytes(const Api& api, const Image<std::uint8_t>& image, const raster::Rectangle& part,
                const Texture& texture) {
    api.BindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    api.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    api.PixelStorei(GL_UNPACK_ROW_LENGTH, image.size().width);
    api.TextureSubImage2D(texture.id(), 0, 0, 0, part.size.width, part.size.height, GL_RGBA, GL_UNSIGNED_BYTE,
                          &image(part.x, part.y));
    api.PixelStorei(GL_UNPACK_ROW_LENGTH, 0);
}

Texture TexturePool::acquire(Size size, GLenum format) {
    const auto found = std::ranges::find_if(free_, [&](const Free& f) { return f.size == size && f.format == format; });
    if (found != free_.end()) {
        Texture texture{*this, std::move(found->name), size, format};
        free_.erase(found);
        return texture;
    }
    GLuint id = 0;
    api_.CreateTextures(GL_TEXTURE_2D, 1, &id);
    TextureName name{api_, id};
    api_.TextureStorage2D(id, 1, format, size.width, size.height);
    checkErrors(api_, fmt::format("a picture of {} x {} pixels", size.width, size.height),
                "ask for a smaller --size or --tile-size");
    api_.TextureParameteri(id, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    api_.TextureParameteri(id, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    api_.TextureParameteri(id, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    api_.TextureParameteri(id, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    return {*this, std::move(name), size, format};
}

void TexturePool::trim() {
    std::erase_if(free_, [](Free& f) { return ++f.trims > 1; });
}

}  // namespace inkedge::gl
