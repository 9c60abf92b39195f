#include "settings/rows.h"

namespace inkedge::settings {
namespace {

constexpr std::array<std::string_view, 3> backendNames{"auto", "egl", "osmesa"};

}  // namespace

std::vector<SettingDescription> backendRows() {
    return inGroup(
        "backend",
        {row(
             {.name = "backend", .help = "how the OpenGL context is made; auto: egl, then osmesa"},
             Choice{backendNames}, [](auto& s) -> auto& { return s.backend.backend; }),
         row(
             {.name = "device", .help = "EGL device", .defaultInWords = "hardware before software"},
             Count{.last = "the last that inkedge doctor lists"}, [](auto& s) -> auto& { return s.backend.device; })});
}

}  // namespace inkedge::settings
