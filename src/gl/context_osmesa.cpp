// OSMesa: Mesa's software rasteriser without a window system. Mesa 25.1 dropped it and its library exports gl* symbols,
// so it is loaded at run time and never linked.
#include <array>

#include <fmt/format.h>

#include <inkedge/error.h>

#include "gl/context.h"
#include "gl/shared_object.h"

namespace inkedge::gl {
namespace {

// From GL/osmesa.h, which need not be installed.
constexpr int osmesaFormat = 0x22;
constexpr int osmesaRgba = GL_RGBA;
constexpr int osmesaProfile = 0x33;
constexpr int osmesaCoreProfile = 0x34;
constexpr int osmesaContextMajorVersion = 0x36;
constexpr int osmesaContextMinorVersion = 0x37;

struct OsmesaApi {
    void* (*createContextAttribs)(const int* attributes, void* shareList) = nullptr;
    void (*destroyContext)(void* context) = nullptr;
    GLboolean (*makeCurrent)(void* context, void* buffer, GLenum type, GLsizei width, GLsizei height) = nullptr;
    GLADapiproc (*getProcAddress)(const char* name) = nullptr;
    bool complete = false;
};

const OsmesaApi& osmesa() {
    static const OsmesaApi api = [] {
        OsmesaApi a;
        void* library = openSharedObject({"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"});
        a.complete = library != nullptr && resolve(library, "OSMesaCreateContextAttribs", a.createContextAttribs) &&
                     resolve(library, "OSMesaDestroyContext", a.destroyContext) &&
                     resolve(library, "OSMesaMakeCurrent", a.makeCurrent) &&
                     resolve(library, "OSMesaGetProcAddress", a.getProcAddress);
        return a;
    }();
    return api;
}

class OsmesaContext final : public Context {
public:
    explicit OsmesaContext(const BackendInfo& info) {
        info_ = info;
        if (!osmesa().complete) {
            throw Error{
                Error::Kind::Context,
                "expected libOSMesa.so.8, found none; install it (Debian 12 and 13: apt-get install libosmesa6), "
                "or use egl, where Mesa is 25.1 or newer: it has no OSMesa"};
        }
        constexpr std::array attributes{osmesaFormat,
                                        osmesaRgba,
                                        osmesaProfile,
                                        osmesaCoreProfile,
                                        osmesaContextMajorVersion,
                                        4,
                                        osmesaContextMinorVersion,
                                        5,
                                        0};
        context_ = osmesa().createContextAttribs(attributes.data(), nullptr);
        if (context_ == nullptr) {
            throw Error{Error::Kind::Context,
                        "expected OpenGL 4.5 core from OSMesa, found it refused; update Mesa (17.2 or later has it)"};
        }
        try {
            const Current current{*this};
            load(osmesa().getProcAddress);
        } catch (...) {
            osmesa().destroyContext(context_);
            throw;
        }
    }
    ~OsmesaContext() override { osmesa().destroyContext(context_); }

private:
    void enter() override {
        bind(this);
        before_ = innermost;
        innermost = this;
    }
    void leave() noexcept override {
        innermost = before_;
        // Only our own contexts become current again: OSMesa and EGL of one Mesa share the current context of a thread,
        // so that the context that OSMesa calls current may be EGL's.
        (void)tryToBind(before_);
    }

    static bool tryToBind(OsmesaContext* context) noexcept {
        if (context == nullptr) return osmesa().makeCurrent(nullptr, nullptr, 0, 0, 0) != GL_FALSE;
        return osmesa().makeCurrent(context->context_, &context->pixel_, GL_UNSIGNED_BYTE, 1, 1) != GL_FALSE;
    }
    static void bind(OsmesaContext* context) {
        if (tryToBind(context)) return;
        throw Error{Error::Kind::Context, "expected OSMesa to make its context current, found it refused"};
    }

    static thread_local OsmesaContext* innermost;  // the last one that was entered

    void* context_ = nullptr;
    OsmesaContext* before_ = nullptr;
    std::uint32_t pixel_ = 0;  // the buffer that OSMesa requires; nothing is drawn to it
};

thread_local OsmesaContext* OsmesaContext::innermost = nullptr;

}  // namespace

Candidate osmesaCandidate() {
    return {{.backend = "osmesa", .platform = "osmesa", .software = true}, {}, [](const Candidate& candidate) {
                return std::unique_ptr<Context>{std::make_unique<OsmesaContext>(candidate.info)};
            }};
}

}  // namespace inkedge::gl
