#pragma once

#include <string_view>

#include <inkedge/setting_table.h>

/// Why settings cannot act on outputs: SettingDescription::idle. What each names in its comment is what the setting is
/// for; an empty text says that it acts.
namespace inkedge::settings {

/// Whether a setting asks for what only lines of the mesh have: hidden lines, widths that vary, isoparametric lines and
/// so on.
[[nodiscard]] bool needsMeshLines(const RenderSettings&) noexcept;

/// Whether anything of outputs is made of the normals of vertices (Mesh::normals).
[[nodiscard]] bool readsVertexNormals(const Settings&, const OutputKinds&) noexcept;

/// Whether the lines of a picture are those of the mesh: they are asked for, or LinesFrom::Auto finds that a setting
/// needs them and another detector is not asked for.
[[nodiscard]] bool drawsMeshLines(const RenderSettings&) noexcept;

// Lines
[[nodiscard]] std::string_view idleWithoutMeshLines(const Settings&, const OutputKinds&);
[[nodiscard]] std::string_view idleLinesFrom(const Settings&, const OutputKinds&);
[[nodiscard]] std::string_view idleStroke(const Settings&, const OutputKinds&);  ///< mesh lines in pictures; SVG, PDF
[[nodiscard]] std::string_view idleStrokeWidth(const Settings&, const OutputKinds&);
[[nodiscard]] std::string_view idleIsolines(const Settings&, const OutputKinds&);
[[nodiscard]] std::string_view idleFormTypes(const Settings&, const OutputKinds&, LineTypes);
template <LineType... types>
[[nodiscard]] std::string_view idleForm(const Settings& settings, const OutputKinds& kinds) {
    return idleFormTypes(settings, kinds, LineTypes{types...});
}
[[nodiscard]] std::string_view idleSimplify(const Settings&, const OutputKinds&);     ///< polylines in files
[[nodiscard]] std::string_view idleCentreLines(const Settings&, const OutputKinds&);  ///< vectors of centre lines

// Picture
[[nodiscard]] std::string_view idleLineColor(const Settings&, const OutputKinds&);
[[nodiscard]] std::string_view idleBackground(const Settings&, const OutputKinds&);
[[nodiscard]] std::string_view idleTypes(const Settings&, const OutputKinds&);  ///< lines with types
[[nodiscard]] std::string_view idlePen(const Settings&, const OutputKinds&);    ///< strokes
[[nodiscard]] std::string_view idleLineStyle(const Settings&, const OutputKinds&);
[[nodiscard]] std::string_view idleDpi(const Settings&, const OutputKinds&);
[[nodiscard]] std::string_view idlePage(const Settings&, const OutputKinds&);
[[nodiscard]] std::string_view idleSamples(const Settings&, const OutputKinds&);

// Detector and style
[[nodiscard]] std::string_view idleDetector(const Settings&, const OutputKinds&);
[[nodiscard]] std::string_view idleGradients(const Settings&, const OutputKinds&);    ///< edges of depth and normals
[[nodiscard]] std::string_view idleLightSpace(const Settings&, const OutputKinds&);   ///< edges of normals
[[nodiscard]] std::string_view idleNormalSpace(const Settings&, const OutputKinds&);  ///< maps of normals
[[nodiscard]] std::string_view idleLights(const Settings&, const OutputKinds&);       ///< what surfaces are drawn for
[[nodiscard]] std::string_view idleShade(const Settings&, const OutputKinds&);
[[nodiscard]] std::string_view idleLight(const Settings&, const OutputKinds&);  ///< what a shade's light falls on
[[nodiscard]] std::string_view idleProfiles(const Settings&, const OutputKinds&);
template <Style style>
[[nodiscard]] std::string_view idleStyle(const Settings& settings, const OutputKinds&) {
    return settings.style.style == style ? std::string_view{} : std::string_view{"it is for another --style"};
}

// Camera and model
[[nodiscard]] std::string_view idleViewAngle(const Settings&, const OutputKinds&);
[[nodiscard]] std::string_view idleHeight(const Settings&, const OutputKinds&);
[[nodiscard]] std::string_view idleFraming(const Settings&, const OutputKinds&);
[[nodiscard]] std::string_view idleUnit(const Settings&, const OutputKinds&);
[[nodiscard]] std::string_view idleTime(const Settings&, const OutputKinds&);

}  // namespace inkedge::settings
