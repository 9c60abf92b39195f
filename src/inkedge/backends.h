#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <inkedge/error.h>
#include <inkedge/export.h>

namespace inkedge {

/// What drew a picture.
struct BackendInfo {
    std::string backend{};   ///< "egl" or "osmesa"
    std::string platform{};  ///< "device 0", "surfaceless" or "osmesa"
    std::string vendor{};    ///< GL_VENDOR
    std::string renderer{};  ///< GL_RENDERER
    std::string version{};   ///< GL_VERSION
    bool software = false;
};

/// One way to a context, tried.
struct BackendReport {
    BackendInfo info;     ///< GL strings are empty where it failed
    std::string failure;  ///< why, and what to do about it; empty where it works
    [[nodiscard]] bool works() const noexcept { return failure.empty(); }
};

/// The backends of this machine in the order in which Backend::Auto tries them. None is tried: the GL strings are
/// empty.
[[nodiscard]] INKEDGE_API std::vector<BackendInfo> listBackends();

/// Tries one of listBackends(). A broken driver may crash here; inkedge doctor tries each in a process of its own.
/// @param number  0 to listBackends().size() - 1
/// @throws Error  (Kind::Usage) if there is none of this number
[[nodiscard]] INKEDGE_API BackendReport probeBackend(std::size_t number);

/// Tries every backend, in the order of listBackends().
[[nodiscard]] INKEDGE_API std::vector<BackendReport> probeBackends();

}  // namespace inkedge
