#include "lines/describe.h"

#include <cstdint>
#include <set>
#include <vector>

#include "scene/names.h"

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
    std::set<std::uint32_t> instances;
    for (Line& line : lines.lines) {
        line.id = ++id;
        instances.insert(line.object);
    }
    lines.names = scene::namesOf(scene, std::vector(instances.begin(), instances.end()));
}

}  // namespace inkedge::lines
