#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <inkedge/export.h>
#include <inkedge/settings.h>

namespace inkedge {

/// One of several views of a model.
struct View {
    std::string name;  ///< stands for {view} in file names: "000", "001", ... or what the file says
    CameraSettings camera;
};

/// The views that a text asks for:
/// - "turntable:N": N views from azimuth base.azimuthAngle (0 if not given) on, 360 / N degrees apart, each at
///   base.elevationAngle;
/// - "sphere:N": N directions spread evenly over the sphere (a Fibonacci lattice: the i-th at height 1 - (2 i + 1) / N,
///   i golden angles around);
/// - a JSON file: a list of objects, each with camera settings by their names ("camera-azimuth-angle": 30,
///   "camera-position": [1, 2, 3] or "1,2,3") and optionally "name" (letters, digits, -, _ and .).
/// What a view does not set is as in base.
/// @param base    must have neither position nor direction nor index for a turntable or a sphere
/// @throws Error  (Kind::Usage) if the text or the file is not as described; (Kind::Input) if the file cannot be read
[[nodiscard]] INKEDGE_API std::vector<View> viewsOf(const std::string& text, const CameraSettings& base);

}  // namespace inkedge
