#include "python/cameras.h"

#include <optional>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>

#include "python/arrays.h"
#include "python/documentation.h"
#include "python/keywords.h"
#include "python/released.h"

namespace inkedge::python {
namespace {

template <class Matrix>
Matrix matrixFrom(const py::object& value, std::string_view name) {
    constexpr auto size = static_cast<py::ssize_t>(Matrix::length());
    const auto array = py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(value);
    if (!array) PyErr_Clear();
    if (!array || array.ndim() != 2 || array.shape(0) != size || array.shape(1) != size)
        refuse(fmt::format("{}: expected {} x {} numbers, found another array", name, size, size));
    Matrix matrix;
    for (int row = 0; row < Matrix::length(); ++row)
        for (int column = 0; column < Matrix::length(); ++column) matrix[column][row] = array.at(row, column);
    return matrix;
}

bool isSame(const Scene& a, const Scene& b) { return &a.meshes() == &b.meshes(); }  // copies share what they hold

FramedView framed(const Scene& scene, const CameraSettings& camera, const Settings& settings) {
    const View view{.name = {}, .camera = camera};
    return frameViews(scene, {&view, 1}, settings).front();
}

CameraSettings cameraSettings(const py::kwargs& keywords) {
    Settings settings;
    apply(settings, keywords, framing);
    warnOfIdle(settings, {.pictures = true});
    return settings.camera;
}

CameraChoice frame(const Scene& of, const py::kwargs& keywords) {
    return {[of, camera = cameraSettings(keywords)](const Scene& scene, const Settings& settings) {
        FramedView view = framed(of, camera, settings);
        if (!isSame(of, scene)) view.camera.near = view.camera.far = 0.0;
        return view;
    }};
}

CameraChoice lookAt(const py::object& eye, const py::object& target, const py::object& up, const py::kwargs& others) {
    const py::kwargs keywords{py::dict{others}};
    keywords["eye"] = eye;
    keywords["target"] = target;
    if (!up.is_none()) keywords["camera_view_up"] = up;
    return {[camera = cameraSettings(keywords)](const Scene& scene, const Settings& settings) {
        return framed(scene, camera, settings);
    }};
}

// A camera that says itself what it sees: nothing is left to be framed.
template <class MakeCamera>
CameraChoice calibrated(MakeCamera make) {
    return {[make](const Scene&, const Settings& settings) {
        const FrameSettings& frame = settings.frame;
        const bool inPixels = !frame.size || (!frame.size->millimetres && frame.size->height > 0.0);
        if (frame.crop || frame.scale || !inPixels)
            refuse(fmt::format("{}: expected a camera of Camera.frame() or Camera.look_at(), found one of matrices",
                               frame.crop    ? "crop"
                               : frame.scale ? "scale"
                                             : "size"));
        return FramedView{make(settings.picture.size), settings.picture};
    }};
}

CameraChoice fromMatrices(const py::object& view, const py::object& projection) {
    return calibrated([view = matrixFrom<glm::dmat4>(view, "view"),
                       projection = matrixFrom<glm::dmat4>(projection, "projection")](Size size) {
        return cameraFromMatrices(view, projection, size);
    });
}

CameraAxes axesOf(const std::string& convention) {
    if (convention == "opencv") return CameraAxes::OpenCv;
    if (convention == "opengl") return CameraAxes::OpenGl;
    refuse(fmt::format("convention: expected one of opencv, opengl, found '{}'", convention));
}

CameraChoice fromIntrinsics(const py::object& k, const py::object& pose, const std::string& convention) {
    return calibrated([k = matrixFrom<glm::dmat3>(k, "K"), pose = matrixFrom<glm::dmat4>(pose, "pose"),
                       axes = axesOf(convention)](Size size) { return cameraFromIntrinsics(k, pose, axes, size); });
}

CameraMatrices matricesFor(const CameraChoice& choice, const Scene& scene, const py::kwargs& keywords) {
    Settings settings;
    apply(settings, keywords, drawing);
    return released([&] {
        const FramedView view = choice.lay(scene, settings);
        return CameraMatrices{withPlanes(view.camera, scene), view.picture.size};
    });
}

py::dict dictOf(const CameraMatrices& matrices) {
    const auto [camera, size] = matrices;
    const auto list = [](const py::array& array) { return array.attr("tolist")(); };
    py::dict dict;
    dict["size"] = py::make_tuple(size.width, size.height);
    dict["view"] = list(matrixOf(camera.view));
    dict["projection"] = list(matrixOf(camera.projection(size)));
    dict["world_to_camera"] = list(matrixOf(camera.worldToCamera()));
    dict["K"] = list(matrixOf(camera.intrinsics(size)));
    dict["near"] = camera.near;
    dict["far"] = camera.far;
    dict["orthographic_height"] = camera.orthographicHeight;
    return dict;
}

}  // namespace

void addCameras(py::module_& module) {
    py::class_<CameraMatrices>(module, "CameraMatrices", documentation::cameraMatrices)
        .def_property_readonly("size",
                               [](const CameraMatrices& m) { return py::make_tuple(m.size.width, m.size.height); })
        .def_property_readonly("view", [](const CameraMatrices& m) { return matrixOf(m.camera.view); })
        .def_property_readonly("projection",
                               [](const CameraMatrices& m) { return matrixOf(m.camera.projection(m.size)); })
        .def_property_readonly("world_to_camera",
                               [](const CameraMatrices& m) { return matrixOf(m.camera.worldToCamera()); })
        .def_property_readonly("K", [](const CameraMatrices& m) { return matrixOf(m.camera.intrinsics(m.size)); })
        .def_property_readonly("near", [](const CameraMatrices& m) { return m.camera.near; })
        .def_property_readonly("far", [](const CameraMatrices& m) { return m.camera.far; })
        .def_property_readonly("orthographic_height",
                               [](const CameraMatrices& m) { return m.camera.orthographicHeight; })
        .def("to_dict", dictOf, "All of these as lists and numbers, for json.dump().");
    py::class_<CameraChoice>(module, "Camera", documentation::camera)
        .def_static("frame", frame, py::arg("scene"), documentation::frame().c_str())
        .def_static("look_at", lookAt, py::arg("eye"), py::arg("target"), py::arg("up") = py::none(),
                    documentation::lookAt().c_str())
        .def_static("from_matrices", fromMatrices, py::arg("view"), py::arg("projection"), documentation::fromMatrices)
        .def_static("from_intrinsics", fromIntrinsics, py::arg("K"), py::arg("pose"), py::arg("convention") = "opencv",
                    documentation::fromIntrinsics)
        .def("matrices", matricesFor, py::arg("scene"), documentation::matrices);
}

}  // namespace inkedge::python
