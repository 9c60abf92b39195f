#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include <inkedge/export.h>
#include <inkedge/settings.h>

namespace inkedge::tune {

/// A live page over one model.
struct TuneOptions {
    std::filesystem::path model;
    Settings settings;  ///< that the page begins with
    int port = 0;       ///< of 127.0.0.1; 0: any that is free
    /// Called with the page's address once it can be opened.
    std::function<void(const std::string& address)> waiting = {};
};

/// Serves the page until the process ends.
/// @throws Error  as loadScene(), for the model is read first; (Kind::Runtime) if the port is taken
[[noreturn]] INKEDGE_API void serve(const TuneOptions&);

}  // namespace inkedge::tune
