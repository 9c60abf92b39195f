#include "python/scenes.h"

#include <filesystem>

#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <inkedge/load_scene.h>
#include <inkedge/scene_names.h>

#include "python/arrays.h"
#include "python/documentation.h"
#include "python/keywords.h"
#include "python/maps.h"
#include "python/released.h"
#include "python/scene_arrays.h"

namespace inkedge::python {
namespace {

LoadSettings loadingSettings(const py::kwargs& keywords) {
    Settings settings;
    apply(settings, keywords, loading);
    return loadSettings(settings);
}

Scene load(const std::filesystem::path& path, const py::kwargs& keywords) {
    const LoadSettings settings = loadingSettings(keywords);
    return released([&] { return loadScene(path, settings); });
}

Scene fromArrays(const py::object& vertices, const py::object& faces, const py::object& normals, const py::object& uv,
                 const py::object& transforms, const py::object& names, const py::kwargs& keywords) {
    return sceneFromArrays(vertices, faces, normals, uv, transforms, names, loadingSettings(keywords));
}

py::list materialNames(const Scene& scene) {
    py::list names;
    for (const Material& material : scene.materials()) names.append(textOf(material.name));
    return names;
}

std::string representScene(const Scene& scene) {
    return fmt::format("<inkedge.Scene of {} triangles, {} instances>", scene.triangleCount(),
                       scene.instances().size());
}

}  // namespace

void addScenes(py::module_& module) {
    py::class_<NamedInstance>(module, "Instance", documentation::instance)
        .def_property_readonly("id", [](const NamedInstance& i) { return i.id; })
        .def_property_readonly("node", [](const NamedInstance& i) { return textOf(i.node); })
        .def_property_readonly("mesh", [](const NamedInstance& i) { return textOf(i.mesh); })
        .def_property_readonly("materials", [](const NamedInstance& i) { return i.materials; })
        .def_property_readonly("transform", [](const NamedInstance& i) { return matrixOf(i.transform); });
    py::class_<Scene>(module, "Scene", documentation::scene)
        .def_static("load", load, py::arg("path"), documentation::load().c_str())
        .def_static("from_arrays", fromArrays, py::arg("vertices"), py::arg("faces"), py::arg("normals") = py::none(),
                    py::arg("uv") = py::none(), py::arg("transforms") = py::none(), py::arg("names") = py::none(),
                    documentation::fromArrays().c_str())
        .def_property_readonly("triangles", &Scene::triangleCount)
        .def_property_readonly(
            "box", [](const Scene& s) { return py::make_tuple(vectorOf(s.box().min), vectorOf(s.box().max)); })
        .def_property_readonly("centre", [](const Scene& s) { return vectorOf(s.bounds().centre); })
        .def_property_readonly("radius", [](const Scene& s) { return s.bounds().radius; })
        .def_property_readonly("up", [](const Scene& s) { return vectorOf(s.up()); })
        .def_property_readonly("front", [](const Scene& s) { return vectorOf(s.front()); })
        .def_property_readonly("instances", [](const Scene& s) { return namesOf(s).instances; })
        .def_property_readonly("material_names", materialNames)
        .def_property_readonly("warnings", [](const Scene& s) { return listOf(s.warnings()); })
        .def("__repr__", representScene);
}

}  // namespace inkedge::python
