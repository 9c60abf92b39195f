// Lines as a view has them, for tests of what is written of them.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <inkedge/camera.h>
#include <inkedge/lines.h>
#include <inkedge/scene.h>
#include <inkedge/setting_table.h>

namespace inkedge::io {

inline Scene scene() {
    Scene::Data data;
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.indices = {0, 1, 2};
    data.meshes.push_back(mesh);
    data.instances.push_back({"triangle", 0, glm::dmat4{1.0}});
    return Scene{data};
}

inline Lines linesOf(std::vector<Line> all, Size size = {200, 100}) {
    Lines lines;
    lines.lines = std::move(all);
    lines.size = size;
    lines.camera = frameCamera(scene(), {}, size);
    lines.bounds = scene().bounds();
    return lines;
}

inline Line typed(Line line, LineType type) {
    line.type = type;
    return line;
}

inline Line hidden(Line line) {
    line.visible = false;
    return line;
}

inline Settings settingsOf(const std::vector<std::pair<std::string, std::string>>& values) {
    Settings settings;
    for (const auto& [name, value] : values) set(settings, name, value, name);
    return settings;
}

}  // namespace inkedge::io
