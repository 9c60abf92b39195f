#include "settings/idle.h"
#include "settings/names.h"
#include "settings/rows.h"

namespace inkedge::settings {
namespace {

constexpr std::array<std::string_view, 3> framingNames{"auto", "each", "together"};

}  // namespace

std::vector<SettingDescription> cameraRows() {
    return inGroup(
        "camera",
        {row<parseVector>(
             {.name = "camera-position",
              .shortName = "eye",
              .help = "where the camera stands, world space",
              .defaultInWords = "frames the model"},
             {"X,Y,Z", [] { return std::string{"any point"}; }}, [](auto& s) -> auto& { return s.camera.position; }),
         row<parseVector>(
             {.name = "camera-focal-point",
              .shortName = "target",
              .help = "what the camera looks at, world space",
              .defaultInWords = "the model's centre"},
             {"X,Y,Z", [] { return std::string{"any point but the position"}; }},
             [](auto& s) -> auto& { return s.camera.focalPoint; }),
         row<parseVector>(
             {.name = "camera-view-up",
              .help = "which way is up in the picture, world space: rolls the camera",
              .defaultInWords = "the model's up"},
             {"X,Y,Z", [] { return std::string{"not along the view direction"}; }},
             [](auto& s) -> auto& { return s.camera.viewUp; }),
         row(
             {.name = "camera-view-angle",
              .shortName = "fov",
              .help = "vertical view angle, degrees",
              .defaultInWords = "35",
              .idle = idleViewAngle},
             Number{.min = 0.001, .max = 179.0, .unit = "DEG"}, [](auto& s) -> auto& { return s.camera.viewAngle; }),
         row(
             {.name = "camera-orthographic",
              .help = "orthographic view, HEIGHT scene units tall; 0 frames the model",
              .defaultInWords = "perspective; for --view, --scale 0",
              .idle = idleHeight},
             Number{.min = 1e-36, .max = 1e36, .unit = "HEIGHT", .zeroToo = true},
             [](auto& s) -> auto& { return s.camera.orthographicHeight; }),
         row<parseVector>(
             {.name = "camera-direction",
              .help = "view direction, from the camera into the scene",
              .defaultInWords = "three-quarter view"},
             {"X,Y,Z", [] { return std::string{"not 0,0,0"}; }}, [](auto& s) -> auto& { return s.camera.direction; }),
         row(
             {.name = "view",
              .help = "a view of technical drawings, orthographic unless --fov is given; front looks along -Z where +Y "
                      "is up, along +Y where +Z is; iso: from the right, the front and above, width, depth and height "
                      "at one scale; dimetric: depth at half of it",
              .defaultInWords = "three-quarter view"},
             Choice{namedViewNames}, [](auto& s) -> auto& { return s.camera.view; }),
         row(
             {.name = "framing",
              .help = "how --views are framed: each by itself, or together: at one scale, the model's middle in one "
                      "place; auto: together where a view has a name, as front",
              .idle = idleFraming},
             Choice{framingNames}, [](auto& s) -> auto& { return s.camera.framing; }),
         row(
             {.name = "camera-azimuth-angle",
              .shortName = "azimuth",
              .help = "view from this angle about the model's up, from the front towards the right",
              .defaultInWords = "30"},
             Number{.min = -36'000.0, .max = 36'000.0, .unit = "DEG"},
             [](auto& s) -> auto& { return s.camera.azimuthAngle; }),
         row(
             {.name = "camera-elevation-angle",
              .shortName = "elevation",
              .help = "view from this angle above the horizon",
              .defaultInWords = "20"},
             Number{.min = -90.0, .max = 90.0, .unit = "DEG"},
             [](auto& s) -> auto& { return s.camera.elevationAngle; }),
         row(
             {.name = "camera-index", .help = "a camera of the file", .defaultInWords = "none"},
             Count{.last = "the file's last camera"}, [](auto& s) -> auto& { return s.camera.index; }),
         row(
             {.name = "camera-zoom-factor", .shortName = "zoom", .help = "over 1 magnifies"},
             Number{.min = 0.001, .max = 1e6, .unit = "FACTOR"},
             [](auto& s) -> auto& { return s.camera.zoomFactor; })});
}

}  // namespace inkedge::settings
