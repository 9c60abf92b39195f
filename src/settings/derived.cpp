#include <inkedge/settings.h>

#include "settings/names.h"
#include "settings/shades.h"

namespace inkedge {
namespace {

// The magnitude of a step of 1: 4 with the Sobel kernels, d1 + d2 of equation 8 with Farid's.
constexpr float sobelStep = 4.0F;
constexpr float faridStep = 0.388734F;
constexpr Thresholds sobelThresholds{0.1F, 1.6F};

}  // namespace

LoadSettings loadSettings(const Settings& settings) {
    LoadSettings load = settings.load;
    const bool drawsIsolines = settings.picture.lines.contains(LineType::Isoparametric);
    load.textureCoordinates = load.textureCoordinates || (drawsIsolines && settings.lines.isolines != Isolines{});
    for (const FunctionSettings& function : settings.detector.functions) {
        const FunctionNeeds& needs = functionDescription(function.name).needs;
        load.textureCoordinates = load.textureCoordinates || needs.coordinates;
        load.paint = load.paint || needs.paint;
        load.curvature = load.curvature || needs.curvature;
    }
    load.paint = load.paint || settings::drawnShade(settings) != Shade::None;
    load.pictures = {{settings.camera}, settings.picture, settings.frame};
    return load;
}

Thresholds thresholds(const DetectorSettings& detector) noexcept {
    const float scale = detector.kernel == Kernel::Sobel ? 1.0F : faridStep / sobelStep;
    return {detector.depthThreshold.value_or(sobelThresholds.depth * scale),
            detector.normalThreshold.value_or(sobelThresholds.normal * scale)};
}

std::string_view name(LineType type) noexcept {
    const auto index = static_cast<std::size_t>(bitIndex(type));
    return index < settings::lineTypeNames.size() && LineTypes{type}.size() == 1 ? settings::lineTypeNames[index]
                                                                                 : std::string_view{};
}

std::string_view name(Map map) noexcept { return settings::mapNames[static_cast<std::size_t>(map)]; }

}  // namespace inkedge
