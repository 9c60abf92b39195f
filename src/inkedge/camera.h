#pragma once

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include <inkedge/export.h>
#include <inkedge/scene.h>
#include <inkedge/settings.h>

namespace inkedge {

/// Where a picture is taken from, and how.
struct Camera {
    glm::dmat4 view{1.0};             ///< world -> view space: right-handed, looks along -Z
    double viewAngle = 35.0;          ///< vertical, degrees, over 0 and under 180; perspective only
    double orthographicHeight = 0.0;  ///< scene units across the picture's height; 0: perspective
    double near = 0.0;                ///< distance of the near plane along the view direction, scene units
    double far = 0.0;                 ///< and of the far plane; 0: both are fitted to the scene that is drawn
    /// Where the view axis meets the picture, right of and above its middle; halves of its width and height. A picture
    /// cut out of a larger one keeps its perspective so.
    glm::dvec2 axis{0.0};
    double pixelAspect = 1.0;  ///< a pixel's width by its height, over 0: 1 is a square; perspective only

    [[nodiscard]] bool orthographic() const noexcept { return orthographicHeight > 0.0; }

    /// View space -> OpenGL clip space (-w <= z <= w), for pictures of this size.
    [[nodiscard]] INKEDGE_API glm::dmat4 projection(Size) const noexcept;

    /// The pixel of pictures of this size that the view axis meets.
    [[nodiscard]] INKEDGE_API glm::dvec2 centre(Size) const noexcept;

    /// Focal length in pixels of pictures of this size, counted upwards; orthographic: pixels per scene unit.
    [[nodiscard]] INKEDGE_API double focalLength(Size) const noexcept;
    /// The same counted to the right, and upwards: OpenCV's fx and fy.
    [[nodiscard]] INKEDGE_API glm::dvec2 focalLengths(Size) const noexcept;

    /// World -> camera as OpenCV has it: x right, y down, z into the scene.
    [[nodiscard]] INKEDGE_API glm::dmat4 worldToCamera() const noexcept;

    /// OpenCV's K: from that camera's x/z, y/z and 1 to pixels of pictures of this size, (0, 0) the middle of the first
    /// one. In an orthographic view from x, y and 1.
    [[nodiscard]] INKEDGE_API glm::dmat3 intrinsics(Size) const noexcept;
};

/// The camera itself or, if its far plane is 0, with near and far planes fitted to the scene: what draws it sees these.
[[nodiscard]] INKEDGE_API Camera withPlanes(Camera, const Scene&) noexcept;

/// The axes of a camera's own space.
enum class CameraAxes {
    OpenGl,  ///< x right, y up, z towards the eye
    OpenCv,  ///< x right, y down, z into the scene
};

/// The camera of a calibration, for pictures of this size. Its near and far planes are fitted to the scene that is
/// drawn.
/// @param k     as Camera::intrinsics() of a perspective view: focal lengths and principal point in pixels
/// @param pose  camera space -> world: a rotation and a translation
/// @throws Error  (Kind::Usage) if k is no such matrix, the pose does more than rotate and move, or a number is not
///                finite
[[nodiscard]] INKEDGE_API Camera cameraFromIntrinsics(const glm::dmat3& k, const glm::dmat4& pose, CameraAxes, Size);

/// The camera of OpenGL's matrices, for pictures of this size.
/// @param view        world -> view space: a rotation and a translation
/// @param projection  as Camera::projection(), perspective or orthographic. Of an infinite far plane: near and far
///                    planes are fitted to the scene that is drawn
/// @throws Error      as cameraFromIntrinsics(); if the projection is made for another aspect: its pixels are a tenth
///                    wider than high or more, or the other way round, or, orthographic, no squares
[[nodiscard]] INKEDGE_API Camera cameraFromMatrices(const glm::dmat4& view, const glm::dmat4& projection, Size);

/// Makes a camera of settings. What the settings leave open is chosen so that the whole model fills the picture. The
/// near and far planes are fitted to the scene's bounding sphere, so that depths scaled between them mean the same for
/// a model of any size. frameViews() does the same for several views, and finds a picture's size, too.
/// @throws Error  (Kind::Usage) if the settings contradict themselves: position = focal point, up along a direction
///                that is given, an angle out of range, a camera index that the file does not have, two ways to say one
///                thing; the message names settings by the command's flags
[[nodiscard]] INKEDGE_API Camera frameCamera(const Scene&, const CameraSettings&, Size);

}  // namespace inkedge
