#pragma once

#include <span>
#include <string>
#include <vector>

#include <inkedge/camera.h>
#include <inkedge/export.h>
#include <inkedge/scene.h>
#include <inkedge/settings.h>

namespace inkedge {

/// One of several views of a model.
struct View {
    std::string name;  ///< stands for {view} in file names: "000", "001", ... or what the file says
    CameraSettings camera;
};

/// The views that a text asks for, several of the first four with commas between them, or one file:
/// - a NamedView's name, "front", which is its View's, too;
/// - "turntable:N": N views from azimuth base.azimuthAngle (0 if not given) on, 360 / N degrees apart, each at
///   base.elevationAngle;
/// - "sphere:N": N directions spread evenly over the sphere (a Fibonacci lattice: the i-th at height 1 - (2 i + 1) / N,
///   i golden angles around);
/// - "random:N:SEED": N directions, each as likely as any other, the same for the same seed; a whole number, or 0 where
///   it is left out;
/// - a JSON file: a list of objects, each with camera settings by their names ("camera-azimuth-angle": 30,
///   "camera-position": [1, 2, 3] or "1,2,3") and optionally "name" (letters, digits, -, _ and .).
/// Turntables, spheres and random views of one list are numbered on. Beside a named view they are orthographic as it
/// is, unless base.viewAngle is given. What a view does not set is as in base.
/// @param base    must have neither position nor direction nor index nor view but for a file; for named views no angles
/// @throws Error  (Kind::Usage) if the text or the file is not as described, or two views have one name; (Kind::Input)
///                if the file cannot be read
[[nodiscard]] INKEDGE_API std::vector<View> viewsOf(const std::string& text, const CameraSettings& base);

/// loadSettings(), for pictures from all of these views. None: as of settings.camera.
[[nodiscard]] INKEDGE_API LoadSettings loadSettings(const Settings&, std::span<const View>);

/// A view, laid on a picture.
struct FramedView {
    Camera camera;
    PictureSettings picture;  ///< Settings::picture, its size in pixels; its dpi, too, if something is in millimetres
};

/// Whether views are framed together: Framing::Together, or Auto where one of several has a NamedView.
[[nodiscard]] INKEDGE_API bool framedTogether(std::span<const View>) noexcept;

/// Lays each view on its picture: finds its camera, as frameCamera() does, and its size in pixels, as settings.frame
/// asks for. Views that are framed together have one size, one scale, and the middle of the model (of its extent along
/// its width, depth and height) in one place; but those that have a position, a focal point, a height or a camera of
/// the file keep these.
/// @param settings  its camera is not looked at: each view has its own
/// @throws Error    (Kind::Usage) as frameCamera(); if a side has over PictureSettings::maxSide pixels, no room is left
///                  between margins, what is drawn at a scale does not fit into the size that is given, or the picture
///                  at a scale or in millimetres not on settings.picture.page; if a scale is asked of a view in
///                  perspective, or two ways to say one thing; the message names settings by the command's flags
[[nodiscard]] INKEDGE_API std::vector<FramedView> frameViews(const Scene&, std::span<const View>, const Settings&);

}  // namespace inkedge
