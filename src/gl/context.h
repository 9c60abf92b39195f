#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <inkedge/backends.h>
#include <inkedge/settings.h>

#include "gl/api.h"

namespace inkedge::gl {

/// An offscreen OpenGL 4.5 core context without a surface: everything is drawn to framebuffers of our own.
class Context {
public:
    Context() = default;
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;
    virtual ~Context() = default;

    [[nodiscard]] const Api& api() const noexcept { return api_; }
    [[nodiscard]] const BackendInfo& info() const noexcept { return info_; }

protected:
    friend class Current;
    /// Makes this context current on the calling thread, and remembers the context that was current before.
    /// @throws Error (Context)
    virtual void enter() = 0;
    /// Makes the context current again that was current before enter().
    virtual void leave() noexcept = 0;
    /// Fills the function table and the GL strings of info_; the context is current. @throws Error (Context)
    void load(GLADapiproc (*loader)(const char* name));

    Api api_{};
    BackendInfo info_;
};

/// Keeps a context current on this thread for a scope.
class Current {
public:
    explicit Current(Context& context) : context_{context} { context_.enter(); }
    ~Current() { context_.leave(); }
    Current(const Current&) = delete;
    Current& operator=(const Current&) = delete;

private:
    Context& context_;
};

/// One way to get a context: what it would be, and how to make it.
struct Candidate {
    BackendInfo info;  ///< backend, platform and software; no GL strings yet
    std::optional<int> device;
    std::unique_ptr<Context> (*create)(const Candidate&);  ///< throws Error (Context) with reason and remedy
};

/// EGL devices, hardware before software, then the surfaceless platform. Empty if EGL cannot be loaded; why is then set
/// to the reason and the remedy.
[[nodiscard]] std::vector<Candidate> eglCandidates(std::string& why);
/// OSMesa, whether it can be loaded or not.
[[nodiscard]] Candidate osmesaCandidate();

/// The first context that works: EGL, then OSMesa, or only the backend or device that is asked for.
/// @throws Error  (Kind::Context) if none works; the message says why, for each that was tried; (Kind::Usage) if the
///                device does not exist
[[nodiscard]] std::unique_ptr<Context> createContext(const BackendSettings&);

}  // namespace inkedge::gl
