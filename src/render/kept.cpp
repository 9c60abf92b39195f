#include "render/kept.h"

#include <sys/resource.h>

#include <thread>
#include <utility>

#include "base/thread_trial.h"
#include "gl/stage_clock.h"

namespace inkedge::render {
namespace {

// Whether a context can be made beside other work. Where memory or threads are short the two would take them from each
// other: the driver waits for ever for threads that it does not get, and writes lines of its own about memory.
bool hasRoomForBoth() {
    constexpr std::size_t othersThreads = 32;
    rlimit memory{};
    if (::getrlimit(RLIMIT_AS, &memory) != 0 || memory.rlim_cur != RLIM_INFINITY) return false;
    const std::size_t wanted = othersThreads + std::thread::hardware_concurrency();
    return base::startableThreads(wanted) == wanted;
}

}  // namespace

Graphics::Graphics(const BackendSettings& settings) : context_{gl::createContext(settings)} {
    const gl::Current current{*context_};
    gpu_ = std::make_unique<gl::Gpu>(context_->api());
    inputs_ = std::make_unique<gl::FunctionInputs>(context_->api());
}

Graphics::~Graphics() {
    const gl::Current current{*context_};
    inputs_.reset();
    upload_.reset();
    gpu_.reset();
}

passes::Frame Graphics::frame(const Scene& scene, const Camera& camera, const PictureSettings& picture) {
    if (!upload_ || !upload_->holds(scene)) {
        upload_.reset();  // before the next upload: never two scenes in graphics memory
        upload_ = std::make_unique<gl::UploadedScene>(gpu_->api, scene);
    }
    const Size samples{picture.size.width * picture.supersampling, picture.size.height * picture.supersampling};
    return passes::frameOf(*gpu_, *upload_, scene, camera, samples);
}

void Kept::startGraphics() {
    if (!hasRoomForBoth()) return;
    coming_.emplace([settings = settings_] { return std::make_unique<Graphics>(settings); },
                    base::elementsWorthAThread);
}

Graphics& Kept::graphics(std::vector<StageTime>& times) {
    if (!graphics_) {
        gl::StageClock clock{times};
        auto coming = std::exchange(coming_, std::nullopt);
        graphics_ = coming ? coming->take() : std::make_unique<Graphics>(settings_);
        clock.finish("context");
    }
    return *graphics_;
}

const BackendInfo& Kept::backend() const noexcept {
    static const BackendInfo none;
    return graphics_ ? graphics_->context().info() : none;
}

const lines::ObjectLines& Kept::objectLines(const Scene& scene) {
    if (!objectLines_ || !objectLines_->holds(scene)) {
        objectLines_.reset();
        objectLines_ = std::make_unique<lines::ObjectLines>(scene);
    }
    return *objectLines_;
}

const ink::Brush* Kept::brush(const std::filesystem::path& file, const LoadLimits& limits) {
    if (file.empty()) return nullptr;
    return &brushes_.of(file, [&] { return ink::readBrush(file, limits); });
}

}  // namespace inkedge::render
