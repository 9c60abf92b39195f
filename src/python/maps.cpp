#include "python/maps.h"

#include <string>
#include <utility>

#include <fmt/format.h>

#include "python/arrays.h"
#include "python/cameras.h"
#include "python/documentation.h"
#include "python/keywords.h"

namespace inkedge::python {
namespace {

// By id, as in an .npz: 0 stands for none.
py::list instanceNames(const DrawnMaps& maps) {
    std::vector<std::string> names(maps.rest.names.instances.empty() ? 1 : maps.rest.names.instances.back().id + 1);
    for (const NamedInstance& instance : maps.rest.names.instances) names[instance.id] = instance.node;
    return listOf(names);
}

py::list materialNamesOfMaps(const DrawnMaps& maps) {
    py::list names;
    names.append(py::str{});
    for (const std::string& name : maps.rest.names.materials) names.append(textOf(name));
    return names;
}

std::string representMaps(const DrawnMaps& maps) {
    std::string names;
    for (const auto& [name, array] : maps.arrays)
        names += fmt::format("{}{}", names.empty() ? "" : ", ", name.cast<std::string>());
    return fmt::format("<inkedge.Maps of {} x {}: {}>", maps.size.width, maps.size.height, names);
}

// What dict() and ** ask for.
auto forwardedTo(const char* method) {
    return [method](const DrawnMaps& maps) { return maps.arrays.attr(method)(); };
}

}  // namespace

DrawnMaps drawnMaps(Maps&& maps, const std::vector<Map>& names, bool writable) {
    DrawnMaps drawn{.arrays = {}, .rest = {}, .size = maps.picture.size()};
    const auto add = [&](const std::string& name, auto image) {
        py::array array = arrayOf(std::move(image));
        drawn.arrays[py::str{name}] = writable ? array : readOnly(array);
    };
    add("picture", std::move(maps.picture));
    for (const Map map : names)
        std::visit([&](auto image) { add(keywordOf(name(map)), std::move(image)); }, takeImage(maps, map));
    drawn.rest = std::move(maps);
    return drawn;
}

py::dict dictOf(const std::vector<StageTime>& times) {
    py::dict dict;
    for (const auto& [stage, milliseconds] : times) {
        const py::str key{stage};
        dict[key] = milliseconds + (dict.contains(key) ? dict[key].cast<double>() : 0.0);
    }
    return dict;
}

py::list listOf(const std::vector<std::string>& texts) {
    py::list list;
    for (const std::string& text : texts) list.append(textOf(text));
    return list;
}

void addMaps(py::module_& module) {
    py::class_<BackendInfo>(module, "Backend", documentation::backend)
        .def_readonly("backend", &BackendInfo::backend)
        .def_readonly("platform", &BackendInfo::platform)
        .def_readonly("vendor", &BackendInfo::vendor)
        .def_readonly("renderer", &BackendInfo::renderer)
        .def_readonly("version", &BackendInfo::version)
        .def_readonly("software", &BackendInfo::software);
    py::class_<DrawnMaps>(module, "Maps", documentation::maps)
        .def("__getitem__", [](const DrawnMaps& m, const py::object& key) { return py::object{m.arrays[key]}; })
        .def("__contains__", [](const DrawnMaps& m, const py::object& key) { return m.arrays.contains(key); })
        .def("__iter__", forwardedTo("__iter__"))
        .def("__len__", [](const DrawnMaps& m) { return m.arrays.size(); })
        .def("keys", forwardedTo("keys"))
        .def("values", forwardedTo("values"))
        .def("items", forwardedTo("items"))
        .def(
            "get",
            [](const DrawnMaps& m, const py::object& key, const py::object& other) {
                return m.arrays.attr("get")(key, other);
            },
            py::arg("key"), py::arg("default") = py::none())
        .def_property_readonly("camera",
                               [](const DrawnMaps& m) {
                                   return CameraMatrices{m.rest.camera, m.size};
                               })
        .def_property_readonly("instance_names", instanceNames)
        .def_property_readonly("material_names", materialNamesOfMaps)
        .def_property_readonly("backend", [](const DrawnMaps& m) { return m.rest.backend; })
        .def_property_readonly("times", [](const DrawnMaps& m) { return dictOf(m.rest.times); })
        .def_property_readonly("warnings", [](const DrawnMaps& m) { return listOf(m.rest.warnings); })
        .def("__repr__", representMaps);
}

}  // namespace inkedge::python
