#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include <inkedge/camera.h>
#include <inkedge/maps.h>
#include <inkedge/scene.h>
#include <inkedge/settings.h>

#include "job/draw_view.h"
#include "job/own_renderer.h"
#include "tune/scenes.h"

namespace inkedge::tune {

/// How much of a picture is drawn.
enum class Detail {
    Full,
    Half,  ///< halfSize(): while it moves
};

/// A picture as `inkedge render` writes it to a PNG, and its maps as people see them.
struct StudioPicture {
    std::vector<std::uint8_t> png;
    std::vector<std::pair<Map, std::vector<std::uint8_t>>> layers;  ///< PNGs of settings.maps, of the picture's size
    Camera camera;
    Size size;  ///< pixels
    Scene scene;
    std::vector<std::string> warnings;  ///< one line each: what the settings ask for and the model has nothing for
};

/// What a pixel shows.
struct Hovered {
    std::vector<std::string> types;  ///< of the nearest lines within 4 pixels
    std::string object;              ///< its name; empty: background, or it has none
    std::uint32_t patch = 0;         ///< as in Maps::ids; 0: background
};

/// Draws one model with ever other settings, one drawing at a time. Its functions may be called from several threads.
class Studio {
public:
    explicit Studio(std::filesystem::path model) : model_{std::move(model)} {}

    /// The model as these settings load it. @throws Error  as loadScene()
    [[nodiscard]] Scene scene(const Settings&);

    /// @throws Error  as frameViews() and Renderer::render(); (Kind::Stopped) if it is asked to stop
    [[nodiscard]] StudioPicture draw(const Settings&, Detail, const std::stop_token&);

    /// The bytes of a file, as `inkedge render` writes it.
    /// @param output  its name, whose extension is the format: one that has one file
    /// @throws Error  likewise, and as writeLines()
    [[nodiscard]] std::vector<std::uint8_t> file(const Settings&, const std::string& output, const std::stop_token&);

    /// What a pixel of the full picture shows. The first call for some settings draws its maps, later ones look there.
    /// @throws Error  as draw()
    [[nodiscard]] Hovered hover(const Settings&, int x, int y, const std::stop_token&);

private:
    struct Drawn {
        job::DrawnView view;
        Scene scene;
    };
    Drawn drawJob(const Job&, Fineness);
    std::shared_ptr<const Maps> hoverMaps(const Settings&);

    std::filesystem::path model_;
    Scenes scenes_;
    std::timed_mutex drawing_;  // guards what follows
    job::OwnRenderer renderer_;
    std::shared_ptr<const Maps> hovered_;
    std::string hoveredKey_;  // the settings that it was drawn with
};

}  // namespace inkedge::tune
