#pragma once

#include <initializer_list>
#include <vector>

#include "gl/gpu.h"

namespace inkedge::gl {

/// A framebuffer object around textures of one size.
class Framebuffer {
public:
    /// @param depth   may be null
    /// @throws Error  (Kind::Runtime) if the driver cannot draw to this combination
    Framebuffer(const Api&, std::initializer_list<const Texture*> colors, const Texture* depth = nullptr);

    [[nodiscard]] GLuint id() const noexcept { return name_.id(); }
    [[nodiscard]] Size size() const noexcept { return size_; }
    [[nodiscard]] bool hasDepth() const noexcept { return hasDepth_; }

private:
    FramebufferName name_;
    Size size_;
    bool hasDepth_;
};

/// Sets all state that drawing depends on: row 0 of the target is the picture's top row, depth runs from 1 at near to 0
/// at far and is tested if the target has a depth texture, nothing is culled or blended, front faces wind
/// counter-clockwise.
/// @param inputs  textures for the bindings 0, 1, ...
void prepareDrawing(Gpu&, Program, const Framebuffer& target, std::initializer_list<const Texture*> inputs = {});

/// The same with a program by its OpenGL name.
void prepareDrawing(Gpu&, GLuint program, const Framebuffer& target, std::initializer_list<const Texture*> inputs = {});

/// Runs a program once for every pixel of the target.
void drawFullscreen(Gpu&, Program, const Framebuffer& target, std::initializer_list<const Texture*> inputs);

}  // namespace inkedge::gl
