#pragma once

#include <array>
#include <string>
#include <string_view>

#include <pybind11/pybind11.h>

#include <inkedge/setting_table.h>

#include "python/errors.h"

/// Settings as keywords: every row of the table of settings, by both its names, with _ for -.
namespace inkedge::python {

/// A call that takes settings, and which groups of the table.
struct Call {
    std::string_view name;  ///< for messages: "Renderer.render()"
    std::array<std::string_view, 8> groups;
};

/// The pictures that a model is loaded for decide what is loaded of it.
inline constexpr Call loading{"Scene.load()",
                              {"output", "picture", "lines", "style", "camera", "model", "limits", "detector"}};
inline constexpr Call framing{"Camera.frame()", {"camera"}};
inline constexpr Call drawing{"Renderer.render()", {"output", "picture", "lines", "style", "detector"}};
inline constexpr Call lining{"Renderer.lines()", {"picture", "lines", "style", "detector"}};
inline constexpr Call opening{"Renderer()", {"backend"}};

[[nodiscard]] bool takes(const Call&, const SettingDescription&) noexcept;

/// A name of the table as a keyword: "line_width".
[[nodiscard]] std::string keywordOf(std::string_view name);

/// The texts of a number, a text, a path or several of them become values of the settings; those of a preset first.
/// @throws Error  (Kind::Usage) as the command line says it, beginning with the keyword; if the call does not take the
///                setting
void apply(Settings&, const py::kwargs&, const Call&);

/// Settings that differ from their defaults and do nothing become warnings of the caller's line.
void warnOfIdle(const Settings&, const OutputKinds&);

}  // namespace inkedge::python
