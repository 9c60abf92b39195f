#include <vector>

#include <inkedge/renderer.h>
#include <inkedge/setting_table.h>

#include "base/forks.h"
#include "base/stop.h"
#include "render/expect_usable.h"
#include "render/kept.h"
#include "render/lines.h"
#include "render/picture.h"

namespace inkedge {

struct Renderer::State : render::Kept {
    using render::Kept::Kept;
};

Renderer::Renderer(const BackendSettings& settings, ContextTime when) : state_{std::make_unique<State>(settings)} {
    validate(settings);
    std::vector<StageTime> ignored;
    if (when == ContextTime::WhenNeeded) return;
    base::expectNoFork();
    if (when == ContextTime::AtOnce) (void)state_->graphics(ignored);
    if (when == ContextTime::Meanwhile) state_->startGraphics();
}
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;
Renderer::~Renderer() {
    if (base::isFork()) static_cast<void>(state_.release());  // the driver would wait for threads that are not there
}

const BackendInfo& Renderer::backend() const noexcept { return state_->backend(); }

Lines Renderer::lines(const Scene& scene, const Camera& wanted, const RenderSettings& settings,
                      const std::stop_token& stop) {
    base::expectNoFork();
    const base::StopScope scope{[&] { return stop.stop_requested(); }};
    validate(settings);
    render::expectLoaded(scene, settings, {.json = true});
    const Camera camera = withPlanes(wanted, scene);
    render::expectUsable(camera, scene);
    base::stopIfAsked();
    Lines lines = settings.lines.from == LinesFrom::Image ? render::imageLines(scene, camera, settings, *state_)
                                                          : render::objectLines(scene, camera, settings, *state_);
    if (settings.shade.shade != Shade::None)
        lines.shade = render::shadeOf(scene, camera, settings, *state_, lines.times);
    lines.backend = state_->backend();
    lines.warnings = renderWarnings(scene, settings);
    return lines;
}

Maps Renderer::render(const Scene& scene, const Camera& wanted, const RenderSettings& settings,
                      const std::stop_token& stop) {
    base::expectNoFork();
    const base::StopScope scope{[&] { return stop.stop_requested(); }};
    validate(settings);
    render::expectLoaded(scene, settings, {.pictures = true});
    const Camera camera = withPlanes(wanted, scene);
    render::expectUsable(camera, scene);
    render::expectMemory(settings);
    base::stopIfAsked();
    Maps maps = render::drawPicture(scene, camera, settings, *state_);
    maps.warnings = renderWarnings(scene, settings);
    return maps;
}

}  // namespace inkedge
