#pragma once

#include <cstdint>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include <inkedge/job.h>
#include <inkedge/scene.h>

namespace inkedge::tune {

/// How fine the triangles of curved surfaces must be, which for CAD files hangs on the camera and the picture.
enum class Fineness {
    AsForPicture,  ///< as the command reads the model for this picture
    Any,           ///< whatever is there already
};

/// One model as several settings load it: those that were used last are kept, as far as they are not large. May be
/// called from several threads; one at a time reads the model.
class Scenes {
public:
    /// The job's model, as its settings load it.
    /// @throws Error  as loadScene(); (Kind::Stopped) as base::stopIfAsked()
    [[nodiscard]] Scene of(const Job&, Fineness);

private:
    struct Loaded {
        std::string how;       // texts of the settings that load it
        std::string fineness;  // texts of those that its triangles are as fine as; empty: they are what they are
        Scene scene;
    };
    const Scene* find(const std::string& how, const std::string& fineness, Fineness);
    void keep(Loaded);

    std::timed_mutex reading_;
    std::mutex guard_;            // of what follows
    std::vector<Loaded> loaded_;  // what was used last comes first
};

}  // namespace inkedge::tune
