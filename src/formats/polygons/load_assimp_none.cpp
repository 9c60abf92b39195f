// Stands in for load_assimp.cpp where the build leaves libassimp out.
#include <fmt/format.h>

#include "formats/polygons/load_assimp.h"
#include "base/message.h"

namespace inkedge {

bool readsPolygonFormats() noexcept { return false; }

Scene::Data loadAssimp(const std::filesystem::path& file, load::PolygonFormat format, const LoadLimits&,
                       load::Coordinates) {
    load::refuse(fmt::format("{}: expected glTF 2.0 (.glb or .gltf), found {}, which this build does not read",
                             load::printable(file.string()), name(format)));
}

}  // namespace inkedge
