#include "python/keywords.h"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include <fmt/format.h>

namespace inkedge::python {
namespace {

constexpr std::array calls{opening, framing, drawing, loading};  // the first that takes a setting is the one for it
constexpr std::string_view preset = "preset";

std::string nameOf(std::string keyword) {
    std::ranges::replace(keyword, '_', '-');
    return keyword;
}

std::string numberOf(py::handle value) {
    if (PyIndex_Check(value.ptr()) != 0) return py::str(py::int_(py::reinterpret_borrow<py::object>(value)));
    return fmt::format("{}", py::float_(py::reinterpret_borrow<py::object>(value)).cast<double>());
}

bool isNumber(py::handle value) {
    return PyBool_Check(value.ptr()) == 0 && PySequence_Check(value.ptr()) == 0 && py::hasattr(value, "__float__");
}

// None: the value is several.
std::optional<std::string> singleText(py::handle value) {
    if (py::isinstance<py::str>(value)) return value.cast<std::string>();
    if (isNumber(value)) return numberOf(value);
    if (py::hasattr(value, "__fspath__")) return py::str(value.attr("__fspath__")()).cast<std::string>();
    return std::nullopt;
}

[[noreturn]] void refuseValue(const std::string& keyword, py::handle value) {
    if (value.is_none())
        refuse(fmt::format("{}: expected a value, found None; leave it out where its default will do", keyword));
    refuse(fmt::format("{}: expected a text, a number or several of them, found {}", keyword,
                       py::str(py::type::of(value).attr("__name__")).cast<std::string>()));
}

std::vector<std::string> severalTexts(const std::string& keyword, py::handle value) {
    if (!py::isinstance<py::sequence>(value) && !py::hasattr(value, "__array_interface__")) refuseValue(keyword, value);
    std::vector<std::string> texts;
    for (const py::handle each : value) {
        const std::optional<std::string> text = singleText(each);
        if (!text) refuseValue(keyword, each);
        texts.push_back(*text);
    }
    return texts;
}

void expectTaken(const SettingDescription& row, const std::string& keyword, const Call& call) {
    if (takes(call, row)) return;
    const auto right = std::ranges::find_if(calls, [&](const Call& each) { return takes(each, row); });
    refuse(fmt::format("{}: expected it for {}, found it for {}", keyword, right->name, call.name));
}

void applyOne(Settings& settings, const std::string& keyword, py::handle value, const Call& call) {
    const std::string name = nameOf(keyword);
    const SettingDescription* const row = findSetting(name);
    if (row == nullptr) return set(settings, name, {}, keyword);  // throws
    expectTaken(*row, keyword, call);
    if (const std::optional<std::string> text = singleText(value)) return set(settings, name, *text, keyword);
    std::vector<std::string> texts = severalTexts(keyword, value);
    const bool isMaps = row->name == "maps";
    if (isMaps) std::ranges::transform(texts, texts.begin(), nameOf);
    if (isMaps && texts.empty()) return settings.maps.clear();
    set(settings, name, row->joined(texts), keyword);
}

}  // namespace

bool takes(const Call& call, const SettingDescription& row) noexcept {
    return std::ranges::find(call.groups, row.group) != call.groups.end();
}

std::string keywordOf(std::string_view name) {
    std::string keyword{name};
    std::ranges::replace(keyword, '-', '_');
    return keyword;
}

void apply(Settings& settings, const py::kwargs& keywords, const Call& call) {
    if (keywords.contains(preset)) setPreset(settings, singleText(keywords[preset.data()]).value_or("None"), preset);
    for (const auto& [keyword, value] : keywords) {
        const auto name = keyword.cast<std::string>();
        if (name != preset) applyOne(settings, name, value, call);
    }
}

void warnOfIdle(const Settings& settings, const OutputKinds& kinds) {
    for (const std::string& line : idleSettings(settings, kinds)) warn(line);
}

}  // namespace inkedge::python
