// EGL: the device platform (hardware, then software), then Mesa's surfaceless platform. Needs no display server. The
// library is loaded at run time, so that a machine without it gets an explanation instead of a loader error.
#include <algorithm>
#include <array>
#include <map>
#include <mutex>
#include <string_view>

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <fmt/format.h>

#include <inkedge/error.h>

#include "gl/context.h"
#include "gl/shared_object.h"

namespace inkedge::gl {
namespace {

struct EglApi {
    decltype(&eglGetProcAddress) getProcAddress = nullptr;
    decltype(&eglQueryString) queryString = nullptr;
    decltype(&eglGetError) getError = nullptr;
    decltype(&eglInitialize) initialize = nullptr;
    decltype(&eglTerminate) terminate = nullptr;
    decltype(&eglBindAPI) bindApi = nullptr;
    decltype(&eglQueryAPI) queryApi = nullptr;
    decltype(&eglCreateContext) createContext = nullptr;
    decltype(&eglDestroyContext) destroyContext = nullptr;
    decltype(&eglMakeCurrent) makeCurrent = nullptr;
    decltype(&eglGetCurrentContext) getCurrentContext = nullptr;
    decltype(&eglGetCurrentDisplay) getCurrentDisplay = nullptr;
    decltype(&eglGetCurrentSurface) getCurrentSurface = nullptr;
    decltype(&eglReleaseThread) releaseThread = nullptr;
    PFNEGLGETPLATFORMDISPLAYEXTPROC getPlatformDisplay = nullptr;
    PFNEGLQUERYDEVICESEXTPROC queryDevices = nullptr;            // null without the device platform
    PFNEGLQUERYDEVICESTRINGEXTPROC queryDeviceString = nullptr;  // null without the device platform
    std::string failure;
};

const EglApi& egl() {
    static const EglApi api = [] {
        EglApi a;
        void* library = openSharedObject({"libEGL.so.1", "libEGL.so"});
        if (library == nullptr) {
            a.failure =
                "expected libEGL.so.1, found none; install it (Debian: apt-get install libegl1 libgl1-mesa-dri)";
            return a;
        }
        const bool complete =
            resolve(library, "eglGetProcAddress", a.getProcAddress) &&
            resolve(library, "eglQueryString", a.queryString) && resolve(library, "eglGetError", a.getError) &&
            resolve(library, "eglInitialize", a.initialize) && resolve(library, "eglTerminate", a.terminate) &&
            resolve(library, "eglBindAPI", a.bindApi) && resolve(library, "eglQueryAPI", a.queryApi) &&
            resolve(library, "eglCreateContext", a.createContext) &&
            resolve(library, "eglDestroyContext", a.destroyContext) &&
            resolve(library, "eglMakeCurrent", a.makeCurrent) &&
            resolve(library, "eglGetCurrentContext", a.getCurrentContext) &&
            resolve(library, "eglGetCurrentDisplay", a.getCurrentDisplay) &&
            resolve(library, "eglGetCurrentSurface", a.getCurrentSurface) &&
            resolve(library, "eglReleaseThread", a.releaseThread);
        if (complete) {
            const auto get = [&](const char* name) { return a.getProcAddress(name); };
            a.getPlatformDisplay = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(get("eglGetPlatformDisplayEXT"));
            a.queryDevices = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(get("eglQueryDevicesEXT"));
            a.queryDeviceString = reinterpret_cast<PFNEGLQUERYDEVICESTRINGEXTPROC>(get("eglQueryDeviceStringEXT"));
        }
        if (a.getPlatformDisplay == nullptr) {
            a.failure = "expected EGL 1.5 with EGL_EXT_platform_base, found an older library; update Mesa or libglvnd";
        }
        return a;
    }();
    return api;
}

bool listed(const char* extensions, std::string_view wanted) {
    if (extensions == nullptr) return false;
    std::string_view rest{extensions};
    while (!rest.empty()) {
        const auto end = std::min(rest.find(' '), rest.size());
        if (rest.substr(0, end) == wanted) return true;
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return false;
}

std::string lastError() {
    static const std::map<EGLint, const char*> names{
        {EGL_SUCCESS, "it refused without a reason"}, {EGL_NOT_INITIALIZED, "EGL_NOT_INITIALIZED"},
        {EGL_BAD_ACCESS, "EGL_BAD_ACCESS"},           {EGL_BAD_ALLOC, "EGL_BAD_ALLOC"},
        {EGL_BAD_ATTRIBUTE, "EGL_BAD_ATTRIBUTE"},     {EGL_BAD_CONFIG, "EGL_BAD_CONFIG"},
        {EGL_BAD_DISPLAY, "EGL_BAD_DISPLAY"},         {EGL_BAD_MATCH, "EGL_BAD_MATCH"},
        {EGL_BAD_PARAMETER, "EGL_BAD_PARAMETER"}};
    const EGLint code = egl().getError();
    const auto found = names.find(code);
    return found == names.end() ? fmt::format("EGL error {:#x}", code) : found->second;
}

std::vector<EGLDeviceEXT> devices() {
    if (egl().queryDevices == nullptr) return {};
    EGLint count = 0;
    if (egl().queryDevices(0, nullptr, &count) == EGL_FALSE || count <= 0) return {};
    std::vector<EGLDeviceEXT> all(static_cast<std::size_t>(count));
    if (egl().queryDevices(count, all.data(), &count) == EGL_FALSE) return {};
    all.resize(static_cast<std::size_t>(count));
    return all;
}

bool isSoftware(EGLDeviceEXT device) {
    return egl().queryDeviceString != nullptr &&
           listed(egl().queryDeviceString(device, EGL_EXTENSIONS), "EGL_MESA_device_software");
}

// An initialised display. EGL gives the same display to all users of one platform and device, and terminating it ends
// it for all of them: so they share this object.
class Display {
public:
    explicit Display(EGLDisplay handle) : handle_{handle} {
        EGLint major = 0;
        EGLint minor = 0;
        if (egl().initialize(handle_, &major, &minor) == EGL_FALSE) {
            throw Error{Error::Kind::Context,
                        fmt::format("expected the EGL display to start, found {}; check that the driver is installed "
                                    "(Debian, software: apt-get install libgl1-mesa-dri) and that /dev/dri is readable",
                                    lastError())};
        }
    }
    ~Display() { egl().terminate(handle_); }
    Display(const Display&) = delete;
    Display& operator=(const Display&) = delete;
    [[nodiscard]] EGLDisplay handle() const noexcept { return handle_; }

private:
    EGLDisplay handle_;
};

EGLDisplay displayOf(EGLenum platform, void* nativeDisplay) {
    const EGLDisplay handle = egl().getPlatformDisplay(platform, nativeDisplay, nullptr);
    if (handle == EGL_NO_DISPLAY) {
        throw Error{Error::Kind::Context, fmt::format("expected an EGL display, found {}", lastError())};
    }
    return handle;
}

// The one of these displays that the fewest contexts use, the first of several.
std::shared_ptr<Display> openDisplay(const std::vector<EGLDisplay>& handles) {
    static std::mutex mutex;
    static std::map<EGLDisplay, std::weak_ptr<Display>> open;
    const std::scoped_lock lock{mutex};
    const EGLDisplay handle =
        *std::ranges::min_element(handles, {}, [](EGLDisplay each) { return open[each].use_count(); });
    std::shared_ptr<Display> display = open[handle].lock();
    if (!display) {
        display = std::make_shared<Display>(handle);
        open[handle] = display;
    }
    return display;
}

class EglContext final : public Context {
public:
    EglContext(const BackendInfo& info, std::shared_ptr<Display> display) : display_{std::move(display)} {
        info_ = info;
        const char* extensions = egl().queryString(display_->handle(), EGL_EXTENSIONS);
        for (const char* needed : {"EGL_KHR_surfaceless_context", "EGL_KHR_no_config_context"}) {
            if (!listed(extensions, needed)) {
                throw Error{
                    Error::Kind::Context,
                    fmt::format("expected the EGL extension {}, found none; update the graphics driver", needed)};
            }
        }
        const EGLenum apiBefore = egl().queryApi();
        egl().bindApi(EGL_OPENGL_API);
        context_ = createContext();
        egl().bindApi(apiBefore);
        if (context_ == EGL_NO_CONTEXT) {
            throw Error{
                Error::Kind::Context,
                fmt::format("expected OpenGL 4.5 core, found {}; update the graphics driver or Mesa", lastError())};
        }
        try {
            const Current current{*this};
            load([](const char* name) { return egl().getProcAddress(name); });
        } catch (...) {
            egl().destroyContext(display_->handle(), context_);
            throw;
        }
    }
    ~EglContext() override { egl().destroyContext(display_->handle(), context_); }

private:
    // Asks for a context that reports when a reset of the graphics processor loses it; others go on with wrong
    // pictures. Not every driver supports this.
    [[nodiscard]] EGLContext createContext() const {
        constexpr std::size_t resets = 6;
        std::array attributes{EGL_CONTEXT_MAJOR_VERSION,
                              4,
                              EGL_CONTEXT_MINOR_VERSION,
                              5,
                              EGL_CONTEXT_OPENGL_PROFILE_MASK,
                              EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                              EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY,
                              EGL_LOSE_CONTEXT_ON_RESET,
                              EGL_NONE};
        const auto create = [&] {
            return egl().createContext(display_->handle(), EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes.data());
        };
        if (const EGLContext context = create(); context != EGL_NO_CONTEXT) return context;
        attributes[resets] = EGL_NONE;
        return create();
    }

    struct Binding {
        EGLenum api;
        EGLDisplay display;
        EGLContext context;
        EGLSurface draw;
        EGLSurface read;
    };

    void enter() override {
        before_.api = egl().queryApi();
        egl().bindApi(EGL_OPENGL_API);
        before_.display = egl().getCurrentDisplay();
        before_.context = egl().getCurrentContext();
        before_.draw = egl().getCurrentSurface(EGL_DRAW);
        before_.read = egl().getCurrentSurface(EGL_READ);
        if (egl().makeCurrent(display_->handle(), EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_FALSE) {
            const std::string reason = lastError();
            egl().bindApi(before_.api);
            throw Error{Error::Kind::Context,
                        fmt::format("expected the context to become current, found {}; is it in use by another thread?",
                                    reason)};
        }
    }
    void leave() noexcept override {
        if (before_.context == EGL_NO_CONTEXT) {
            egl().makeCurrent(display_->handle(), EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        } else {
            egl().makeCurrent(before_.display, before_.draw, before_.read, before_.context);
        }
        egl().bindApi(before_.api);
    }

    std::shared_ptr<Display> display_;
    EGLContext context_ = EGL_NO_CONTEXT;
    Binding before_{};
};

bool hasSurfaceless() {
    return listed(egl().queryString(EGL_NO_DISPLAY, EGL_EXTENSIONS), "EGL_MESA_platform_surfaceless");
}

// Contexts of one display of llvmpipe rasterise one after the other. Where it is the only device, both platforms lead
// to it, and two contexts draw at a time.
std::unique_ptr<Context> createOnDevice(const Candidate& candidate) {
    const std::vector<EGLDeviceEXT> all = devices();
    const EGLDeviceEXT device = all.at(static_cast<std::size_t>(*candidate.device));
    std::vector<EGLDisplay> displays{displayOf(EGL_PLATFORM_DEVICE_EXT, device)};
    if (candidate.info.software && all.size() == 1 && hasSurfaceless())
        displays.push_back(displayOf(EGL_PLATFORM_SURFACELESS_MESA, nullptr));
    return std::make_unique<EglContext>(candidate.info, openDisplay(displays));
}

std::unique_ptr<Context> createSurfaceless(const Candidate& candidate) {
    if (!hasSurfaceless()) {
        throw Error{Error::Kind::Context,
                    "expected the EGL extension EGL_MESA_platform_surfaceless, found none; "
                    "install Mesa (Debian: apt-get install libegl-mesa0 libgl1-mesa-dri)"};
    }
    return std::make_unique<EglContext>(candidate.info,
                                        openDisplay({displayOf(EGL_PLATFORM_SURFACELESS_MESA, nullptr)}));
}

}  // namespace

std::vector<Candidate> eglCandidates(std::string& why) {
    why = egl().failure;
    if (!why.empty()) return {};
    std::vector<Candidate> candidates;
    const std::vector<EGLDeviceEXT> all = devices();
    for (int i = 0; i < static_cast<int>(all.size()); ++i) {
        candidates.push_back({{.backend = "egl",
                               .platform = fmt::format("device {}", i),
                               .software = isSoftware(all[static_cast<std::size_t>(i)])},
                              i,
                              createOnDevice});
    }
    std::stable_partition(candidates.begin(), candidates.end(), [](const Candidate& c) { return !c.info.software; });
    candidates.push_back({{.backend = "egl", .platform = "surfaceless"}, {}, createSurfaceless});
    return candidates;
}

}  // namespace inkedge::gl
