#include "settings/constraints.h"
#include "settings/idle.h"
#include "settings/names.h"
#include "settings/rows.h"

namespace inkedge::settings {
namespace {

using Names = std::string_view;
constexpr std::array linesFromNames{Names{"auto"}, Names{"image"}, Names{"object"}};
constexpr std::array contourNames{Names{"auto"}, Names{"mesh"}, Names{"smooth"}};
constexpr std::array hiddenNames{Names{"none"}, Names{"dashed"}, Names{"solid"}};
constexpr std::array coincidentNames{Names{"merge"}, Names{"keep"}};
constexpr std::array pathOrderNames{Names{"drawn"}, Names{"travel"}};
constexpr std::array strokeWidthNames{Names{"constant"}, Names{"depth"}, Names{"curvature"}, Names{"strength"}};

const Number strengths{.min = 0.0, .max = 100.0, .unit = "X"};

std::string isolineRange() { return rangeOf(isolineSteps); }
std::filesystem::path parsePath(std::string_view text) { return text; }

}  // namespace

std::vector<SettingDescription> lineRows() {
    return inGroup(
        "lines",
        {row(
             {.name = "lines-from",
              .help =
                  "image: between pixels; object: exact lines of the mesh; auto: object for .svg, .pdf, .dxf and .json",
              .idle = idleLinesFrom},
             Choice{linesFromNames}, [](auto& s) -> auto& { return s.lines.from; }),
         row(
             {.name = "contour",
              .help = "contours: edges of the mesh, or curves where the shading normal turns away; lines from object",
              .idle = idleWithoutMeshLines},
             Choice{contourNames}, [](auto& s) -> auto& { return s.lines.contour; }),
         row(
             {.name = "contour-finder",
              .help = "every edge, a random search that may miss some, or a map for orthographic views; lines from "
                      "object",
              .idle = idleWithoutMeshLines},
             Choice{contourFinderNames}, [](auto& s) -> auto& { return s.lines.contourFinder; }),
         row(
             {.name = "hidden", .help = "how hidden lines are drawn; lines from object", .idle = idleWithoutMeshLines},
             Choice{hiddenNames}, [](auto& s) -> auto& { return s.lines.hidden; }),
         row(
             {.name = "coincident",
              .help = "merge: of lines within 0.1 px of each other, hidden ones within their pen's width, the nearest "
                      "that is seen; keep: all; lines from object",
              .idle = idleWithoutMeshLines},
             Choice{coincidentNames}, [](auto& s) -> auto& { return s.lines.coincident; }),
         row(
             {.name = "stroke-width",
              .help = "wider where nearer, or where straighter: half to one and a half widths; strength: lines of form "
                      "fade where they are weak; lines from object",
              .idle = idleStrokeWidth},
             Choice{strokeWidthNames}, [](auto& s) -> auto& { return s.lines.strokeWidth; }),
         row(
             {.name = "stroke-taper",
              .help = "pixels over which ends where no line goes on or meets run out to nothing; lines from object",
              .idle = idleStroke},
             Number{.min = 0.0, .max = 1000.0, .unit = "PX"}, [](auto& s) -> auto& { return s.lines.strokeTaper; }),
         row<parsePath>(
             {.name = "brush",
              .help = "texture repeated along each line, its height across the line's width; lines from object",
              .idle = idleStroke},
             {"FILE", [] { return std::string{"a PNG, dark is ink"}; }},
             [](auto& s) -> auto& { return s.lines.brush; }),
         row(
             {.name = "simplify",
              .help = "how far polylines in .svg, .pdf, .dxf and .json may stray from the lines found",
              .rangeNote = "0 keeps every point",
              .idle = idleSimplify},
             Number{.min = 0.0, .max = 100.0, .unit = "PX"}, [](auto& s) -> auto& { return s.lines.simplify; }),
         row(
             {.name = "fit-curves",
              .help = "curves in .svg, .pdf and .dxf that stray from the lines no further than this; 0: polylines",
              .idle = idleCentreLines},
             Number{.min = 0.01, .max = 100.0, .unit = "PX", .zeroToo = true},
             [](auto& s) -> auto& { return s.lines.fitCurves; }),
         row(
             {.name = "path-order",
              .help = "order of the paths in .svg, .pdf and .dxf: drawn: one an object; travel: one a line, so that "
                      "a pen travels little between them",
              .idle = idleCentreLines},
             Choice{pathOrderNames}, [](auto& s) -> auto& { return s.lines.pathOrder; }),
         row(
             {.name = "subdivide-adaptive",
              .help = "refine N times, but only the faces that the contour may cross; lines from object",
              .idle = idleWithoutMeshLines},
             subdivisionLevels, [](auto& s) -> auto& { return s.lines.subdivideAdaptive; }),
         row<parseIsolines>(
             {.name = "isolines",
              .help = "lines at N steps of each texture coordinate's unit; lines from object",
              .idle = idleIsolines},
             {"N|u:N,v:N", isolineRange}, [](auto& s) -> auto& { return s.lines.isolines; }),
         row(
             {.name = "feature-size",
              .help = "what is smaller is roughness: of the radius of a sphere as large as the surface; lines of form",
              .idle = idleForm<LineType::Suggestive, LineType::Ridge, LineType::Valley, LineType::Apparent>},
             Number{.min = 0.01, .max = 20.0, .unit = "%"}, [](auto& s) -> auto& { return s.lines.form.featureSize; }),
         row(
             {.name = "suggestive-threshold",
              .help = "suggestive contours that are this strong somewhere are drawn: feature sizes per length over "
                      "which radial curvature comes",
              .idle = idleForm<LineType::Suggestive>},
             strengths, [](auto& s) -> auto& { return s.lines.form.suggestiveThreshold; }),
         row(
             {.name = "ridge-threshold",
              .help = "ridges and valleys that are this strong somewhere are drawn: feature sizes per radius of their "
                      "curvature",
              .idle = idleForm<LineType::Ridge, LineType::Valley>},
             strengths, [](auto& s) -> auto& { return s.lines.form.ridgeThreshold; }),
         row(
             {.name = "apparent-threshold",
              .help = "apparent ridges that are this strong somewhere are drawn: feature sizes per radius of curvature "
                      "as it is seen",
              .idle = idleForm<LineType::Apparent>},
             strengths, [](auto& s) -> auto& { return s.lines.form.apparentThreshold; })});
}

}  // namespace inkedge::settings
