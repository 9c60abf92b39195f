#include <inkedge/surface_functions.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <inkedge/error.h>
#include <inkedge/settings.h>

#include "base/nearest_name.h"

namespace inkedge {
namespace {

constexpr double largest = 1e12;

constexpr std::array<std::string_view, 3> axes{"x", "y", "z"};
constexpr std::array<std::string_view, 4> axesAndUp{"x", "y", "z", "up"};
constexpr std::array<std::string_view, 2> spaces{"camera", "world"};
constexpr std::array<std::string_view, 2> depthMaps{"linear", "window"};
constexpr std::array<std::string_view, 3> solids{"gradient", "rings", "stripes"};
constexpr std::array<std::string_view, 3> directions{"both", "u", "v"};

constexpr std::array depthOptions{
    FunctionOption{"map", "linear from near to far, or window-space", 0, 0, 1, depthMaps}};
constexpr std::array normalOptions{FunctionOption{"space", "whose axes it is counted along", 0, 0, 1, spaces}};
constexpr std::array textureOptions{
    FunctionOption{"repeat", "times along each texture coordinate's unit", 1, 0.001, 1000}};
constexpr std::array environmentOptions{FunctionOption{"space", "what the map stands still in", 0, 0, 1, spaces}};
constexpr std::array volumeOptions{
    FunctionOption{"kind", "what the solid is made of", 1, 0, 2, solids},
    FunctionOption{"axis", "of rings, and across stripes; the object's", 1, 0, 2, axes},
    FunctionOption{"frequency", "rings or stripes over the scene's radius", 16, 0.001, 1000},
    FunctionOption{"wobble", "how far rings and stripes stray, in their distance", 0.4, 0, 10}};
constexpr std::array curvatureOptions{
    FunctionOption{"scale", "factor of the curvature, one over the scene's radius is 1", 0.1, 0.0001, 1000},
    FunctionOption{"steps", "between flat and the sharpest", 2, 1, 100}};
constexpr std::array uvOptions{
    FunctionOption{"step", "between lines, in the texture coordinates' unit", 0.125, 0.0001, 1},
    FunctionOption{"direction", "which coordinate", 0, 0, 2, directions}};
constexpr std::array heightOptions{
    FunctionOption{"axis", "of the world, or the model's up", 3, 0, 3, axesAndUp},
    FunctionOption{"step", "between curves, scene units from the lowest point up; 0: as levels says", 0, 0, largest},
    FunctionOption{"levels", "how many steps the scene's extent makes", 16, 1, 1000}};
constexpr std::array customOptions{
    FunctionOption{"a", "option[0]", 0, -largest, largest}, FunctionOption{"b", "option[1]", 0, -largest, largest},
    FunctionOption{"c", "option[2]", 0, -largest, largest}, FunctionOption{"d", "option[3]", 0, -largest, largest}};

// The threshold of functions that count steps: half the magnitude of a step of 1.
constexpr float steps = 2.0F;

constexpr FunctionNeeds shape{};
constexpr FunctionNeeds coordinates{.coordinates = true};
constexpr FunctionNeeds paint{.paint = true};
constexpr FunctionNeeds curvature{.curvature = true};
constexpr FunctionNeeds all{.coordinates = true, .paint = true, .curvature = true};

constexpr std::array table{
    FunctionDescription{"depth", "depth, section 2.1.1", depthOptions, "", 0.1F, 1.0F, Wrapping::None, shape},
    FunctionDescription{"normal", "the shading normal, section 2.1.2", normalOptions, "", 1.6F, 0.0F, Wrapping::None,
                        shape},
    FunctionDescription{"texture",
                        "a smooth picture laid on by texture coordinates: a ramp, or a file's, mirrored",
                        textureOptions,
                        "PICTURE",
                        0.2F,
                        {},
                        Wrapping::Unit,
                        coordinates},
    FunctionDescription{"base-color",
                        "the colour that the model is painted with: its textures and vertex colours",
                        {},
                        "",
                        0.5F,
                        {},
                        Wrapping::None,
                        paint},
    FunctionDescription{"environment",
                        "what a smooth surrounding, or a panorama's file, looks like in a mirror",
                        environmentOptions,
                        "PICTURE",
                        1.0F,
                        {},
                        Wrapping::None,
                        shape},
    FunctionDescription{"volume",
                        "a solid texture that the object is carved from",
                        volumeOptions,
                        "",
                        steps,
                        {},
                        Wrapping::None,
                        shape},
    FunctionDescription{
        "curvature", "lines of equal mean curvature", curvatureOptions, "", steps, {}, Wrapping::None, curvature},
    FunctionDescription{"uv",
                        "isoparametric lines: equal steps of the texture coordinates",
                        uvOptions,
                        "",
                        steps,
                        {},
                        Wrapping::Steps,
                        coordinates},
    FunctionDescription{
        "height", "level curves: equal steps along an axis", heightOptions, "", steps, {}, Wrapping::None, shape},
    FunctionDescription{customFunction,
                        "your own vec4 surface(Surface s), in GLSL",
                        customOptions,
                        "GLSL",
                        1.6F,
                        {},
                        Wrapping::None,
                        all},
};

std::string listOf(const FunctionOption& option) {
    if (!option.choices.empty()) return fmt::format("{}={}", option.name, fmt::join(option.choices, "|"));
    return fmt::format("{}={}..{}", option.name, option.low, option.high);
}

// The keys that a function takes, for messages.
std::string allowed(const FunctionDescription& row) {
    std::vector<std::string> keys;
    for (const FunctionOption& option : row.options) keys.push_back(listOf(option));
    if (!row.file.empty()) keys.push_back(fmt::format("file={}", row.file));
    keys.emplace_back("kernel=sobel|farid");
    keys.emplace_back("threshold=0..");
    return fmt::format("{}", fmt::join(keys, ", "));
}

[[noreturn]] void refuse(const FunctionDescription& row, std::string_view part) {
    throw Error{Error::Kind::Usage, fmt::format("{}: expected {}, found '{}'", row.name, allowed(row), part)};
}

std::optional<double> numberOf(std::string_view text) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) return {};
    return value;
}

