#pragma once

#include <memory>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include <inkedge/scene.h>

#include "gl/gpu.h"

namespace inkedge::gl {

/// A scene in graphics memory: one vertex array for all meshes, one indirect draw command for all instances of a mesh
/// that are drawn alike.
class UploadedScene {
public:
    /// @throws Error  (Kind::Runtime) if the context is out of memory or lost
    UploadedScene(const Api&, const Scene&);

    [[nodiscard]] bool holds(const Scene& scene) const noexcept;

    /// The matrices of an instance that change with the view: rows of 3 x 4 matrices, as the vertex shaders read them.
    struct InstanceTransforms {
        glm::vec4 modelView[3];
        glm::vec4 normalMatrix[3];
    };

    /// Which triangles to draw.
    enum class Triangles {
        All,
        Layers,  ///< those of patches that overlap others in one plane: PatchNumbers::layered
    };

    /// The instances in the order of setTransforms(). An instance may be there twice: for its one-sided triangles and
    /// for the others.
    [[nodiscard]] const std::vector<std::uint32_t>& instanceOrder() const noexcept { return instanceOrder_; }

    /// Sets the matrices of the instances for the next draws.
    /// @param transforms  one for each of instanceOrder()
    void setTransforms(const std::vector<InstanceTransforms>& transforms) const;

    /// Whether to draw the backs of meshes that hide them: hidesItsBacks().
    enum class HiddenBacks { Draw, Skip };

    /// Draws with the state that prepareDrawing() has set. Normals point away from front faces.
    void draw(Triangles, HiddenBacks) const;

    [[nodiscard]] bool hasLayers() const noexcept { return !layerRuns_.empty(); }

    /// For each instance of the scene the number of its first triangle in the scene.
    [[nodiscard]] const std::vector<std::uint32_t>& firstTriangles() const noexcept { return firstTriangles_; }

private:
    // Consecutive commands that need the same state.
    struct Run {
        bool oneSided = false;    // backs are not drawn
        bool hidesBacks = false;  // backs need not be drawn
        bool mirrored = false;    // front faces wind clockwise
        GLsizei first = 0;
        GLsizei count = 0;
        [[nodiscard]] bool drawnLike(const Run& other) const noexcept {
            return oneSided == other.oneSided && hidesBacks == other.hidesBacks && mirrored == other.mirrored;
        }
    };
    void draw(const Run&, HiddenBacks) const;

    const Api& api_;
    std::weak_ptr<const void> scene_;
    Buffer vertices_;
    Buffer extras_;
    Buffer indices_;
    Buffer transforms_;
    Buffer numberings_;
    Buffer patchNumbers_;
    Buffer commands_;
    VertexArray vertexArray_;
    std::vector<std::uint32_t> instanceOrder_;
    std::vector<std::uint32_t> firstTriangles_;
    std::vector<Run> runs_;
    std::vector<Run> layerRuns_;
};

}  // namespace inkedge::gl
