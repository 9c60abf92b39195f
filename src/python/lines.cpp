#include "python/lines.h"

#include <cstddef>
#include <filesystem>
#include <utility>

#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <inkedge/write.h>

#include "python/arrays.h"
#include "python/cameras.h"
#include "python/documentation.h"
#include "python/maps.h"
#include "python/released.h"

namespace inkedge::python {
namespace {

// What a function of a point and a memory for some numbers writes: for each line points x numbers, or points of one
// number each. All lie in one array, which keeps them contiguous: OpenCV takes no others.
template <class Write>
py::list pointArrays(const Lines& lines, py::ssize_t numbers, Write write) {
    py::ssize_t count = 0;
    for (const Line& line : lines.lines) count += static_cast<py::ssize_t>(line.points.size());
    py::array_t<double> all{count * numbers};
    double* next = all.mutable_data();
    readOnly(all);
    py::list arrays;
    for (const Line& line : lines.lines) {
        std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(line.points.size())};
        if (numbers > 1) shape.push_back(numbers);
        arrays.append(readOnly(py::array_t<double>{std::move(shape), next, all}));
        for (const LinePoint& point : line.points) {
            write(point, next);
            next += numbers;
        }
    }
    return arrays;
}

// One value of each line.
template <class Number, class Member>
py::array column(const Lines& lines, Member member) {
    py::array_t<Number> array{static_cast<py::ssize_t>(lines.lines.size())};
    Number* value = array.mutable_data();
    for (const Line& line : lines.lines) *value++ = static_cast<Number>(member(line));
    return readOnly(array);
}

py::dict arraysOf(const Lines& lines) {
    const auto copy = [](const auto& vector, double* to) {
        for (int i = 0; i < vector.length(); ++i) to[i] = vector[i];
    };
    py::dict arrays;
    arrays["pixels"] = pointArrays(lines, 2, [&](const LinePoint& p, double* to) { copy(p.pixel, to); });
    arrays["positions"] = pointArrays(lines, 3, [&](const LinePoint& p, double* to) { copy(p.position, to); });
    arrays["strengths"] = pointArrays(lines, 1, [](const LinePoint& p, double* to) { *to = p.strength; });
    arrays["types"] = column<std::uint16_t>(lines, [](const Line& l) { return LineTypes{l.type}.bits(); });
    arrays["ids"] = column<std::uint32_t>(lines, [](const Line& l) { return l.id; });
    arrays["visible"] = column<bool>(lines, [](const Line& l) { return l.visible; });
    arrays["closed"] = column<bool>(lines, [](const Line& l) { return l.closed; });
    arrays["objects"] = column<std::uint32_t>(lines, [](const Line& l) { return l.object; });
    arrays["patches"] = column<std::uint32_t>(lines, [](const Line& l) { return l.patch; });
    arrays["widths"] = column<double>(lines, [](const Line& l) { return l.width; });
    return arrays;
}

std::string svg(const DrawnLines& drawn) {
    return released([&] { return linesSvg(drawn.lines, drawn.settings); });
}

void write(const DrawnLines& drawn, const std::filesystem::path& path) {
    released([&] { writeLines(drawn.lines, drawn.settings, path); });
}

}  // namespace

DrawnLines drawnLines(Lines&& lines, const Settings& settings) {
    py::dict arrays = arraysOf(lines);
    return {std::move(lines), settings, std::move(arrays)};
}

void addLines(py::module_& module) {
    py::class_<DrawnLines> type{module, "Lines", documentation::lines};
    for (const char* const name :
         {"pixels", "positions", "strengths", "types", "ids", "visible", "closed", "objects", "patches", "widths"})
        type.def_property_readonly(name, [name](const DrawnLines& d) { return py::object{d.arrays[name]}; });
    type.def_property_readonly("camera",
                               [](const DrawnLines& d) {
                                   return CameraMatrices{d.lines.camera, d.lines.size};
                               })
        .def_property_readonly("instances", [](const DrawnLines& d) { return d.lines.names.instances; })
        .def_property_readonly("times", [](const DrawnLines& d) { return dictOf(d.lines.times); })
        .def_property_readonly("warnings", [](const DrawnLines& d) { return listOf(d.lines.warnings); })
        .def("svg", svg, "The lines as an SVG document, with the settings that they were found with.")
        .def("write", write, py::arg("path"),
             "Writes them as .svg, .pdf, .dxf or .json, with the settings that they were found with.")
        .def("__len__", [](const DrawnLines& d) { return d.lines.lines.size(); })
        .def("__repr__", [](const DrawnLines& d) { return fmt::format("<inkedge.Lines: {}>", d.lines.lines.size()); });
}

}  // namespace inkedge::python