std::optional<double> valueOf(const FunctionOption& option, std::string_view text) {
    if (!option.choices.empty()) {
        const auto found = std::ranges::find(option.choices, text);
        if (found == option.choices.end()) return {};
        return static_cast<double>(found - option.choices.begin());
    }
    const std::optional<double> value = numberOf(text);
    return value && *value >= option.low && *value <= option.high ? value : std::nullopt;
}

std::string textOf(const FunctionOption& option, double value) {
    const bool isChoice = value >= 0.0 && value < static_cast<double>(option.choices.size());
    return isChoice ? std::string{option.choices[static_cast<std::size_t>(value)]} : fmt::format("{}", value);
}

// Sets one key=value of a function.
void take(const FunctionDescription& row, std::string_view part, FunctionSettings& function) {
    const std::size_t equals = part.find('=');
    const std::string_view key = part.substr(0, equals);
    const std::string_view value = equals == std::string_view::npos ? std::string_view{} : part.substr(equals + 1);
    if (value.empty()) refuse(row, part);
    if (key == "kernel" && (value == "sobel" || value == "farid")) {
        function.kernel = value == "sobel" ? Kernel::Sobel : Kernel::Farid;
        return;
    }
    if (key == "threshold") {
        const std::optional<double> number = numberOf(value);
        if (!number || *number < 0.0 || *number > largest) refuse(row, part);
        function.threshold = static_cast<float>(*number);
        return;
    }
    if (key == "file" && !row.file.empty()) {
        function.file = value;
        return;
    }
    const auto option = std::ranges::find(row.options, key, &FunctionOption::name);
    if (option == row.options.end()) refuse(row, part);
    const std::optional<double> number = valueOf(*option, value);
    if (!number) refuse(row, part);
    function.options[static_cast<std::size_t>(option - row.options.begin())] = *number;
}

// The ratio of the magnitudes of a step of 1: d1 + d2 of equation 8 with Farid's kernels, 4 with the Sobel kernels.
constexpr float faridToSobel = 0.388734F / 4.0F;

}  // namespace

std::span<const FunctionDescription> functionTable() noexcept { return table; }

const FunctionDescription& functionDescription(std::string_view name) {
    const auto* const row = std::ranges::find(table, name, &FunctionDescription::name);
    if (row != table.end()) return *row;
    std::vector<std::string_view> names;
    for (const FunctionDescription& each : table) names.push_back(each.name);
    throw Error{Error::Kind::Usage, fmt::format("expected one of {}, found '{}'{}", fmt::join(names, ", "), name,
                                                base::suggestion(name, names))};
}

FunctionSettings surfaceFunction(std::string_view text) {
    const std::size_t colon = text.find(':');
    const FunctionDescription& row = functionDescription(text.substr(0, colon));
    FunctionSettings function;
    function.name = row.name;
    for (const FunctionOption& option : row.options) function.options.push_back(option.defaultValue);
    for (bool first = true; text.find(first ? ':' : ',') != std::string_view::npos; first = false) {
        text.remove_prefix(text.find(first ? ':' : ',') + 1);
        const std::string_view part = text.substr(0, text.find(','));
        if (first && !row.file.empty() && !part.empty() && part.find('=') == std::string_view::npos)
            function.file = part;
        else
            take(row, part, function);
    }
    if (row.name == customFunction && function.file.empty()) refuse(row, "no file");
    return function;
}

std::string text(const FunctionSettings& function) {
    const FunctionDescription& row = functionDescription(function.name);
    if (function.options.size() != row.options.size())
        throw Error{Error::Kind::Usage, fmt::format("{}: expected {} options, found {}", row.name, row.options.size(),
                                                    function.options.size())};
    std::vector<std::string> parts;
    if (!function.file.empty()) parts.push_back("file=" + function.file);
    for (std::size_t i = 0; i < row.options.size(); ++i) {
        if (function.options[i] == row.options[i].defaultValue) continue;
        parts.push_back(fmt::format("{}={}", row.options[i].name, textOf(row.options[i], function.options[i])));
    }
    if (function.kernel == Kernel::Farid) parts.emplace_back("kernel=farid");
    if (function.threshold) parts.push_back(fmt::format("threshold={}", *function.threshold));
    return parts.empty() ? function.name : fmt::format("{}:{}", function.name, fmt::join(parts, ","));
}

float threshold(const FunctionSettings& function) {
    if (function.threshold) return *function.threshold;
    const float sobel = functionDescription(function.name).threshold;
    return function.kernel == Kernel::Sobel ? sobel : sobel * faridToSobel;
}

double wrapPeriod(const FunctionSettings& function) {
    switch (functionDescription(function.name).wrapping) {
        case Wrapping::None:
            return 0.0;
        case Wrapping::Unit:
            return function.file.empty() ? 1.0 : 0.0;
        case Wrapping::Steps:
            return 1.0 / function.options.at(0);
    }
    return 0.0;
}

}  // namespace inkedge
