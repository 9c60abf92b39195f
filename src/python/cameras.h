#pragma once

#include <functional>

#include <pybind11/pybind11.h>

#include <inkedge/camera.h>
#include <inkedge/scene.h>
#include <inkedge/settings.h>
#include <inkedge/views.h>

#include "python/errors.h"

namespace inkedge::python {

/// What a picture is to be taken from: a camera once scene and size are known.
struct CameraChoice {
    /// Lays the view on the picture that the settings ask for. Holds nothing of Python's.
    std::function<FramedView(const Scene&, const Settings&)> lay;
};

/// A camera of pictures of one size.
struct CameraMatrices {
    Camera camera;
    Size size;
};

void addCameras(py::module_&);

}  // namespace inkedge::python
