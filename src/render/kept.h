#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <inkedge/backends.h>
#include <inkedge/camera.h>
#include <inkedge/scene.h>
#include <inkedge/settings.h>
#include <inkedge/stage_time.h>

#include "base/kept_files.h"
#include "base/later.h"
#include "gl/context.h"
#include "gl/function_inputs.h"
#include "gl/gpu.h"
#include "gl/upload.h"
#include "ink/brush.h"
#include "lines/object_lines.h"
#include "passes/frame.h"

namespace inkedge::render {

/// A context and what is kept in it from call to call.
class Graphics {
public:
    explicit Graphics(const BackendSettings&);
    ~Graphics();
    Graphics(const Graphics&) = delete;
    Graphics& operator=(const Graphics&) = delete;

    [[nodiscard]] gl::Context& context() const noexcept { return *context_; }
    [[nodiscard]] gl::Gpu& gpu() noexcept { return *gpu_; }
    [[nodiscard]] gl::FunctionInputs& inputs() noexcept { return *inputs_; }
    /// The frame of a whole picture, in samples. The upload of a scene is kept until another scene is drawn.
    [[nodiscard]] passes::Frame frame(const Scene&, const Camera&, const PictureSettings&);

private:
    std::unique_ptr<gl::Context> context_;
    std::unique_ptr<gl::Gpu> gpu_;
    std::unique_ptr<gl::UploadedScene> upload_;
    std::unique_ptr<gl::FunctionInputs> inputs_;
};

/// What a renderer keeps from call to call. Each is made when it is first asked for.
class Kept {
public:
    explicit Kept(BackendSettings backend) : settings_{std::move(backend)} {}

    /// Begins to make the context, in a thread of its own.
    void startGraphics();
    /// @param times  the time that making the context took, or waiting for it, is added
    [[nodiscard]] Graphics& graphics(std::vector<StageTime>& times);
    /// Empty while there is no context.
    [[nodiscard]] const BackendInfo& backend() const noexcept;
    /// The last scene that was asked for, made ready for its lines.
    [[nodiscard]] const lines::ObjectLines& objectLines(const Scene&);
    /// Null if the file has no name. Read once; another file of the same name is not looked for.
    [[nodiscard]] const ink::Brush* brush(const std::filesystem::path& file, const LoadLimits&);

private:
    BackendSettings settings_;
    std::optional<base::Later<std::unique_ptr<Graphics>>> coming_;  // of startGraphics(), until it is asked for
    std::unique_ptr<Graphics> graphics_;
    std::unique_ptr<lines::ObjectLines> objectLines_;
    base::KeptFiles<ink::Brush> brushes_;
};

}  // namespace inkedge::render
