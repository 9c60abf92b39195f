#include <algorithm>
#include <cstddef>

#include <fmt/format.h>

#include <inkedge/renderer.h>

#include "lines/see/rays.h"
#include "modules/open_module.h"
#include "render/lines.h"
#include "render/plan.h"
#include "settings/names.h"

namespace inkedge {
namespace {

void warnOfForm(const RenderSettings& settings, std::vector<std::string>& warnings) {
    if ((settings.picture.lines & formLineTypes).empty() || settings.lines.from == LinesFrom::Object) return;
    if (!render::styleRow(settings.style.style).drawsLines) return;
    const Detector detector = settings.detector.detector;
    const std::string failure = modules::failureToOpen(lines::embreeModule);
    if (!failure.empty()) {
        warnings.push_back("lines of form are not drawn: " + failure);
    } else if (detector != Detector::Planes) {
        warnings.push_back(
            fmt::format("pictures of --detector {} have no lines of form: use --detector planes, or "
                        "--lines-from object",
                        settings::detectorNames[static_cast<std::size_t>(detector)]));
    }
}

void warnOfIsolines(const Scene& scene, const RenderSettings& settings, std::vector<std::string>& warnings) {
    const auto hasNone = [](const Mesh& mesh) { return mesh.textureCoordinates.empty(); };
    const bool wanted =
        settings.picture.lines.contains(LineType::Isoparametric) && settings.lines.isolines != Isolines{};
    if (wanted && std::ranges::all_of(scene.meshes(), hasNone))
        warnings.emplace_back("has no texture coordinates: no isolines are drawn");
}

void warnOfMarkedLines(const Scene& scene, const RenderSettings& settings, std::vector<std::string>& warnings) {
    const bool wanted = settings.picture.lines.contains(LineType::Marked) && settings.lines.from != LinesFrom::Object;
    if (!wanted || !render::hasMarked(scene)) return;
    const Detector detector = settings.detector.detector;
    if (detector == Detector::Planes) {
        const std::string failure = modules::failureToOpen(lines::embreeModule);
        if (!failure.empty()) warnings.push_back("marked lines are not drawn: " + failure);
        return;
    }
    const auto hasLines = [](const Mesh& mesh) { return !mesh.lines.empty(); };
    if (detector == Detector::None || !render::styleRow(settings.style.style).drawsLines ||
        std::ranges::none_of(scene.meshes(), hasLines))
        return;
    warnings.push_back(
        fmt::format("pictures of --detector {} have none of its lines besides triangles: use --detector planes, or "
                    "--lines-from object",
                    settings::detectorNames[static_cast<std::size_t>(detector)]));
}

void warnOfTangentLines(const Scene& scene, const RenderSettings& settings, std::vector<std::string>& warnings) {
    const bool wanted = settings.picture.lines.contains(LineType::Tangent) && settings.lines.from != LinesFrom::Object;
    if (!wanted || !render::styleRow(settings.style.style).drawsLines || !render::hasTangent(scene)) return;
    const Detector detector = settings.detector.detector;
    const std::string failure = modules::failureToOpen(lines::embreeModule);
    if (!failure.empty())
        warnings.push_back("tangent lines are not drawn: " + failure);
    else if (detector != Detector::Planes && detector != Detector::None)
        warnings.push_back(
            fmt::format("pictures of --detector {} have no tangent lines: use --detector planes, or "
                        "--lines-from object",
                        settings::detectorNames[static_cast<std::size_t>(detector)]));
}

}  // namespace

std::vector<std::string> renderWarnings(const Scene& scene, const RenderSettings& settings) {
    std::vector<std::string> warnings;
    warnOfIsolines(scene, settings, warnings);
    warnOfMarkedLines(scene, settings, warnings);
    warnOfForm(settings, warnings);
    warnOfTangentLines(scene, settings, warnings);
    return warnings;
}

}  // namespace inkedge
