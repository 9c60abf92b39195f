#include <array>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <inkedge/line_types.h>
#include <inkedge/setting_table.h>
#include <inkedge/version.h>

#include "python/cameras.h"
#include "python/comparisons.h"
#include "python/documentation.h"
#include "python/errors.h"
#include "python/keywords.h"
#include "python/lines.h"
#include "python/maps.h"
#include "python/renderers.h"
#include "python/scenes.h"

namespace inkedge::python {
namespace {

const char* kindOf(const SettingDescription& row) {
    static constexpr std::array names{"number", "count", "choice", "list", "text"};
    static_assert(names.size() == std::variant_size_v<Constraint>);
    return names[row.constraint.index()];
}

std::vector<std::string> choicesOf(const SettingDescription& row) {
    std::span<const std::string_view> names;
    if (const auto* choice = std::get_if<Choice>(&row.constraint)) names = choice->names;
    if (const auto* list = std::get_if<List>(&row.constraint)) names = list->names;
    return {names.begin(), names.end()};
}

// Every keyword, by its name.
py::dict addSettings(py::module_& module) {
    using Row = SettingDescription;
    py::class_<Row>(module, "Setting", documentation::setting)
        .def_property_readonly("name", [](const Row& row) { return keywordOf(row.name); })
        .def_property_readonly("short_name", [](const Row& row) { return keywordOf(row.shortName); })
        .def_property_readonly("flag", [](const Row& row) { return "--" + std::string{row.name}; })
        .def_property_readonly("group", [](const Row& row) { return row.group; })
        .def_property_readonly("kind", kindOf)
        .def_property_readonly("choices", [](const Row& row) { return py::tuple{py::cast(choicesOf(row))}; })
        .def_property_readonly("values", &Row::values)
        .def_property_readonly("range", &Row::range)
        .def_property_readonly("default", &Row::defaultValue)
        .def_property_readonly("help", [](const Row& row) { return row.help; })
        .def("__repr__", [](const Row& row) { return "<inkedge.Setting " + keywordOf(row.name) + ">"; });
    py::dict settings;
    for (const Row& row : settingTable())
        settings[py::str{keywordOf(row.name)}] = py::cast(&row, py::return_value_policy::reference);
    return settings;
}

// Names of types of lines and their bits.
py::dict lineTypes() {
    py::dict types;
    for (const LineType type : allLineTypes) types[py::str{std::string{name(type)}}] = LineTypes{type}.bits();
    return types;
}

}  // namespace
}  // namespace inkedge::python

PYBIND11_MODULE(_inkedge, module) {
    using namespace inkedge::python;
    py::options options;
    options.disable_function_signatures();
    module.doc() = documentation::module;
    module.attr("__version__") = inkedge::version();
    module.attr("line_types") = lineTypes();
    addErrors(module);
    module.attr("settings") = addSettings(module);
    addScenes(module);
    addCameras(module);
    addMaps(module);
    addLines(module);
    addComparisons(module);
    addRenderers(module);
}
