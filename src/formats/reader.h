#pragma once

#include <span>
#include <string_view>

#include <inkedge/load_scene.h>
#include <inkedge/scene.h>

#include "formats/model_input.h"

namespace inkedge::formats {

/// A format that models are read from.
struct Reader {
    ModelFormat format;
    /// What its files may begin with; empty: its files are known by their extension alone.
    std::span<const std::string_view> firstBytes = {};
    /// They decide even where the extension is another format's.
    bool firstBytesAreCertain = false;
    LengthUnit unit = LengthUnit::None;  ///< SceneSource::unit, if every file has the same
    bool knowsSides = false;             ///< SceneSource::knowsSides
    glm::dvec3 up{0.0, 1.0, 0.0};        ///< SceneSource::up
    /// @throws Error  (Kind::Input) if it is missing, unreadable, over the limits, truncated, inconsistent or not of
    ///                the format; the message starts with ModelInput::where()
    Scene::Data (*read)(const ModelInput&, const LoadSettings&) = nullptr;
};

/// All of them, in the order of the manual.
[[nodiscard]] std::span<const Reader> readers() noexcept;

/// Reads a model by the reader whose format has its extension, or else whose files begin as it does.
/// @throws Error  (Kind::Input) as the reader, or if there is none; the message starts with ModelInput::where()
[[nodiscard]] Scene::Data readModel(const ModelInput&, const LoadSettings&);

}  // namespace inkedge::formats
