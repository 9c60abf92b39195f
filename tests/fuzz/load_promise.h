#pragma once

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <span>

#include <inkedge/camera.h>
#include <inkedge/load_scene.h>
#include <inkedge/scene.h>

#include "base/temporary_folder.h"
#include "fuzz/promise.h"

namespace inkedge::fuzz {

/// For speed: what lies beyond is the business of tests/hostile.
inline LoadSettings smallLimits() {
    LoadSettings settings;
    settings.limits.decompressedSize = 1 << 26;
    settings.limits.vertices = 1 << 20;
    settings.limits.instances = 1 << 14;
    settings.limits.nodes = 1 << 18;
    settings.limits.imagePixels = 1 << 20;
    settings.limits.readingTime = 2.0;
    return settings;
}

/// A model gives a scene that can be framed, or an Error for it.
inline void loadAndFrame(const std::filesystem::path& model) {
    mayBeRefused([&] {
        const Scene scene = loadScene(model, smallLimits());
        for (const std::string& warning : scene.warnings())
            expect(warning.find('\n') == std::string::npos, "warnings of one line", warning);
        const Camera camera = frameCamera(scene, {}, {64, 64});
        expect(std::isfinite(camera.near) && std::isfinite(camera.far) && camera.near < camera.far,
               "a near plane before the far one", "none");
    });
}

/// Bytes as a model in one of some files: the first byte says in which, "0" the first one.
/// @return  as LLVMFuzzerTestOneInput()
inline int loadAndFrameAs(std::initializer_list<const char*> names, std::span<const std::uint8_t> bytes) {
    static const TemporaryFolder folder;
    if (bytes.empty()) return -1;
    const std::filesystem::path model = folder / names.begin()[bytes.front() % names.size()];
    write(model, bytes.subspan(1));
    loadAndFrame(model);
    return 0;
}

}  // namespace inkedge::fuzz
