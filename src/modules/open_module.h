#pragma once

#include <filesystem>
#include <span>
#include <string_view>

#include <inkedge/error.h>

namespace inkedge {

/// A shared object that lies beside the library and is opened on first use, so that what is costly to load costs only
/// those who need it. Both sides are built together and share the C++ runtime; no exception crosses.
struct Module {
    std::string_view purpose;  ///< for messages: "image formats"
    const char* file;          ///< its name
    const char* symbol;        ///< the one symbol that it exports: a function
    std::string_view library;  ///< what it is there for, for messages: "OpenImageIO"
    std::string_view remedy;   ///< what to do without it, after "or"
};

/// The module's symbol. The module stays open.
/// @param failure  the kind of the error, if there is one: what the caller was about to do
/// @throws Error   (failure) if the module is not found beside the library, or does not fit it; a later call
///                 tries again
[[nodiscard]] void* openModule(const Module&, Error::Kind failure);

/// The same from the first of these folders that holds the module.
[[nodiscard]] void* openModule(const Module&, std::span<const std::filesystem::path> folders, Error::Kind failure);

}  // namespace inkedge
