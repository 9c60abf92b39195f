#include "gl/stage_clock.h"

#include <algorithm>

#include <fmt/format.h>

#include "gl/errors.h"

namespace inkedge::gl {

void StageClock::finish(const char* stage) {
    if (api_ != nullptr) {
        api_->Finish();
        checkErrors(*api_, fmt::format("the stage {}", stage), "ask for a smaller --size or --supersampling");
    }
    const auto now = std::chrono::steady_clock::now();
    auto time = std::ranges::find(times_, stage, &StageTime::stage);
    if (time == times_.end()) time = times_.insert(time, {stage, 0.0});
    time->milliseconds += std::chrono::duration<double, std::milli>(now - begin_).count();
    begin_ = now;
}

}  // namespace inkedge::gl
