#pragma once

#include <memory>
#include <string>

#include <inkedge/scene.h>

#include "base/kept_files.h"
#include "gl/objects.h"

namespace inkedge::gl {

/// What surface functions and some passes read besides the scene's vertices: pictures from files, the materials'
/// colours and pictures, and what lies beyond the edges of faces. Kept from view to view.
class FunctionInputs {
public:
    explicit FunctionInputs(const Api& api) : api_{api} {}

    /// Binds a file's picture, as the file is now, as shaders/shared/surface.glsl reads it.
    /// @throws Error  (Kind::Input) if the file is missing or no PNG, JPEG or WebP
    void bindPicture(const std::string& file);

    /// Binds the scene's materials as shaders/shared/paint.glsl reads them.
    /// @throws Error  (Kind::Runtime) if the context is out of memory
    void bindPaint(const Scene&);

    /// Binds scene::faceEdgesOf() the scene as shaders/draw_fattened.geom reads them.
    /// @throws Error  (Kind::Runtime) if the context is out of memory
    void bindFaceEdges(const Scene&);

private:
    struct Paint {
        std::weak_ptr<const void> scene;
        Buffer triangles;
        Buffer materials;
        Buffer texels;
    };
    struct Faces {
        std::weak_ptr<const void> scene;
        Buffer edges;
    };
    [[nodiscard]] Paint upload(const Scene&) const;

    const Api& api_;
    base::KeptFiles<TextureName> pictures_;
    Paint paint_;
    Faces faces_;
};

}  // namespace inkedge::gl
