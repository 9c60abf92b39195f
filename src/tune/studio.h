#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include <inkedge/camera.h>
#include <inkedge/job.h>
#include <inkedge/renderer.h>
#include <inkedge/scene.h>
#include <inkedge/settings.h>

#include "job/own_renderer.h"

namespace inkedge::tune {

/// How much of a picture is drawn.
enum class Detail {
    Full,
    Half,  ///< half its size, by lines half as wide: while it moves
};

/// A file, as `inkedge render` writes it.
struct StudioFile {
    std::vector<std::uint8_t> bytes;
    Camera camera;  ///< that it was drawn by
    Size size;      ///< of its picture, pixels
};

/// What a pixel shows.
struct Hovered {
    std::vector<std::string> types;  ///< of lines
    std::string object;              ///< its name; empty: background
    std::uint32_t patch = 0;         ///< as in Maps::ids
};

/// Draws one model with ever other settings, one drawing at a time. Its functions may be called from several threads.
class Studio {
public:
    explicit Studio(std::filesystem::path model) : model_{std::move(model)} {}

    /// The model, as these settings load it. @throws Error  as loadScene()
    [[nodiscard]] Scene scene(const Settings&);

    /// @param output  its name, whose extension is the format
    /// @param map     a map of the picture in its stead; none: the picture
    /// @throws Error  as checkJobs() and runJobs(); (Kind::Stopped) if it is asked to stop
    [[nodiscard]] StudioFile draw(Settings, const std::string& output, std::optional<Map> map, Detail,
                                  const std::stop_token&);

    /// @throws Error  likewise
    [[nodiscard]] Hovered hover(const Settings&, int x, int y);

    [[nodiscard]] const std::filesystem::path& model() const noexcept { return model_; }

private:
    const Scene& sceneOf(const Job&, Detail);

    std::filesystem::path model_;
    std::timed_mutex drawing_;  // guards what follows
    job::OwnRenderer renderer_;
    std::optional<Scene> scene_;
    std::string sceneKey_;  // settings that it was loaded with
    std::optional<Maps> hovered_;
    std::string hoveredKey_;
};

}  // namespace inkedge::tune
