// A process that makes an OpenGL 4.5 core context with EGL, makes it current, ends it, and does nothing else: what
// every headless renderer pays. Like inkedge it takes the first hardware device, else the first device.
#include <array>
#include <cstdio>
#include <cstring>

#include <EGL/egl.h>
#include <EGL/eglext.h>

namespace {

int fail(const char* step) {
    std::fprintf(stderr, "context_only: error: expected %s to succeed, found EGL error %#x\n", step,
                 static_cast<unsigned>(eglGetError()));
    return 4;
}

EGLDisplay chooseDisplay() {
    const auto queryDevices = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
    const auto queryString =
        reinterpret_cast<PFNEGLQUERYDEVICESTRINGEXTPROC>(eglGetProcAddress("eglQueryDeviceStringEXT"));
    std::array<EGLDeviceEXT, 16> devices{};
    EGLint count = 0;
    if (queryDevices == nullptr || queryString == nullptr ||
        queryDevices(static_cast<EGLint>(devices.size()), devices.data(), &count) == EGL_FALSE || count == 0) {
        return eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
    }
    EGLDeviceEXT chosen = devices[0];
    for (EGLint i = count - 1; i >= 0; --i) {
        const EGLDeviceEXT device = devices[static_cast<std::size_t>(i)];
        const char* extensions = queryString(device, EGL_EXTENSIONS);
        if (extensions != nullptr && std::strstr(extensions, "EGL_MESA_device_software") == nullptr) chosen = device;
    }
    return eglGetPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, chosen, nullptr);
}

}  // namespace

int main() {
    const EGLDisplay display = chooseDisplay();
    if (display == EGL_NO_DISPLAY) return fail("eglGetPlatformDisplay");
    if (eglInitialize(display, nullptr, nullptr) == EGL_FALSE) return fail("eglInitialize");
    if (eglBindAPI(EGL_OPENGL_API) == EGL_FALSE) return fail("eglBindAPI");
    constexpr EGLint attributes[]{
        EGL_CONTEXT_MAJOR_VERSION,           4,       EGL_CONTEXT_MINOR_VERSION, 5, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    const EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
    if (context == EGL_NO_CONTEXT) return fail("eglCreateContext");
    if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_FALSE) return fail("eglMakeCurrent");
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display, context);
    eglTerminate(display);
    return 0;
}
