#include "tune/scenes.h"

#include <algorithm>
#include <array>
#include <span>
#include <string_view>
#include <utility>

#include <inkedge/load_scene.h>
#include <inkedge/setting_table.h>

#include "base/stop.h"
#include "job/draw_view.h"
#include "job/file_names.h"

namespace inkedge::tune {
namespace {

constexpr std::size_t maxScenes = 4;
constexpr std::uint64_t maxTriangles = 4'000'000;  // of all that are kept beside the last one: about a gigabyte

std::string textsOf(std::span<const std::string_view> groups, const Settings& settings) {
    std::string texts;
    for (const SettingDescription& row : settingTable())
        if (std::ranges::find(groups, row.group) != groups.end()) texts += row.get(settings) + '\n';
    return texts;
}

// What decides what is read of the file, and how.
std::string howText(const Settings& settings) {
    constexpr std::array<std::string_view, 2> groups{"model", "limits"};
    const LoadSettings load = loadSettings(settings);
    std::string text = textsOf(groups, settings);
    for (const bool extra : {load.textureCoordinates, load.paint, load.curvature}) text += extra ? '1' : '0';
    return text;
}

std::string finenessText(const Settings& settings) {
    constexpr std::array<std::string_view, 2> groups{"camera", "picture"};
    return textsOf(groups, settings);
}

// Whether its triangles stand for smooth surfaces, as finely as the picture needs.
bool followsPicture(const Scene& scene) {
    return scene.loadedWith().subdivide == 0 &&
           std::ranges::any_of(scene.meshes(), [](const Mesh& mesh) { return mesh.surfaces != nullptr; });
}

}  // namespace

Scene Scenes::of(const Job& job, Fineness wanted) {
    const std::string how = howText(job.settings);
    const std::string fineness = finenessText(job.settings);
    const auto found = [&]() -> std::optional<Scene> {
        const std::scoped_lock lock{guard_};
        const Scene* scene = find(how, fineness, wanted);
        return scene == nullptr ? std::nullopt : std::optional{*scene};
    };
    if (auto scene = found()) return *scene;
    const auto reading = base::lockUnlessStopped(reading_);
    if (auto scene = found()) return *scene;  // another thread has read it meanwhile
    // All normals: pictures that come later may need them.
    Scene scene = job::sceneOf(job, job::viewsOf(job), job::Besides::LinesOfTheMesh);
    const std::scoped_lock lock{guard_};
    keep({how, followsPicture(scene) ? fineness : std::string{}, scene});
    return scene;
}

const Scene* Scenes::find(const std::string& how, const std::string& fineness, Fineness wanted) {
    const auto fits = std::ranges::find_if(loaded_, [&](const Loaded& each) {
        return each.how == how && (wanted == Fineness::Any || each.fineness.empty() || each.fineness == fineness);
    });
    if (fits == loaded_.end()) return nullptr;
    std::rotate(loaded_.begin(), fits, fits + 1);
    return &loaded_.front().scene;
}

void Scenes::keep(Loaded loaded) {
    loaded_.insert(loaded_.begin(), std::move(loaded));
    std::uint64_t triangles = 0;
    std::size_t kept = 1;
    for (; kept < std::min(loaded_.size(), maxScenes); ++kept) {
        triangles += loaded_[kept].scene.triangleCount();
        if (triangles > maxTriangles) break;
    }
    loaded_.erase(loaded_.begin() + static_cast<std::ptrdiff_t>(kept), loaded_.end());
}

}  // namespace inkedge::tune
