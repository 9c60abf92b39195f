#include <algorithm>

#include <inkedge/renderer.h>

namespace inkedge {

std::vector<std::string> renderWarnings(const Scene& scene, const RenderSettings& settings) {
    const auto hasNone = [](const Mesh& mesh) { return mesh.textureCoordinates.empty(); };
    const bool wantsIsolines =
        settings.picture.lines.contains(LineType::Isoparametric) && settings.lines.isolines != Isolines{};
    if (!wantsIsolines || !std::ranges::all_of(scene.meshes(), hasNone)) return {};
    return {"has no texture coordinates: no isolines are drawn"};
}

}  // namespace inkedge
