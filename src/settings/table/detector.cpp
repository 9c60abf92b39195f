#include <fmt/format.h>

#include "settings/idle.h"
#include "settings/names.h"
#include "settings/rows.h"

namespace inkedge::settings {
namespace {

constexpr std::array<std::string_view, 2> kernelNames{"sobel", "farid"};
constexpr std::array<std::string_view, 2> depthMapNames{"linear", "window"};
constexpr std::array<std::string_view, 2> lightsNames{"single", "two-pass"};
constexpr std::array<std::string_view, 2> lightSpaceNames{"camera", "world"};

constexpr Number threshold{.min = 0.0, .max = 1e6, .unit = "T"};

std::string functionRange() {
    std::string names;
    for (const FunctionDescription& function : functionTable())
        names += fmt::format("{}{}{}", names.empty() ? "" : ", ", function.name,
                             function.name == customFunction ? ":FILE" : "");
    return names;
}

SettingDescription::Field functions() {
    return {[](const Constraint&, Settings& s, std::string_view text) { s.detector.functions = parseFunctions(text); },
            [](const Constraint&, const Settings& s) { return textOf(s.detector.functions); },
            [](const Settings& s) { checkFunctions(s.detector.functions); }};
}

}  // namespace

std::vector<SettingDescription> detectorRows() {
    return inGroup(
        "detector",
        {row(
             {.name = "detector",
              .help = "planes: where visible faces do not go on; classic: gradients of depth and normals; "
                      "saito-takahashi: profiles and edges of depth; raskar-cohen: enlarged back faces and fins; none: "
                      "functions alone",
              .idle = idleDetector},
             Choice{detectorNames}, [](auto& s) -> auto& { return s.detector.detector; }),
         row(
             {.name = "kernel",
              .help = "gradient kernels: Sobel 3x3 (eq. 5) or Farid-Simoncelli 5x5 (eq. 8); classic detector",
              .idle = idleGradients},
             Choice{kernelNames}, [](auto& s) -> auto& { return s.detector.kernel; }),
         row(
             {.name = "depth-map",
              .help = "depth that edges are found in: eye-space scaled to 0..1, or window-space; classic detector",
              .idle = idleGradients},
             Choice{depthMapNames}, [](auto& s) -> auto& { return s.detector.depthMap; }),
         row(
             {.name = "depth-threshold",
              .help = "depth edge where the magnitude (eq. 6) is at least T (eq. 7); classic detector",
              .defaultInWords = "0.1 (sobel), 0.00972 (farid)",
              .idle = idleGradients},
             threshold, [](auto& s) -> auto& { return s.detector.depthThreshold; }),
         row(
             {.name = "normal-threshold",
              .help = "normal edge where the magnitude of any channel is at least T; classic detector",
              .defaultInWords = "1.6 (sobel), 0.155 (farid)",
              .idle = idleGradients},
             threshold, [](auto& s) -> auto& { return s.detector.normalThreshold; }),
         row(
             {.name = "normal-lights",
              .help = "normal map from six lights in one float pass, or from two 8-bit passes",
              .idle = idleLights},
             Choice{lightsNames}, [](auto& s) -> auto& { return s.detector.normalLights; }),
         row(
             {.name = "light-space", .help = "the axes that the lights stand on", .idle = idleLightSpace},
             Choice{lightSpaceNames}, [](auto& s) -> auto& { return s.detector.lightSpace; }),
         row(
             {.name = "profile-limit",
              .help = "depth, in pixels, over which a profile is full ink; saito-takahashi detector",
              .idle = idleProfiles},
             Number{.min = 0.001, .max = 1000.0, .unit = "PX"},
             [](auto& s) -> auto& { return s.detector.profileLimit; }),
         row(
             {.name = "edge-limit",
              .help = "change of slope over which an internal edge is full ink; saito-takahashi detector",
              .idle = idleProfiles},
             Number{.min = 0.001, .max = 1000.0, .unit = "X"}, [](auto& s) -> auto& { return s.detector.edgeLimit; }),
         described({.name = "function",
                    .help = "surface function whose edges are drawn over the detector's lines",
                    .rangeNote = "several: ; between them, or the flag again",
                    .joinedBy = ';'},
                   Custom{"NAME[:key=value,...]", functionRange}, functions())});
}

}  // namespace inkedge::settings
