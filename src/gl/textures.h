#pragma once

#include <memory>
#include <vector>

#include <inkedge/image.h>

#include "gl/objects.h"
#include "raster/rectangle.h"

namespace inkedge::gl {

class TexturePool;

/// A texture with one level, borrowed from a pool. Its storage goes back to the pool when the texture is destroyed.
class Texture {
public:
    Texture(Texture&& from) noexcept = default;
    Texture& operator=(Texture&& from) noexcept = default;
    ~Texture();

    [[nodiscard]] GLuint id() const noexcept { return name_.id(); }
    [[nodiscard]] Size size() const noexcept { return size_; }
    [[nodiscard]] GLenum format() const noexcept { return format_; }

private:
    friend class TexturePool;
    Texture(TexturePool& pool, TextureName name, Size size, GLenum format) noexcept
        : pool_{&pool}, name_{std::move(name)}, size_{size}, format_{format} {}

    TexturePool* pool_;
    TextureName name_;
    Size size_;
    GLenum format_;
};

/// Fills an RGBA8 texture with a part of an image. The part has the texture's size.
/// @param image  4 channels
void writeBytes(const Api&, const Image<std::uint8_t>& image, const raster::Rectangle& part, const Texture&);

/// Textures that are allocated once and used again by later views of one size. The pool must outlive its textures.
class TexturePool {
public:
    explicit TexturePool(const Api& api) : api_{api} {}

    /// @param format  a sized internal format, for example GL_RGBA32F. The contents are undefined.
    /// @throws Error  (Kind::Runtime) if the context is out of memory or lost
    [[nodiscard]] Texture acquire(Size size, GLenum format);

    /// Frees the textures that were not used since the last call.
    void trim();

private:
    friend class Texture;
    struct Free {
        TextureName name;
        Size size;
        GLenum format;
        int trims;  // calls of trim() since its last use
    };
    const Api& api_;
    std::vector<Free> free_;
};

}  // namespace inkedge::gl
