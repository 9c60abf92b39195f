#!/bin/bash
# Threads that draw with contexts of their own, on Mesa's llvmpipe with LP_NUM_THREADS=0, where the calling thread
# rasterises, would be expected to draw at the same time. Contexts of one EGL display wait for each other: two threads
# take twice as long as if one had its display from the device platform and the other from the surfaceless one, which
# lead to the same driver. So it is with 22.3.6 and 25.0.7. Other displays are other screens inside Mesa, each with a
# rasteriser and its lock.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=lib.sh
source "$(dirname "$0")/lib.sh"
need g++
(($(nproc) >= 2)) || skip "one processor alone"
unpack_whole bookworm libgl1-mesa-dri=22.3.6-1+deb12u2 libegl-mesa0=22.3.6-1+deb12u2 libegl1 libopengl0 libegl-dev \
  libgl-dev
unpack_whole trixie libgl1-mesa-dri=25.0.7-2+deb13u1 libegl-mesa0=25.0.7-2+deb13u1 libegl1 libopengl0 libegl-dev libgl-dev

cat >"$work/two.cpp" <<'CPP'
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <thread>
#include <vector>

// A context of its own draws so many times into a picture of its own.
void draw(EGLDisplay display, int times) {
  eglBindAPI(EGL_OPENGL_API);
  const EGLint configured[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
  EGLConfig config;
  EGLint count = 0;
  const EGLint sized[] = {EGL_WIDTH, 1024, EGL_HEIGHT, 1024, EGL_NONE};
  if (!eglChooseConfig(display, configured, &config, 1, &count) || count == 0) std::exit(3);
  const EGLSurface surface = eglCreatePbufferSurface(display, config, sized);
  const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr);
  if (!eglMakeCurrent(display, surface, surface, context)) std::exit(4);
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  glColor4f(1, 0, 0, 0.01F);
  for (int i = 0; i < times; ++i) {
    for (int layer = 0; layer < 20; ++layer) glRectf(-1, -1, 1, 1);
    glFinish();
  }
  eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
}

double secondsOf(const std::vector<EGLDisplay>& displays, int times) {
  const auto begin = std::chrono::steady_clock::now();
  std::vector<std::thread> threads;
  for (EGLDisplay display : displays) threads.emplace_back(draw, display, times);
  for (std::thread& thread : threads) thread.join();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

int main() {
  const auto get = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
  const auto query = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
  EGLDeviceEXT device;
  EGLint count = 0;
  query(1, &device, &count);
  const EGLDisplay one = get(EGL_PLATFORM_DEVICE_EXT, device, nullptr);
  const EGLDisplay other = get(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
  if (one == other || !eglInitialize(one, nullptr, nullptr) || !eglInitialize(other, nullptr, nullptr)) return 2;
  secondsOf({one, other}, 2);
  double same = 1e9, apart = 1e9;
  for (int i = 0; i < 7; ++i) {
    same = std::min(same, secondsOf({one, one}, 20));
    apart = std::min(apart, secondsOf({one, other}, 20));
  }
  std::fprintf(stderr, "one display %.3f s, two displays %.3f s\n", same, apart);
  const char* answer = same > 1.4 * apart ? "yes" : "no";
  std::printf("two threads on one display take over 1.4 times as long as on two: %s\n", answer);
}
CPP
for suite in bookworm trixie; do
  root=$work/$suite/usr
  g++ -O2 -I "$root/include" "$work/two.cpp" -o "$work/two-$suite" "$root"/lib/x86_64-linux-gnu/lib{EGL.so.1,OpenGL.so.0} \
    -Wl,--allow-shlib-undefined
  LP_NUM_THREADS=0 MESA_SHADER_CACHE_DISABLE=true LIBGL_DRIVERS_PATH=$root/lib/x86_64-linux-gnu/dri \
    __EGL_VENDOR_LIBRARY_FILENAMES=$root/share/glvnd/egl_vendor.d/50_mesa.json \
    run_whole "$suite" "$work/two-$suite" >"$work/seen"
  expect "$work/seen" "$suite" <<'END'
two threads on one display take over 1.4 times as long as on two: yes
END
done
