#pragma once

#include <pybind11/pybind11.h>

#include <inkedge/scene.h>

namespace inkedge::python {

/// A scene of numpy arrays, or of what becomes such: Scene.from_arrays().
[[nodiscard]] Scene sceneFromArrays(const pybind11::object& vertices, const pybind11::object& faces,
                                    const pybind11::object& normals, const pybind11::object& uv,
                                    const pybind11::object& transforms, const pybind11::object& names,
                                    const LoadSettings&);

}  // namespace inkedge::python
