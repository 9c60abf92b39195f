#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include <inkedge/error.h>

namespace inkedge::modules {

/// A shared object beside the library that is opened on first use, so that a library that is slow to load, or missing,
/// does not matter to those who do not need it. Each module wraps one third-party library, which nothing else sees. The
/// library and its modules are built together and share the C++ runtime; no exception crosses (modules/failure.h).
struct Module {
    std::string_view purpose;  ///< for messages: "image formats"
    const char* file;          ///< its name: inkedge_NAME.so
    const char* symbol;        ///< the one symbol that it exports, a function; numbered by the version of its interface
    std::string_view library;  ///< the library that it wraps, for messages: "OpenImageIO"
    std::string_view option;   ///< the CMake option that it is built with; empty: it is always built
    std::string_view remedy;   ///< what to do without it, after "or"
    /// How many threads its library starts for itself when it is loaded or first used; some libraries end the process
    /// where they cannot. A function, as it may depend on the machine; none: it starts none, or copes.
    std::size_t (*threads)() = nullptr;
};

/// The symbol of a module, which is opened and stays open.
/// @param failure  the kind of the error, if there is one
/// @throws Error   (failure) if the module is not found beside the library, does not fit it, or lacks its own library;
///                 a later call tries again
[[nodiscard]] void* openModule(const Module&, Error::Kind failure);

/// The same, from the first of these folders that holds the module.
[[nodiscard]] void* openModule(const Module&, std::span<const std::filesystem::path> folders, Error::Kind failure);

/// The file of a module, or of a program that lies where modules do, which is not opened.
/// @throws Error  (failure) if it is not found beside the library
[[nodiscard]] std::filesystem::path findModule(const Module&, Error::Kind failure);

/// A module whose symbol is a function without arguments that returns a pointer to its Functions.
template <class Functions>
struct ModuleOf : Module {};

/// The functions of a module, which is opened by the first call.
/// @throws Error  as openModule()
template <const auto& module>
[[nodiscard]] const auto& functionsOf(Error::Kind failure) {
    return []<class Functions>(const ModuleOf<Functions>& opened, Error::Kind kind) -> const Functions& {
        static const Functions& functions = *reinterpret_cast<const Functions* (*)()>(openModule(opened, kind))();
        return functions;
    }(module, failure);
}

/// Why a module cannot be used, on one line; empty: it can be.
[[nodiscard]] std::string failureToOpen(const Module&);

}  // namespace inkedge::modules
