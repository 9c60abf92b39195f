#pragma once

#include <utility>

#include "gl/api.h"

namespace inkedge::gl {

/// Owns one OpenGL name: moves, never copies, deletes once. Must die while its context is current.
template <void (*remove)(const Api&, GLuint)>
class Handle {
public:
    Handle() noexcept = default;
    Handle(const Api& api, GLuint id) noexcept : api_{&api}, id_{id} {}
    Handle(Handle&& from) noexcept : api_{from.api_}, id_{std::exchange(from.id_, 0)} {}
    Handle& operator=(Handle&& from) noexcept {
        std::swap(api_, from.api_);
        std::swap(id_, from.id_);
        return *this;
    }
    ~Handle() {
        if (id_ != 0) remove(*api_, id_);
    }
    [[nodiscard]] GLuint id() const noexcept { return id_; }

private:
    const Api* api_ = nullptr;
    GLuint id_ = 0;  // 0: owns nothing
};

inline void removeBuffer(const Api& api, GLuint id) { api.DeleteBuffers(1, &id); }
inline void removeVertexArray(const Api& api, GLuint id) { api.DeleteVertexArrays(1, &id); }
inline void removeFramebuffer(const Api& api, GLuint id) { api.DeleteFramebuffers(1, &id); }
inline void removeTexture(const Api& api, GLuint id) { api.DeleteTextures(1, &id); }
inline void removeProgram(const Api& api, GLuint id) { api.DeleteProgram(id); }
inline void removeShader(const Api& api, GLuint id) { api.DeleteShader(id); }

using Buffer = Handle<removeBuffer>;
using VertexArray = Handle<removeVertexArray>;
using FramebufferName = Handle<removeFramebuffer>;
using TextureName = Handle<removeTexture>;
using ProgramName = Handle<removeProgram>;
using ShaderName = Handle<removeShader>;

[[nodiscard]] inline Buffer createBuffer(const Api& api) {
    GLuint id = 0;
    api.CreateBuffers(1, &id);
    return {api, id};
}
[[nodiscard]] inline VertexArray createVertexArray(const Api& api) {
    GLuint id = 0;
    api.CreateVertexArrays(1, &id);
    return {api, id};
}

}  // namespace inkedge::gl
