#include "lines/describe.h"

namespace inkedge::lines {

void describe(Lines& lines, const Scene& scene, const RenderSettings& settings, LinesFrom space) {
    const SceneSource& source = scene.source();
    lines.bounds = scene.bounds();
    lines.source = {.name = source.name,
                    .format = source.format,
                    .unit = source.unit,
                    .triangles = scene.triangleCount(),
                    .warnings = scene.warnings(),
                    .space = space,
                    .finder = settings.lines.contourFinder,
                    .detector = settings.detector.detector};
    std::uint32_t id = 0;
    for (Line& line : lines.lines) {
        line.id = ++id;
        lines.objects.try_emplace(line.object, scene.instances()[line.object - 1].name);
    }
}

}  // namespace inkedge::lines
