#pragma once

#include <memory>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include <inkedge/scene.h>

#include "gl/gpu.h"

namespace inkedge::gl {

/// A scene in graphics memory: one vertex array for all meshes, one indirect draw command for each mesh and handedness.
class UploadedScene {
public:
    UploadedScene(const Api&, const Scene&);

    [[nodiscard]] bool holds(const Scene& scene) const noexcept;

    /// What changes with the view. Rows of 3 x 4 matrices, as shaders/draw_surface.vert reads them.
    struct PlacedInstance {
        glm::vec4 modelView[3];
        glm::vec4 normalMatrix[3];
    };

    /// The instances in the order in which placements are given to draw().
    [[nodiscard]] const std::vector<std::uint32_t>& instanceOrder() const noexcept { return instanceOrder_; }

    /// Draws every triangle with what prepareDrawing() has set.
    /// @param placements  one for each of instanceOrder()
    void draw(const std::vector<PlacedInstance>& placements) const;

private:
    const Api& api_;
    std::weak_ptr<const void> scene_;
    Buffer vertices_;
    Buffer indices_;
    Buffer instances_;
    Buffer commands_;
    VertexArray vertexArray_;
    std::vector<std::uint32_t> instanceOrder_;
    GLsizei commandCount_ = 0;
    GLsizei mirroredCount_ = 0;  // the last of the commands: their instances mirror, so their front faces wind clockwise
};

}  // namespace inkedge::gl
