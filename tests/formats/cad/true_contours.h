#pragma once

#include <filesystem>
#include <limits>
#include <memory>

#include <glm/vec3.hpp>

namespace inkedge::cad_files {

/// Smooth contours of a STEP file's faces by OpenCASCADE's own surfaces. Millimetres.
class TrueContours {
public:
    explicit TrueContours(const std::filesystem::path& step);
    ~TrueContours();

    /// What sees the surfaces.
    struct Eye {
        bool orthographic = false;
        glm::dvec3 position{0.0};   ///< perspective
        glm::dvec3 direction{0.0};  ///< orthographic
    };

    static constexpr double none = std::numeric_limits<double>::infinity();

    /// How far a point lies from the contour of the faces that it lies near, across the contour as the eye sees it.
    /// none: there is no contour within reach.
    [[nodiscard]] double offsetOf(glm::dvec3 point, const Eye&, double reach) const;

private:
    struct Faces;
    std::unique_ptr<const Faces> faces_;
};

}  // namespace inkedge::cad_files
