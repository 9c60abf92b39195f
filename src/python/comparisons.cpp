#include "python/comparisons.h"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <inkedge/compare.h>
#include <inkedge/compare_lines.h>
#include <inkedge/encode_png.h>
#include <inkedge/write_file.h>

#include "python/documentation.h"
#include "python/errors.h"
#include "python/lines.h"
#include "python/released.h"

namespace inkedge::python {
namespace {

using Source = std::variant<const DrawnLines*, std::filesystem::path>;

ComparedLines linesOf(const Source& source) {
    const auto* const lines = std::get_if<const DrawnLines*>(&source);
    if (lines == nullptr) return readComparedLines(std::get<std::filesystem::path>(source));
    if (*lines == nullptr) refuse("lines: expected Lines or a path, found None");
    return comparedLines((*lines)->lines, (*lines)->settings);
}

LinesComparison compareLinesOf(const Source& before, const Source& after, double distance, double share, double speck) {
    return released([&] {
        return compareLines(linesOf(before), linesOf(after), {.distance = distance, .share = share, .speck = speck});
    });
}

py::object changesOf(const LinesComparison& comparison) {
    return py::module_::import("json").attr("loads")(comparisonJson(comparison))["changes"];
}

Comparison comparePictures(const std::filesystem::path& a, const std::filesystem::path& b, double level, double share,
                           std::optional<double> hardLimit, const std::optional<std::filesystem::path>& difference) {
    const double limit = hardLimit.value_or(share > 0.0 ? std::numeric_limits<double>::max() : level);
    return released([&] { return compare(a, b, {.level = level, .share = share, .hardLimit = limit}, difference); });
}

std::string saidOf(const Comparison& c) {
    return fmt::format("{}: {} of {} pixels over the level ({:.4f} %), largest difference {:.4g} at {},{}",
                       c.same ? "same" : "different", c.pixelsOverLevel,
                       static_cast<std::uint64_t>(c.size.width) * static_cast<std::uint64_t>(c.size.height),
                       100.0 * c.shareOverLevel, c.maximum, c.maximumX, c.maximumY);
}

void writePng(const std::filesystem::path& path, const py::array_t<std::uint8_t, py::array::c_style>& pixels) {
    const py::ssize_t channels = pixels.ndim() == 3 ? pixels.shape(2) : 1;
    const bool shaped = (pixels.ndim() == 2 || pixels.ndim() == 3) && (channels == 1 || channels == 3 || channels == 4);
    if (!shaped || pixels.size() == 0 || std::max(pixels.shape(0), pixels.shape(1)) > PictureSettings::maxSide)
        refuse("pixels: expected uint8 of the shape (height, width) or (height, width, 3 or 4), found another");
    const Size size{static_cast<int>(pixels.shape(1)), static_cast<int>(pixels.shape(0))};
    const Image<std::uint8_t> picture{size, static_cast<int>(channels),
                                      std::vector<std::uint8_t>(pixels.data(), pixels.data() + pixels.size())};
    released([&] { writeFile(path, encodePng(picture)); });
}

}  // namespace

void addComparisons(py::module_& module) {
    py::class_<LinesComparison>{module, "LinesComparison", documentation::linesComparison}
        .def_readonly("same", &LinesComparison::same)
        .def_readonly("share", &LinesComparison::share)
        .def_property_readonly("changes", changesOf)
        .def(
            "write", writeComparison, py::arg("path"), py::call_guard<py::gil_scoped_release>(),
            "Draws the changes as .svg, .pdf or .png: vanished lines vermilion, those that appeared blue, changed ones "
            "purple.")
        .def("__str__", comparisonText);
    py::class_<Comparison>{module, "PictureComparison", documentation::pictureComparison}
        .def_readonly("same", &Comparison::same)
        .def_readonly("share", &Comparison::shareOverLevel)
        .def_readonly("maximum", &Comparison::maximum)
        .def("__str__", saidOf);
    module.def("compare_lines", compareLinesOf, py::arg("before"), py::arg("after"), py::kw_only(),
               py::arg("distance") = LineTolerance{}.distance, py::arg("share") = LineTolerance{}.share,
               py::arg("speck") = LineTolerance{}.speck, documentation::compareLines);
    module.def("compare_pictures", comparePictures, py::arg("a"), py::arg("b"), py::kw_only(), py::arg("level") = 0.0,
               py::arg("share") = 0.0, py::arg("hard_limit") = py::none(), py::arg("difference") = py::none(),
               documentation::comparePictures);
    module.def("write_png", writePng, py::arg("path"), py::arg("pixels"),
               "write_png(path, pixels)\n\nWrites a picture: uint8, (height, width) or (height, width, 3 or 4).");
}

}  // namespace inkedge::python
