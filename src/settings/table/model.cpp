#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "settings/idle.h"
#include "settings/rows.h"

namespace inkedge::settings {
namespace {

constexpr std::array<std::string_view, 3> normalsNames{"auto", "authored", "flat"};
constexpr std::array<std::string_view, 6> unitNames{"auto", "m", "mm", "cm", "in", "ft"};  // as LengthUnit
constexpr std::array<std::string_view, 3> creasesNames{"auto", "angle", "normals"};
constexpr std::array<std::string_view, 2> transparentNames{"solid", "ignore"};
constexpr std::array<std::string_view, 2> alphaMaskNames{"cut", "ignore"};
constexpr std::array<std::string_view, 2> backFacesNames{"draw", "material"};

constexpr std::uint64_t tera = std::uint64_t{1} << 40U;
constexpr Count bytes{.min = 1, .max = tera, .unit = "BYTES", .suffixes = true};
constexpr Count amount{.min = 1, .max = tera, .suffixes = true};

std::string parseName(std::string_view text) { return std::string{text}; }

template <class Field>
SettingDescription::Field directionField(Field) {
    return {
        [](const Constraint&, Settings& s, std::string_view text) { Field{}(s) = parseDirection(text); },
        [](const Constraint&, const Settings& s) { return Field{}(s) ? textOfDirection(*Field{}(s)) : std::string{}; }};
}

// Names with ; between them.
template <class Field>
SettingDescription::Field namesField(Field) {
    return {[](const Constraint&, Settings& s, std::string_view text) {
                const std::vector<std::string_view> names = split(text, ';');
                if (std::ranges::find(names, "") != names.end()) throw Expected{"names of nodes"};
                Field{}(s).assign(names.begin(), names.end());
            },
            [](const Constraint&, const Settings& s) { return fmt::format("{}", fmt::join(Field{}(s), ";")); }};
}

std::string nodeNames() { return "nodes by name, or by path as in arm/hand; with * and ?"; }

}  // namespace

std::vector<SettingDescription> modelRows() {
    return inGroup(
        "model",
        {described(
             {.name = "up",
              .help = "which way is up of the model: azimuth, elevation, views, turntables and height turn about it",
              .defaultInWords = "the format's: +Y for glTF, OBJ and PLY, +Z for others"},
             Custom{"AXIS|X,Y,Z", [] { return std::string{"+X, -X, ... -Z, or any direction"}; }},
             directionField([](auto& s) -> auto& { return s.load.up; })),
         row(
             {.name = "unit",
              .help = "what one unit of the model is, for --scale and .dxf; auto: m in glTF, mm in other formats",
              .idle = idleUnit},
             Choice{unitNames}, [](auto& s) -> auto& { return s.load.unit; }),
         described({.name = "only",
                    .help = "draw these nodes alone, with all that belongs to them",
                    .rangeNote = "several: ; between them, or the flag again",
                    .joinedBy = ';'},
                   Custom{"NAME", nodeNames}, namesField([](auto& s) -> auto& { return s.load.only; })),
         described({.name = "hide",
                    .help = "leave these nodes out, with all that belongs to them",
                    .rangeNote = "several: ; between them, or the flag again",
                    .joinedBy = ';'},
                   Custom{"NAME", nodeNames}, namesField([](auto& s) -> auto& { return s.load.hide; })),
         row(
             {.name = "normals",
              .help = "auto: the file's, smooth ones where it has none; authored: flat where it has none"},
             Choice{normalsNames}, [](auto& s) -> auto& { return s.load.normals; }),
         row(
             {.name = "creases", .help = "what an edge is decided by: its faces' bend, the file's normals; auto: both"},
             Choice{creasesNames}, [](auto& s) -> auto& { return s.load.creases; }),
         row(
             {.name = "crease-angle", .help = "faces that meet at more than this meet in a crease"},
             Number{.min = 0.0, .max = 180.0, .unit = "DEG"}, [](auto& s) -> auto& { return s.load.creaseAngle; }),
         row(
             {.name = "scene",
              .help = "which of the file's scenes to draw",
              .defaultInWords = "the file's default scene"},
             Count{.last = "the glTF file's last"}, [](auto& s) -> auto& { return s.load.scene; }),
         row<parseName>(
             {.name = "animation", .help = "pose the model as an animation of the file does"},
             {"NAME|N", [] { return std::string{"an animation of the glTF file"}; }},
             [](auto& s) -> auto& { return s.load.animation; }),
         row(
             {.name = "time", .help = "when in the animation", .idle = idleTime},
             Number{.min = 0.0, .max = 1e9, .unit = "SECONDS"}, [](auto& s) -> auto& { return s.load.time; }),
         row(
             {.name = "transparent", .help = "what becomes of materials that blend with what lies behind them"},
             Choice{transparentNames}, [](auto& s) -> auto& { return s.load.transparent; }),
         row(
             {.name = "alpha-mask", .help = "cut materials with holes out along their outline, or draw them whole"},
             Choice{alphaMaskNames}, [](auto& s) -> auto& { return s.load.alphaMask; }),
         row(
             {.name = "back-faces", .help = "draw the backs of all faces, or only those of double-sided materials"},
             Choice{backFacesNames}, [](auto& s) -> auto& { return s.load.backFaces; }),
         row(
             {.name = "tolerance",
              .help =
                  "how far triangles may stray from the curved surfaces of CAD files, in the largest picture drawn"},
             Number{.min = 0.001, .max = 100.0, .unit = "PX"}, [](auto& s) -> auto& { return s.load.tolerance; }),
         row(
             {.name = "subdivide",
              .help = "refine every mesh N times into the smooth surface that it controls; creases stay sharp"},
             subdivisionLevels, [](auto& s) -> auto& { return s.load.subdivide; })});
}

std::vector<SettingDescription> limitRows() {
    return inGroup(
        "limits", {row(
                       {.name = "max-file-size", .help = "most bytes of a model and the files that belong to it"},
                       bytes, [](auto& s) -> auto& { return s.load.limits.fileSize; }),
                   row(
                       {.name = "max-decompressed-size", .help = "most bytes that compressed geometry comes to"}, bytes,
                       [](auto& s) -> auto& { return s.load.limits.decompressedSize; }),
                   row(
                       {.name = "max-vertices", .help = "most vertices and indices of all meshes"},
                       Count{.min = 1, .max = 4'000'000'000, .suffixes = true},
                       [](auto& s) -> auto& { return s.load.limits.vertices; }),
                   row(
                       {.name = "max-instances", .help = "most meshes drawn, counted each time"}, amount,
                       [](auto& s) -> auto& { return s.load.limits.instances; }),
                   row(
                       {.name = "max-nodes", .help = "most nodes of a model"}, amount,
                       [](auto& s) -> auto& { return s.load.limits.nodes; }),
                   row(
                       {.name = "max-node-depth", .help = "most nodes from a root down"}, amount,
                       [](auto& s) -> auto& { return s.load.limits.nodeDepth; }),
                   row(
                       {.name = "max-image-pixels", .help = "most pixels of a picture that a material needs"}, amount,
                       [](auto& s) -> auto& { return s.load.limits.imagePixels; }),
                   row(
                       {.name = "max-reading-time", .help = "most seconds to read a CAD file or an implicit surface"},
                       Number{.min = 0.001, .max = 1e6, .unit = "SECONDS"},
                       [](auto& s) -> auto& { return s.load.limits.readingTime; })});
}

}  // namespace inkedge::settings
