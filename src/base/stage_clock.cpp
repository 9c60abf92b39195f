#include "base/stage_clock.h"

#include <algorithm>
#include <string>

#include "base/stop.h"

namespace inkedge::base {

void StageClock::finish(std::string_view stage) {
    const double milliseconds = stage_.milliseconds();
    stage_ = {};
    auto time = std::ranges::find(times_, stage, &StageTime::stage);
    if (time == times_.end()) time = times_.insert(time, {std::string{stage}, 0.0});
    time->milliseconds += milliseconds;
    stopIfAsked();
}

}  // namespace inkedge::base
